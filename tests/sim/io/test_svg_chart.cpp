// Charts as SVG: round marks that cover the data, well-formed markup, text kept out of the markup,
// and all of it inside the picture.
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QRectF>
#include <QTest>
#include <QTransform>
#include <QXmlStreamReader>
#include <limits>

#include "sim/io/label_width.h"
#include "sim/io/svg_chart.h"

using namespace rotorbench;

namespace {

/// The widest of the usual faces; a reader may have any.
QFont pageFont(bool bold) {
  QFont font("DejaVu Sans");
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setPixelSize(12);
  font.setBold(bold);
  return font;
}

struct PlacedText {
  QString text;
  QRectF box;
};

/// Every text of the picture with the room it takes.
QList<PlacedText> placedTexts(const QString& svg, QRectF* view) {
  QList<PlacedText> found;
  QXmlStreamReader reader(svg);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const auto a = reader.attributes();
    if (reader.name() == QLatin1String("svg")) {
      const auto size = a.value("viewBox").toString().split(' ');
      *view = {0, 0, size[2].toDouble(), size[3].toDouble()};
    }
    if (reader.name() != QLatin1String("text")) continue;
    const QPointF at(a.value("x").toDouble(), a.value("y").toDouble());
    const QString anchor = a.value("text-anchor").toString();
    const bool turned = a.hasAttribute("transform"), bold = a.hasAttribute("font-weight");
    const QString text = reader.readElementText();
    const QFontMetricsF metrics(pageFont(bold));
    const double width = metrics.horizontalAdvance(text);
    const double before = anchor == "middle" ? width / 2 : anchor == "end" ? width : 0;
    const QRectF box(-before, -metrics.ascent(), width, metrics.height());
    const QTransform place = QTransform::fromTranslate(at.x(), at.y());
    found.append({text, (turned ? QTransform().rotate(-90) * place : place).mapRect(box)});
  }
  return found;
}

}  // namespace

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

  void labelsAreNeverWiderThanThought() {
    QVERIFY(QFontDatabase::families().contains("DejaVu Sans"));
    QStringList texts{"Thrust, N", "Größe, °", "Static thrust of the APC 10 x 4.7 (Slow Flyer)"};
    for (char c = ' '; c <= '~'; ++c) texts << QString(QChar(c));
    for (const bool bold : {false, true}) {
      const QFontMetricsF metrics(pageFont(bold));
      for (const QString& text : texts) {
        const double thought = labelWidth(text.toStdString(), 12, bold);
        QVERIFY2(metrics.horizontalAdvance(text) <= thought + 1e-9, qPrintable(text));
      }
    }
  }

  void textIsBrokenAndNothingLost_data() {
    QTest::addColumn<QString>("text");
    QTest::addRow("words") << "Map less blade elements, thrust with air from the side";
    QTest::addRow("one word") << "rotor1.thrust.of.a.very.long.name.without.any.space.at.all";
    QTest::addRow("not ASCII") << "ÄÖÜäöüßÄÖÜäöüßÄÖÜäöüßÄÖÜäöüßÄÖÜäöüßÄÖÜäöüß";
    QTest::addRow("empty") << "";
  }
  void textIsBrokenAndNothingLost() {
    QFETCH(QString, text);
    QString joined;
    const auto lines = wrappedLabel(text.toStdString(), 120, 12);
    QVERIFY(!lines.empty());
    for (const auto& line : lines) {
      QVERIFY(labelWidth(line, 12) <= 120);
      joined += QString::fromStdString(line);
    }
    QCOMPARE(joined.remove(' '), text.remove(' '));
  }

  /// Names, title and axes as long as those of real propellers, and numbers with many digits.
  void everythingIsInsideThePicture() {
    const std::string longName =
        "Blade elements with the measured section of the Clark Y at 500 000, Prandtl tip and root "
        "losses and the stall delay of Corrigan";
    SvgChart chart{longName, {longName, {}, {}}, {longName, {}, {}}, {}};
    chart.series = {{longName, SvgSeries::Style::Line, 0, {{-1e6, -1e5}, {2e6, 3e5}}},
                    {"measured", SvgSeries::Style::Points, 1, {{0, 0}}}};
    QRectF view;
    const auto texts = placedTexts(QString::fromStdString(svgChart(chart)), &view);
    QStringList words;
    for (const auto& [text, box] : texts) {
      QVERIFY2(view.contains(box), qPrintable(text));
      words << text.split(' ');
      for (const auto& [other, otherBox] : texts) {
        const bool same = text == other;
        const bool apart = !box.adjusted(1, 3, -1, -3).intersects(otherBox.adjusted(1, 3, -1, -3));
        QVERIFY2(same || apart, qPrintable(text + " | " + other));
      }
    }
    const QStringList wanted = QString::fromStdString(longName).split(' ');
    for (const QString& word : wanted)
      QVERIFY2(words.count(word) >= 4 * wanted.count(word), qPrintable(word));
  }

  void emptyChartIsAChart() {
    QXmlStreamReader reader(QString::fromStdString(svgChart({})));
    while (!reader.atEnd()) reader.readNext();
    QVERIFY(!reader.hasError());
  }
};

QTEST_MAIN(TestSvgChart)
#include "test_svg_chart.moc"
