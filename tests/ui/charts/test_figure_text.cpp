// No text of an exported figure is cut: every name of the legend, title and axis stands whole
// inside the figure, in every chart of every shipped experiment and every form a chart leaves the
// program in.
#include <QDirIterator>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "chart_fixture.h"
#include "placed_texts.h"
#include "sim/document/experiment_file.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/quick_map.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"
#include "ui/charts/figure_painter.h"
#include "ui/runs/run_colors.h"
#include "ui/shell/report.h"

using namespace rotorbench;
using fixture::Page;

namespace {

constexpr int kShortRun = 2000;  // ticks: enough for some rows of each recording

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList legendNames(const ChartPane& pane) {
  QStringList names;
  for (const Curve& curve : pane.curves().curves) names << curve.label;
  return names;
}

std::vector<ChartRun> chartRuns(const std::vector<RunOutput>& outputs, const QString& suffix = {}) {
  std::vector<ChartRun> runs;
  for (const auto& output : outputs) {
    const int i = static_cast<int>(runs.size());
    runs.push_back({QString::number(i) + suffix, QString::fromStdString(output.name) + suffix,
                    runColor(i), output.recording});
  }
  return runs;
}

/// Every name in one piece; every text inside the page and clear of the others.
void checkPage(const Page& page, QStringList wanted) {
  QVERIFY(page.box.width() > 100);
  const QString joined = page.joined();
  for (QString& name : wanted) {
    name = name.remove(u' ').normalized(QString::NormalizationForm_KC);
    QVERIFY2(joined.contains(name), qPrintable(name + " not in " + joined));
  }
  for (qsizetype i = 0; i < page.texts.size(); ++i) {
    const auto& [text, box, upright] = page.texts[i];
    QVERIFY2(page.box.adjusted(2, 0, -2, 0).contains(box), qPrintable("outside: " + text));
    for (qsizetype j = 0; j < i; ++j) {
      const QRectF common = box & page.texts[j].box;
      QVERIFY2(common.width() < 2 || common.height() < 0.4 * std::min(box.height(), box.width()),
               qPrintable(text + " over " + page.texts[j].text));
    }
  }
}

bool hasInk(const QImage& image, const QRectF& box) {
  const QRect pixels = box.toAlignedRect() & image.rect();
  for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
    for (int x = pixels.left(); x <= pixels.right(); ++x)
      if (qGray(image.pixel(x, y)) < 140) return true;
  }
  return false;
}

/// The picture has the texts of the drawing: ink at both ends of each, and none at the edge.
void checkPicture(const QImage& image, const Page& drawing) {
  const double scale = image.width() / drawing.box.width();
  QCOMPARE(image.height(), qRound(drawing.box.height() * scale));
  QVERIFY(!hasInk(image, {0, 0, 4, qreal(image.height())}));
  QVERIFY(!hasInk(image, {image.width() - 5.0, 0, 5, qreal(image.height())}));
  QVERIFY(!hasInk(image, {0, image.height() - 5.0, qreal(image.width()), 5}));
  const QTransform toPixels = QTransform::fromScale(scale, scale);
  for (const auto& [text, box, upright] : drawing.texts) {
    if (!upright) continue;
    QRectF end(box.left(), box.top(), std::min(10.0, box.width()), box.height());
    QVERIFY2(hasInk(image, toPixels.mapRect(end)), qPrintable(text));
    end.moveRight(box.right());
    QVERIFY2(hasInk(image, toPixels.mapRect(end)), qPrintable(text));
  }
}

/// Exports the chart in all forms and reads it back.
void checkFigure(const ChartPane& pane, const QDir& folder, bool onlyDrawing = false) {
  const QString title = QString::fromStdString(pane.spec().title);
  QStringList wanted = legendNames(pane);
  if (!title.isEmpty()) wanted << title;
  for (const char* form : {"svg", "pdf", "png"}) {
    if (onlyDrawing && form != std::string_view("svg")) continue;
    QCOMPARE(exportPane(pane, folder.filePath(QString("figure.") + form)), QString());
  }
  const Page drawing = fixture::svgPage(read(folder.filePath("figure.svg")));
  checkPage(drawing, wanted);
  if (QTest::currentTestFailed() || onlyDrawing) return;
  const Page page = fixture::pdfPage(folder.filePath("figure.pdf"));
  if (!page.texts.isEmpty()) checkPage(page, wanted);
  if (QTest::currentTestFailed()) return;
  checkPicture(QImage(folder.filePath("figure.png")), drawing);
}

struct LongNames {
  RunSet runs;
  ChartGrid grid{&runs};
  static constexpr const char* kChannel =
      "vehicle.rotor1.blade_elements.inflow.momentum_theory_with_tip_losses";
  explicit LongNames(int count) {
    const std::string name = kChannel;
    for (int i = 0; i < count; ++i) {
      auto recording = std::make_shared<Recording>(
          std::vector<Channel>{{"time", "s", ""}, {name, "m/s", ""}, {name + "_b", "N", ""}});
      for (const double t : {0.0, 0.5, 1.0}) recording->append(std::vector{t, t + i, t - i});
      recording->publish();
      recording->finish();
      runs.add(fixture::run(
          QString("%1 with a heavier battery and a propeller of eleven inches").arg(i + 1),
          recording, runColor(i)));
    }
    grid.setSpecs(
        {{"Induced velocity at the rotor and the thrust that comes of it, for a heavier "
          "battery, a longer arm and a propeller of eleven inches instead of ten",
          ChartKind::Time, "", "vehicle.rotor1.blade_elements.inflow.*", false, false, false}});
  }
  [[nodiscard]] const ChartPane& pane() const { return *grid.panes().front(); }
};

}  // namespace

class TestFigureText : public QObject {
  Q_OBJECT

 private slots:
  void shippedExperiments_data();
  void shippedExperiments();
  void overlaidRunsWithLongNames_data();
  void overlaidRunsWithLongNames();
  void longAxisTitles();
  void reportDrawsTheSameFigures();

 private:
  QTemporaryDir folder_;
};

void TestFigureText::shippedExperiments_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<bool>("twice");
  QDirIterator files(EXPERIMENTS_DIR, {"*.json"}, QDir::Files);
  while (files.hasNext()) {
    const QString file = files.next();
    const QByteArray name = QFileInfo(file).baseName().toUtf8();
    QTest::newRow(name) << file << false;
    QTest::newRow(name + ", two runs") << file << true;
  }
}

void TestFigureText::shippedExperiments() {
  QFETCH(QString, file);
  QFETCH(bool, twice);
  const Experiment experiment = test::withQuickMaps(loadExperiment(file.toStdString()));
  const auto simulation = buildSimulation(experiment, EXPERIMENTS_DIR);
  simulation->advance(kShortRun);
  RunSet set;
  auto runs = chartRuns(simulation->runs());
  QVERIFY(!runs.empty());
  if (twice) {
    for (auto& run : chartRuns(simulation->runs(), " again")) runs.push_back(std::move(run));
  }
  set.setRuns(std::move(runs));
  ChartGrid grid(&set);
  grid.setSpecs(experiment.outputs.charts);
  QVERIFY(!grid.panes().empty());
  for (const ChartPane* pane : grid.panes()) {
    checkFigure(*pane, folder_.path(), twice);  // a second run adds names, not forms
    if (QTest::currentTestFailed()) qWarning("in %s", pane->spec().title.c_str());
    if (QTest::currentTestFailed()) return;
  }
}

void TestFigureText::overlaidRunsWithLongNames_data() {
  QTest::addColumn<int>("count");
  for (const int count : {1, 4, 30}) QTest::addRow("%d", count) << count;
}

void TestFigureText::overlaidRunsWithLongNames() {
  QFETCH(int, count);
  const LongNames sheet(count);
  QCOMPARE(legendNames(sheet.pane()).size(), 2 * count);
  checkFigure(sheet.pane(), folder_.path());
  const QRectF plot = ChartFigure(sheet.pane()).plot();
  QVERIFY2(plot.width() >= 500 && plot.height() >= 300,
           qPrintable(QString("%1 x %2").arg(plot.width()).arg(plot.height())));
}

/// Of one channel the whole name stands at the axis.
void TestFigureText::longAxisTitles() {
  RunSet runs;
  const std::string name = std::string(LongNames::kChannel) + ".of.a.rotor.in.fast.forward.flight";
  auto recording =
      std::make_shared<Recording>(std::vector<Channel>{{name, "m/s", ""}, {name + "2", "N", ""}});
  for (const double t : {0.0, 0.5, 1.0}) recording->append(std::vector{t, 2 * t});
  recording->publish();
  recording->finish();
  runs.add(fixture::run("1", recording));
  ChartGrid grid(&runs);
  grid.setSpecs({{"", ChartKind::XY, name, name + "2", false, false, false}});
  checkFigure(*grid.panes().front(), folder_.path());
  const QString joined = fixture::svgPage(read(folder_.filePath("figure.svg"))).joined();
  for (const std::string& title : {name + "[m/s]", name + "2[N]"})
    QVERIFY2(joined.contains(QString::fromStdString(title)), qPrintable(joined));
}

void TestFigureText::reportDrawsTheSameFigures() {
  const Experiment experiment = loadExperiment(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  const auto simulation = buildSimulation(experiment, EXPERIMENTS_DIR);
  simulation->advance(kShortRun);
  const auto files =
      writeReportImages(experiment, simulation->runs(), folder_.filePath("report").toStdString());
  RunSet set;
  set.setRuns(chartRuns(simulation->runs()));
  ChartGrid grid(&set);
  grid.setSpecs(experiment.outputs.charts);
  QVERIFY(files.size() >= grid.panes().size());
  for (std::size_t i = 0; i < grid.panes().size(); ++i) {
    QCOMPARE(exportPane(*grid.panes()[i], folder_.filePath("one.png")), QString());
    QCOMPARE(QImage(QString::fromStdString(files[i].string())),
             QImage(folder_.filePath("one.png")));
  }
}

QTEST_MAIN(TestFigureText)
#include "test_figure_text.moc"
