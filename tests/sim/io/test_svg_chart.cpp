// Charts as SVG: round marks that cover the data, well-formed markup, text kept out of the markup.
#include <QTest>
#include <QXmlStreamReader>
#include <limits>

#include "sim/io/svg_chart.h"

using namespace rotorbench;

class TestSvgChart : public QObject {
  Q_OBJECT

 private slots:
  void ticksAreRoundAndCover_data() {
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("greatest");
    QTest::addColumn<QList<double>>("ticks");
    QTest::addRow("unit") << 0.0 << 1.0 << QList<double>{0, 0.2, 0.4, 0.6, 0.8, 1};
    QTest::addRow("between") << 3.0 << 47.0 << QList<double>{0, 10, 20, 30, 40, 50};
    QTest::addRow("signs") << -1.0 << 2.0 << QList<double>{-1, -0.5, 0, 0.5, 1, 1.5, 2};
    QTest::addRow("wrong way round") << 2.0 << -1.0 << QList<double>{-1, -0.5, 0, 0.5, 1, 1.5, 2};
    QTest::addRow("one value") << 4.0 << 4.0 << QList<double>{2, 3, 4, 5, 6};
    QTest::addRow("nothing") << std::numeric_limits<double>::quiet_NaN() << 1.0
                             << QList<double>{0, 1};
  }
  void ticksAreRoundAndCover() {
    QFETCH(double, least);
    QFETCH(double, greatest);
    QFETCH(QList<double>, ticks);
    const std::vector<double> found = axisTicks(least, greatest);
    QCOMPARE(qsizetype(found.size()), ticks.size());
    for (qsizetype i = 0; i < ticks.size(); ++i) {
      QVERIFY(std::abs(found[static_cast<std::size_t>(i)] - ticks[i]) < 1e-9);
    }
  }

  /// A gap in a line, a series without points, names that look like markup.
  void chartIsWellFormed() {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    SvgChart chart{"<T> & \"P\"", {"Speed, rpm", {}, {}}, {"Thrust, N", {}, {}}, {}};
    chart.series = {{"a<b", SvgSeries::Style::Line, 0, {{0, 1}, {gap, 0}, {1, 2}, {2, 3}}},
                    {"points", SvgSeries::Style::Points, 9, {{0, 1}, {2, 2}}},
                    {"empty", SvgSeries::Style::Dashed, 2, {}}};
    const QString svg = QString::fromStdString(svgChart(chart));
    QXmlStreamReader reader(svg);
    QStringList texts;
    int circles = 0;
    while (!reader.atEnd()) {
      reader.readNext();
      if (reader.isCharacters() && !reader.isWhitespace()) texts << reader.text().toString();
      circles += reader.isStartElement() && reader.name() == QLatin1String("circle") ? 1 : 0;
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    for (const char* text : {"<T> & \"P\"", "Speed, rpm", "Thrust, N", "a<b", "points"}) {
      QVERIFY2(texts.contains(text), text);
    }
    QVERIFY(!texts.contains("empty"));
    QCOMPARE(circles, 3);  // two points and the legend's
    QVERIFY(!svg.contains("nan"));
  }

  void emptyChartIsAChart() {
    QXmlStreamReader reader(QString::fromStdString(svgChart({})));
    while (!reader.atEnd()) reader.readNext();
    QVERIFY(!reader.hasError());
  }
};

QTEST_APPLESS_MAIN(TestSvgChart)
#include "test_svg_chart.moc"
