// The window as a person uses it, with real simulations: from the start page to exported figures.
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QProcess>
#include <QTreeWidget>

#include "sim/document/experiment_file.h"
#include "sim/run/simulation.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"
#include "ui/forms/problems_panel.h"
#include "ui/scene/scene_panel.h"
#include "ui/shell/report.h"
#include "ui/shell/status_bar.h"

using namespace rotorbench;

namespace {

const QString kFlagship = "f450-hover-and-steps";
const QString kRollGain = "setup.control.controller.roll.kp";

std::size_t rowsOf(const MainWindow& window, int run) {
  const RunRecord* record = const_cast<MainWindow&>(window).runs().find(run);
  return record == nullptr || record->status.outputs.empty()
             ? 0
             : record->status.outputs.front().recording->rows();
}

double rollGain(MainWindow& window) {
  return std::get<double>(window.documents().model().get(kRollGain));
}

/// Lines of the table behind a chart: what it has taken in so far.
qsizetype chartLines(MainWindow& window, std::size_t pane) {
  return paneCsv(*window.workbench().charts().panes().at(pane)).count('\n');
}

QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Exports through the dialog; the format is chosen by its ending.
void exportTo(MainWindow& window, const QString& what, const QString& ending, const QString& path) {
  clickAction(window, "actionExport");
  QDialog* dialog = nullptr;
  QTRY_VERIFY((dialog = window.findChild<QDialog*>("exportDialog")) != nullptr &&
              dialog->isVisible());
  auto* whatBox = dialog->findChild<QComboBox*>("exportWhat");
  const int item = whatBox->findText(what, Qt::MatchStartsWith);
  QVERIFY2(item >= 0, qPrintable(what));
  whatBox->setCurrentIndex(item);
  auto* formatBox = dialog->findChild<QComboBox*>("exportFormat");
  formatBox->setCurrentIndex(formatBox->findData(ending));
  auto* target = dialog->findChild<QLineEdit*>("exportTarget");
  target->selectAll();
  QTest::keyClicks(target, path);
  QTest::mouseClick(dialog->findChild<QPushButton*>("exportButton"), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(
      dialog->findChild<QLabel*>("exportMessage")->text().startsWith("Written"), 60000);
  dialog->close();
  QTRY_VERIFY(window.findChild<QDialog*>("exportDialog") == nullptr);
}

}  // namespace

class TestWindow : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void cleanup();
  void fromGalleryToExport();
  void invalidValueBlocksRun();
  void fallingVehicle();
  void closedDuringRun();
  void singleStepFromTheStart();
  void chartEditsAreUndoable();
  void cursorMovesTheScene();
  void solverComparisonShowsEachMethod();
  void sameBytesAsCommandLine();
  void layoutIsRemembered();
  void resetLayoutBringsPanelsBack();
  void themes();
  void germanLocale();
  void everythingHasANameForScreenReaders();
  void reportImages();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestWindow::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  QVERIFY(folder_->isValid());
  useSettingsIn(folder_->path());
  QLocale::setDefault(QLocale::c());
}

void TestWindow::cleanup() {
  QVERIFY(QApplication::topLevelWidgets().isEmpty() ||
          std::ranges::none_of(QApplication::topLevelWidgets(), [](const QWidget* w) {
            return w->inherits("rotorbench::MainWindow");
          }));
}

void TestWindow::fromGalleryToExport() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  QVERIFY(window.windowTitle().contains("F450"));
  QCOMPARE(window.workbench().charts().panes().size(), std::size_t{7});

  choosePace(window, "10 ×");
  clickAction(window, "actionRun");
  QTRY_COMPARE(window.controller().state(), RunState::Running);
  QTRY_VERIFY(chartLines(window, 0) > 50);
  const qsizetype before = chartLines(window, 0);
  QTRY_VERIFY(chartLines(window, 0) > before + 50);
  QCOMPARE(window.controller().state(), RunState::Running);

  clickAction(window, "actionPause");
  QTRY_COMPARE(window.controller().state(), RunState::Paused);
  const std::size_t paused = rowsOf(window, 1);
  QVERIFY(paused < 40000);

  const double gain = rollGain(window);
  typeInto(window, kRollGain, "60");
  QTRY_COMPARE(rollGain(window), 60.0);
  QTRY_VERIFY(window.runs().index(0).data(RunList::OutOfDateRole).toBool());
  clickAction(window, "actionUndo");
  QTRY_COMPARE(rollGain(window), gain);
  QTRY_VERIFY(!window.runs().index(0).data(RunList::OutOfDateRole).toBool());
  // The paused run has been told both.
  QTRY_COMPARE(window.runs().find(1)->status.changes->size(), std::size_t{2});
  clickAction(window, "actionRedo");
  QTRY_COMPARE(rollGain(window), 60.0);
  QCOMPARE(rowsOf(window, 1), paused);

  clickAction(window, "actionStop");
  QTRY_COMPARE(window.controller().state(), RunState::Stopped);
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  QCOMPARE(window.runs().records().size(), std::size_t{2});
  QVERIFY(rowsOf(window, 2) >= 40000);

  // Both runs are in the chart, in colours that differ.
  const ChartPane& pane = *window.workbench().charts().panes().front();
  QSet<QRgb> colors;
  for (const ChartRun& run : pane.runs().runs()) {
    QVERIFY(run.visible);
    colors.insert(run.color.rgb());
  }
  QCOMPARE(colors.size(), 2);

  const QDir out(folder_->path());
  exportTo(window, "Chart 1", "png", out.filePath("thrust.png"));
  const QImage png(out.filePath("thrust.png"));
  QVERIFY(png.width() >= 800 && png.height() >= 400);
  exportTo(window, "Chart 1", "svg", out.filePath("thrust.svg"));
  const QByteArray svg = contents(out.filePath("thrust.svg"));
  QVERIFY(svg.startsWith("<?xml") && svg.contains("Thrust") && svg.contains("<text"));
  exportTo(window, "Chart 1", "pdf", out.filePath("thrust.pdf"));
  QVERIFY(contents(out.filePath("thrust.pdf")).startsWith("%PDF"));
  exportTo(window, "Chart 1", "csv", out.filePath("thrust.csv"));
  const QByteArray csv = contents(out.filePath("thrust.csv"));
  QVERIFY2(csv.left(csv.indexOf('\n')).contains("rotor1.thrust [N]"), csv.left(200).constData());
  QVERIFY(csv.count('\n') > 30000);
}

void TestWindow::invalidValueBlocksRun() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  typeInto(window, "setup.duration", "-5 s");
  QTRY_VERIFY(window.documents().model().hasErrors());
  QTRY_COMPARE(window.findChild<QToolButton*>("problemCount")->text(), QString("1 problem"));

  clickAction(window, "actionRun");
  QVERIFY(window.runs().records().empty());
  auto* list = window.findChild<QTreeWidget*>("problems");
  QTRY_VERIFY(list->isVisible());
  const auto* first = list->topLevelItem(0);
  QString sentence;
  for (int column = 0; column < list->columnCount(); ++column)
    sentence += first->text(column) + ' ';
  QVERIFY2(sentence.contains("Must be above 0 and at most 36000 s"), qPrintable(sentence));

  window.workbench().experiment().showSection("outputs");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(first).center());
  QTRY_VERIFY(window.findChild<QLineEdit*>("setup.duration") != nullptr &&
              window.findChild<QLineEdit*>("setup.duration")->isVisible());

  typeInto(window, "setup.duration", "1 s");
  QTRY_VERIFY(!window.documents().model().hasErrors());
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE(window.controller().state(), RunState::Finished);
}

/// A vehicle that cannot lift itself: warned of while it is edited, and the run's end says what it
/// came to.
void TestWindow::fallingVehicle() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  auto* count = window.findChild<QToolButton*>("problemCount");
  QCOMPARE(count->text(), QString("No problems"));
  typeInto(window, "setup.vehicle.mass.mass", "6.4 kg");
  typeInto(window, "setup.duration", "5 s");
  QTRY_COMPARE(count->text(), QString("2 warnings"));
  auto* list = window.findChild<QTreeWidget*>("problems");
  QCOMPARE(list->topLevelItemCount(), 2);
  const QString said = list->topLevelItem(0)->text(1);
  QVERIFY2(said.contains("cannot hold the vehicle in a hover", Qt::CaseInsensitive),
           qPrintable(said));
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  const QString status = window.findChild<QLabel*>("runStatus")->text();
  QVERIFY2(status.startsWith("Finished: ") && status.contains(" at "), qPrintable(status));
  const QString detail = window.runs().index(0).data(RunList::DetailRole).toString();
  QVERIFY2(detail.startsWith("Finished: ") && detail.contains(" at "), qPrintable(detail));
  const QString tip = window.runs().index(0).data(Qt::ToolTipRole).toString();
  QVERIFY2(tip.contains("below the ground at "), qPrintable(tip));
  auto* metrics = window.findChild<QTableWidget*>("metricsTable");
  QVERIFY(!metrics->findItems("below ground", Qt::MatchExactly).empty());
  // Sound again: the list is empty and the count says so.
  typeInto(window, "setup.vehicle.mass.mass", "1.4 kg");
  QTRY_COMPARE(count->text(), QString("No problems"));
}

void TestWindow::closedDuringRun() {
  auto window = std::make_unique<MainWindow>();
  showWindow(*window);
  openCard(*window, kFlagship);
  choosePace(*window, "Real time");
  clickAction(*window, "actionRun");
  QTRY_VERIFY(rowsOf(*window, 1) > 100);
  const auto recording = window->runs().find(1)->status.outputs.front().recording;
  QElapsedTimer clock;
  clock.start();
  QVERIFY(window->close());
  QVERIFY(recording->finished());
  window.reset();
  QVERIFY2(clock.elapsed() < 3000, qPrintable(QString::number(clock.elapsed())));
}

void TestWindow::singleStepFromTheStart() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  clickAction(window, "actionStep");
  QTRY_COMPARE(window.controller().state(), RunState::Paused);
  QTRY_VERIFY(rowsOf(window, 1) > 0);
  const std::size_t rows = rowsOf(window, 1);
  clickAction(window, "actionStep");
  QTRY_COMPARE(rowsOf(window, 1), rows + 1);
}

void TestWindow::chartEditsAreUndoable() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  ChartGrid& charts = window.workbench().charts();
  const auto specs = charts.specs();
  charts.panes().front()->addChannel("position.z");
  QTRY_VERIFY(window.documents().experiment().outputs.charts != specs);
  QVERIFY(window.isWindowModified());
  clickAction(window, "actionUndo");
  QTRY_VERIFY(charts.specs() == specs);
  QVERIFY(!window.isWindowModified());
}

void TestWindow::cursorMovesTheScene() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  Workbench& bench = window.workbench();
  bench.charts().link()->moveCursor(Cursor::A, 9.5);
  QTRY_COMPARE(bench.scene().time(), 9.5);
  bench.scene().setTime(12.25);
  QTRY_COMPARE(bench.charts().link()->cursor(Cursor::A).value_or(0), 12.25);
}

void TestWindow::solverComparisonShowsEachMethod() {
  MainWindow window;
  showWindow(window);
  openCard(window, "thesis-experiment-1");
  QVERIFY(!window.findChild<QComboBox*>("paceBox")->isEnabled());
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 120000);
  const RunRecord& record = *window.runs().find(1);
  QStringList methods;
  for (const MetricRow& row : record.status.metrics) methods << QString::fromStdString(row.run);
  for (const char* method : {"Euler", "RK4", "ABM4", "RK5(4)7M", "RK5(4)6M", "RK5(4)7S"}) {
    QVERIFY2(methods.contains(method), method);
  }
  auto* table = window.findChild<QTableWidget*>("metricsTable");
  QCOMPARE(table->columnCount(), static_cast<int>(record.status.metrics.size()) + 2);
}

// The CSV of a run is the same whether a button or the command line made it.
void TestWindow::sameBytesAsCommandLine() {
  const QString file = QString(EXPERIMENTS_DIR) + '/' + kFlagship + ".json";
  const QDir out(folder_->path());
  QProcess cli;
  cli.start(ROTORBENCH_CLI,
            {"run", file, "--set", "setup.duration=3 s", "--output", out.filePath("cli")});
  QVERIFY(cli.waitForFinished(120000));
  QCOMPARE(cli.exitCode(), 0);

  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  typeInto(window, "setup.duration", "3 s");
  choosePace(window, "10 ×");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  exportTo(window, "Recording and metrics", "csv", out.filePath("window"));
  const QByteArray csv = contents(out.filePath("window/recording.csv"));
  QVERIFY(csv.count('\n') > 3000);
  QVERIFY(csv == contents(out.filePath("cli/recording.csv")));
}

void TestWindow::layoutIsRemembered() {
  const auto runsDock = [](MainWindow& window) {
    return window.findChild<QDockWidget*>("dock:runsPanel");
  };
  {
    MainWindow window;
    showWindow(window);
    openCard(window, kFlagship);
    runsDock(window)->setFloating(true);
    QVERIFY(window.close());
  }
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  QTRY_VERIFY(runsDock(window)->isFloating());
}

void TestWindow::resetLayoutBringsPanelsBack() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  auto* dock = window.findChild<QDockWidget*>("dock:scenePanel");
  dock->close();
  QVERIFY(!dock->isVisible());
  window.findChild<QAction*>("actionResetLayout")->trigger();
  QTRY_VERIFY(dock->isVisible());
}

void TestWindow::themes() {
  MainWindow window;
  showWindow(window);
  window.findChild<QAction*>("theme:dark")->trigger();
  QTRY_VERIFY(window.palette().color(QPalette::Window).lightness() < 80);
  window.findChild<QAction*>("theme:light")->trigger();
  QTRY_VERIFY(window.palette().color(QPalette::Window).lightness() > 180);
  QVERIFY(!window.findChild<QAction*>("actionRun")->icon().isNull());
  window.findChild<QAction*>("theme:system")->trigger();
}

void TestWindow::germanLocale() {
  QLocale::setDefault(QLocale(QLocale::German));
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  typeInto(window, "setup.duration", "2,5 s");
  QTRY_COMPARE(std::get<double>(window.documents().model().get("setup.duration")), 2.5);
  typeInto(window, "setup.duration", "1.25 s");
  QTRY_COMPARE(std::get<double>(window.documents().model().get("setup.duration")), 1.25);
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE(window.controller().state(), RunState::Finished);
  QVERIFY(window.runs().index(0).data(RunList::DetailRole).toString().contains("1,25 s"));
  const QString file = folder_->filePath("german.json");
  window.documents().save(file);
  QVERIFY(contents(file).contains("1.25"));
}

void TestWindow::everythingHasANameForScreenReaders() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  for (const char* name : {"runsPanel", "runsView", "metricsPanel", "logPanel", "paceBox",
                           "metricsTable", "runStatus", "runProgress"}) {
    const auto* widget = window.findChild<QWidget*>(name);
    QVERIFY2(widget != nullptr, name);
    QVERIFY2(!widget->accessibleName().isEmpty(), name);
  }
}

void TestWindow::reportImages() {
  const Experiment experiment =
      loadExperiment((QString(EXPERIMENTS_DIR) + '/' + kFlagship + ".json").toStdString());
  const auto simulation = buildSimulation(experiment);
  simulation->advance(5000);
  simulation->stop();
  const auto files =
      writeReportImages(experiment, simulation->runs(), folder_->filePath("report").toStdString());
  QCOMPARE(files.size(), experiment.outputs.charts.size() + 1);
  for (const auto& file : files) {
    const QImage image(QString::fromStdString(file.string()));
    QVERIFY2(image.width() >= 800, file.c_str());
    QSet<QRgb> colors;
    for (int x = 0; x < image.width(); x += 7) {
      for (int y = 0; y < image.height(); y += 7) colors.insert(image.pixel(x, y));
    }
    QVERIFY2(colors.size() > 3, file.c_str());
  }
}

QTEST_MAIN(TestWindow)
#include "test_window.moc"
