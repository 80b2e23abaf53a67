// Charts leaving the program: each file is opened again and read.
#include <QApplication>
#include <QClipboard>
#include <QImageReader>
#include <QMimeData>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "chart_fixture.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"

using namespace rotorbench;

namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// All texts of an SVG file, in order.
QStringList svgTexts(const QByteArray& bytes, bool* wellFormed) {
  QStringList texts;
  QXmlStreamReader xml(bytes);
  bool inText = false;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement()) inText = xml.name() == QLatin1String("text");
    if (xml.isCharacters() && inText && !xml.isWhitespace())
      texts += xml.text().toString().trimmed();
  }
  *wellFormed = !xml.hasError();
  return texts;
}

struct Sheet {
  RunSet runs;
  ChartGrid grid{&runs};
  QTemporaryDir folder;
  explicit Sheet(int rows = 101) {
    runs.add(fixture::run("1", fixture::ramp(rows)));
    grid.setSpecs({{"Thrust of two rotors", ChartKind::Time, "", "rotor1.thrust, rotor2.thrust",
                    false, false, false},
                   {"Error", ChartKind::Time, "", "error", false, true, false}});
    grid.resize(900, 700);
  }
  [[nodiscard]] ChartPane& pane() { return *grid.panes()[0]; }
  [[nodiscard]] QString path(const QString& name) const { return folder.filePath(name); }
};

}  // namespace

class TestChartExport : public QObject {
  Q_OBJECT

 private slots:
  void png();
  void curvesAreThereAgainAndAgain_data();
  void curvesAreThereAgainAndAgain();
  void svgHasTitleUnitsAndLegend();
  void pdfHasTheText();
  void csvOfTheVisibleRange();
  void csvOfSeveralRuns();
  void csvLeavesHiddenCurvesOut();
  void germanLocaleWritesPoints();
  void allPanes();
  void clipboardTakesPictureAndTable();
  void badPathsAreExplained_data();
  void badPathsAreExplained();
};

void TestChartExport::png() {
  Sheet s;
  QCOMPARE(exportPane(s.pane(), s.path("a.png")), QString());
  const QImage image(s.path("a.png"));
  QVERIFY(image.width() >= 1600);
  QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));  // light, whatever the window looks like
  int blue = 0;
  for (int y = 0; y < image.height(); y += 2) {
    for (int x = 0; x < image.width(); x += 2)
      blue += image.pixelColor(x, y) == QColor(0, 114, 178);
  }
  QVERIFY2(blue > 500, qPrintable(QString::number(blue)));  // the curve of rotor 1
}

void TestChartExport::curvesAreThereAgainAndAgain_data() {
  QTest::addColumn<bool>("xy");
  QTest::addRow("over time") << false;
  QTest::addRow("one over another") << true;
}

/// A chart that has been on show, exported twice: what was read before is not missing then.
void TestChartExport::curvesAreThereAgainAndAgain() {
  QFETCH(bool, xy);
  Sheet s;
  s.pane().setSpec({"", xy ? ChartKind::XY : ChartKind::Time, xy ? "error" : "", "rotor1.thrust",
                    false, false, false});
  s.pane().refresh();
  for (int time = 0; time < 2; ++time) {
    const ChartFrame frame = s.pane().frameFor({600, 400}, 2, QLocale::c());
    QVERIFY2(frame.curves.front().points.size() > 50, "points of the figure");
    QCOMPARE(exportPane(s.pane(), s.path("a.svg")), QString());
    const QByteArray drawing = read(s.path("a.svg"));
    QCOMPARE(drawing.count("#0072b2") >= 2, true);  // the curve and its sample in the legend
  }
}

void TestChartExport::svgHasTitleUnitsAndLegend() {
  Sheet s;
  QCOMPARE(exportPane(s.pane(), s.path("a.svg")), QString());
  bool wellFormed = false;
  const QByteArray bytes = read(s.path("a.svg"));
  const QStringList texts = svgTexts(bytes, &wellFormed);
  QVERIFY(wellFormed);
  for (const char* text :
       {"Thrust of two rotors", "time [s]", "thrust [N]", "rotor1.thrust", "rotor2.thrust", "10"}) {
    QVERIFY2(texts.contains(QLatin1String(text)), qPrintable(texts.join('|')));
  }
  QVERIFY(!bytes.contains("<image"));
  QVERIFY(bytes.contains("#0072b2"));  // the curve of rotor 1
  QVERIFY(bytes.count("<polyline") + bytes.count("<path") > 20);
}

void TestChartExport::pdfHasTheText() {
  Sheet s;
  QCOMPARE(exportPane(s.pane(), s.path("a.pdf")), QString());
  const QByteArray bytes = read(s.path("a.pdf"));
  QVERIFY(bytes.startsWith("%PDF-1."));
  QVERIFY(bytes.trimmed().endsWith("%%EOF"));
  QVERIFY(bytes.contains("/Font"));
  QVERIFY(!bytes.contains("/Subtype /Image"));
  QVERIFY(bytes.contains("/MediaBox"));
  const QString tool = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
  if (tool.isEmpty()) return;  // the structure above stays checked
  QProcess process;
  process.start(tool, {s.path("a.pdf"), QStringLiteral("-")});
  QVERIFY(process.waitForFinished());
  const QString text = QString::fromUtf8(process.readAllStandardOutput());
  for (const char* word : {"Thrust of two rotors", "time [s]", "rotor1.thrust", "rotor2.thrust"}) {
    QVERIFY2(text.contains(QLatin1String(word)), qPrintable(text));
  }
}

void TestChartExport::csvOfTheVisibleRange() {
  Sheet s;  // samples every 0.1 s
  s.pane().setView({Span{2, 3}, {}});
  QCOMPARE(exportPane(s.pane(), s.path("a.csv")), QString());
  const auto lines = read(s.path("a.csv")).trimmed().split('\n');
  QCOMPARE(lines[0], QByteArray("time [s],rotor1.thrust [N],rotor2.thrust [N]"));
  QCOMPARE(lines.size(), 1 + 11);
  QCOMPARE(lines[1], QByteArray("2,3,4"));
  QCOMPARE(lines[6], QByteArray("2.5,3.5,4.5"));
  QCOMPARE(lines[11], QByteArray("3,4,5"));
}

void TestChartExport::csvOfSeveralRuns() {
  Sheet s(11);
  s.runs.add(fixture::run("2, again", fixture::ramp(6, 5)));
  const auto lines = paneCsv(s.pane()).trimmed().split('\n');
  QCOMPARE(lines[0],
           QStringLiteral("Run 1: time [s],Run 1: rotor1.thrust [N],Run 1: rotor2.thrust [N],"
                          "\"Run 2, again: time [s]\",\"Run 2, again: rotor1.thrust [N]\","
                          "\"Run 2, again: rotor2.thrust [N]\""));
  QCOMPARE(lines.size(), 12);
  QCOMPARE(lines[2], QStringLiteral("1,2,3,1,2,3"));
  QCOMPARE(lines[11], QStringLiteral("10,11,12,,,"));
}

void TestChartExport::csvLeavesHiddenCurvesOut() {
  Sheet s;
  s.grid.show();
  QTest::mouseClick(s.pane().findChild<QWidget*>("legend:rotor1.thrust"), Qt::LeftButton);
  QVERIFY(paneCsv(s.pane()).startsWith("time [s],rotor2.thrust [N]\n"));
}

void TestChartExport::germanLocaleWritesPoints() {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  Sheet s;
  s.grid.panes()[1]->setSpec({"Error", ChartKind::Time, "", "error", false, false, false});
  QCOMPARE(exportPane(*s.grid.panes()[1], s.path("a.svg")), QString());
  const QString csv = paneCsv(s.pane());
  QLocale::setDefault(before);
  bool wellFormed = false;
  const QStringList texts = svgTexts(read(s.path("a.svg")), &wellFormed);
  QVERIFY2(texts.contains("0.2"), qPrintable(texts.join('|')));
  QVERIFY(csv.contains("\n0.1,1.1,2.1\n"));
}

void TestChartExport::allPanes() {
  Sheet s;
  QCOMPARE(exportAllPanes(s.grid, s.path("out"), FigureFormat::Svg), QString());
  QCOMPARE(QDir(s.path("out")).entryList(QDir::Files),
           (QStringList{"1-thrust-of-two-rotors.svg", "2-error.svg"}));
  bool wellFormed = false;
  const QStringList texts = svgTexts(read(s.path("out/2-error.svg")), &wellFormed);
  QVERIFY(texts.contains("error [m]"));
  QVERIFY2(texts.contains("10⁻⁴"), qPrintable(texts.join('|')));
}

void TestChartExport::clipboardTakesPictureAndTable() {
  Sheet s;
  QCOMPARE(copyPane(s.pane()), QStringLiteral("The chart and its table were copied."));
  const QMimeData* data = QApplication::clipboard()->mimeData();
  QVERIFY(data->hasImage());
  QVERIFY(data->text().startsWith("time [s],rotor1.thrust [N]"));
  Sheet large(200001);
  QVERIFY(copyPane(large.pane()).contains("too long"));
  QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
  QVERIFY(QApplication::clipboard()->mimeData()->text().isEmpty());
}

void TestChartExport::badPathsAreExplained_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("says");
  QTest::addRow("no such folder") << "missing/a.png"
                                  << "could not be saved as";
  QTest::addRow("unknown ending") << "a.bmp"
                                  << "must end in .png, .svg, .pdf or .csv";
  QTest::addRow("no ending") << "chart"
                             << "must end in";
}

void TestChartExport::badPathsAreExplained() {
  QFETCH(QString, name);
  QFETCH(QString, says);
  Sheet s;
  const QString error = exportPane(s.pane(), s.path(name));
  QVERIFY2(error.contains(says), qPrintable(error));
  QVERIFY(!QFile::exists(s.path(name)));
}

QTEST_MAIN(TestChartExport)
#include "test_chart_export.moc"
