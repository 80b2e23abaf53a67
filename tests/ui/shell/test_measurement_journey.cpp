// One sitting with measured data in the real window: a published log of a thrust stand is imported,
// mapped, seen on a chart beside the run of the same stand, compared, fitted to, saved as a
// component, and picked in the experiment. At each step what a person reads is read.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QTreeWidget>
#include <cmath>
#include <numbers>

#include "sim/document/experiment.h"
#include "sim/document/thrust_stand.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"
#include "ui/library/component_info_dialog.h"
#include "ui/library/library_dialog.h"
#include "ui/measurement/fit_dialog.h"
#include "ui/measurement/import_dialog.h"
#include "ui/measurement/mapping_table.h"
#include "ui/measurement/residuals_dialog.h"
#include "ui/shell/status_bar.h"

using namespace rotorbench;

namespace {

constexpr double kRpm = std::numbers::pi / 30;
const QString kLog = QStringLiteral(TEST_DATA_DIR "/measurement/x2216_10x4.7.csv");
const QString kName = "X2216 on the stand";

/// Tools menu, then the entry, by the mouse.
template <class Dialog>
Dialog* openTool(MainWindow& window, const char* name) {
  auto* menu = window.findChild<QMenu*>("menuTools");
  auto* action = window.findChild<QAction*>(name);
  if (menu == nullptr || action == nullptr) return nullptr;
  QMenuBar* bar = window.menuBar();
  QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu->menuAction()).center());
  if (!QTest::qWaitFor([&] { return menu->isVisible(); })) return nullptr;
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
  Dialog* dialog = nullptr;
  const bool came = QTest::qWaitFor([&] {
    dialog = window.findChild<Dialog*>();
    return dialog != nullptr && dialog->isVisible();
  });
  return came ? dialog : nullptr;
}

void choose(QWidget* dialog, const char* name, const QString& text) {
  auto* box = dialog->findChild<QComboBox*>(name);
  QVERIFY2(box != nullptr, name);
  const int index = box->findText(text);
  QVERIFY2(index >= 0, qPrintable(text));
  box->setCurrentIndex(index);
  emit box->activated(index);
}

void type(QWidget* dialog, const char* name, const QString& text) {
  auto* edit = dialog->findChild<QLineEdit*>(name);
  QVERIFY2(edit != nullptr, name);
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, text);
}

void click(QWidget* dialog, const char* name) {
  auto* button = dialog->findChild<QPushButton*>(name);
  QVERIFY2(button != nullptr && button->isEnabled(), name);
  QTest::mouseClick(button, Qt::LeftButton);
}

/// The text in the row of a table that begins with these words.
QString cell(const QTableWidget& table, const QString& first, int column) {
  for (int row = 0; row < table.rowCount(); ++row) {
    if (table.item(row, 0)->text().startsWith(first)) return table.item(row, column)->text();
  }
  return {};
}

const ChartPane* paneTitled(MainWindow& window, const QString& title) {
  for (const ChartPane* pane : window.workbench().charts().panes()) {
    if (QString::fromStdString(pane->spec().title) == title) return pane;
  }
  return nullptr;
}

MotorParameters motorOf(MainWindow& window) {
  return alternative<ThrustStand>(window.documents().model().as<Experiment>().setup).stand.motor;
}

}  // namespace

class TestMeasurementJourney : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void standFromLogToExperiment();
  void propellerFromTableToExperiment();
  void savedPropellerFlies();

 private:
  void importStand(MainWindow& window);
  void overlay(MainWindow& window, const QString& chart, const QString& name);
  void residuals(MainWindow& window);
  void fitAndSave(MainWindow& window);
  void pick(MainWindow& window, const QString& path, const QString& name);

  QTemporaryDir folder_;
};

void TestMeasurementJourney::initTestCase() {
  useSettingsIn(folder_.path());
  QLocale::setDefault(QLocale::c());
}

void TestMeasurementJourney::standFromLogToExperiment() {
  MainWindow window;
  showWindow(window);
  openCard(window, "thrust-stand-x2216");
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  importStand(window);
  overlay(window, "Thrust over throttle", kName);
  residuals(window);
  fitAndSave(window);
  QVERIFY(motorOf(window).speedConstant == 1100 * kRpm);  // saved, not yet used
  pick(window, "setup.stand.motor", "X2216 fitted");
  const double fitted = motorOf(window).speedConstant / kRpm;
  QVERIFY2(fitted != 1100 && std::abs(fitted / 1100 - 1) < 0.1,
           qPrintable(QString::number(fitted)));
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
}

void TestMeasurementJourney::importStand(MainWindow& window) {
  auto* dialog = openTool<ImportDialog>(window, "toolImport");
  QVERIFY(dialog != nullptr);
  type(dialog, "importFile", kLog);
  QTest::keyClick(dialog->findChild<QLineEdit*>("importFile"), Qt::Key_Return);
  const auto* report = dialog->findChild<QPlainTextEdit*>("importReport");
  QTRY_COMPARE(report->toPlainText(),
               QString("275 row(s) of time, throttle, thrust, supply.voltage, supply.current, "
                       "motor.speed will be imported."));
  choose(dialog, "importGroup", "Steady points over the throttle");
  QTRY_VERIFY2(report->toPlainText().contains("over_throttle.thrust"),
               qPrintable(report->toPlainText()));
  // The load cell of another stand would be the other way round: thrust turned over and back.
  const auto* table = dialog->findChild<MappingTable*>("importTable");
  const QString range = table->item(MappingTable::kRangeRow, 2)->text();
  QVERIFY2(range.endsWith(" N"), qPrintable(range));
  type(dialog, "scale2", "-1");
  QTest::keyClick(dialog->findChild<QLineEdit*>("scale2"), Qt::Key_Return);
  QTRY_VERIFY(table->item(MappingTable::kRangeRow, 2)->text() != range);
  type(dialog, "scale2", "1");
  QTest::keyClick(dialog->findChild<QLineEdit*>("scale2"), Qt::Key_Return);
  QTRY_COMPARE(table->item(MappingTable::kRangeRow, 2)->text(), range);
  type(dialog, "importName", kName);
  QPushButton* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  QTRY_VERIFY(ok->isEnabled());
  QTest::mouseClick(ok, Qt::LeftButton);
  QTRY_VERIFY(window.findChild<ImportDialog*>() == nullptr);
  const auto* runs = window.findChild<QListView*>("runsView");
  QCOMPARE(runs->model()->rowCount(), 2);
  QCOMPARE(runs->model()->index(0, 0).data().toString(), kName);
}

/// What was imported stands as marks beside the run on a chart of the experiment, and in its
/// legend.
void TestMeasurementJourney::overlay(MainWindow& window, const QString& chart,
                                     const QString& name) {
  const ChartPane* pane = paneTitled(window, chart);
  QVERIFY2(pane != nullptr, qPrintable(chart));
  QTRY_VERIFY(std::ranges::any_of(pane->runs().runs(), [&](const ChartRun& run) {
    return run.name == name && run.visible && run.measured;
  }));
  QTRY_VERIFY(paneCsv(*pane).section('\n', 0, 0).contains(name));
  const auto marks = [&] {
    return std::ranges::count_if(pane->legend()->items(), [](const LegendItem* item) {
      return item->entry().style.markers && item->isVisible();
    });
  };
  QTRY_VERIFY(marks() > 0);
}

void TestMeasurementJourney::residuals(MainWindow& window) {
  auto* dialog = openTool<ResidualsDialog>(window, "toolResiduals");
  QVERIFY(dialog != nullptr);
  const auto* measured = dialog->findChild<QComboBox*>("residualsMeasured");
  QCOMPARE(measured->currentText(), kName);
  const auto* table = dialog->findChild<QTableWidget*>("residualsTable");
  QTRY_VERIFY(!cell(*table, "over_throttle.thrust", 3).isEmpty());
  const double rmse = cell(*table, "over_throttle.thrust", 3).toDouble();
  QVERIFY2(rmse > 0 && rmse < 3, qPrintable(cell(*table, "over_throttle.thrust", 3)));
  QVERIFY(cell(*table, "over_throttle.speed", 2).toInt() > 100);
  dialog->close();
  QTRY_VERIFY(window.findChild<ResidualsDialog*>() == nullptr);
}

/// The speed controller of the stand has a curve of its own: the duty is known at full throttle
/// only.
void TestMeasurementJourney::fitAndSave(MainWindow& window) {
  auto* dialog = openTool<FitDialog>(window, "toolFit");
  QVERIFY(dialog != nullptr);
  QCOMPARE(dialog->findChild<QComboBox*>("fitMeasured")->currentText(), kName);
  choose(dialog, "what.duty", "1 at full throttle, else unknown");
  auto* noLoad = dialog->findChild<QCheckBox*>("what.noLoadCurrent");
  QVERIFY(noLoad != nullptr && noLoad->isChecked());
  noLoad->setFocus();
  QTest::keyClick(noLoad, Qt::Key_Space);
  click(dialog, "fitRun");
  QTRY_VERIFY_WITH_TIMEOUT(dialog->findChild<QPushButton*>("fitSave")->isEnabled(), 20000);
  const auto* table = dialog->findChild<QTableWidget*>("fitTable");
  const QString resistance = cell(*table, "Resistance", 2);
  QVERIFY2(resistance.contains("\u00B1") && resistance.endsWith("mΩ"), qPrintable(resistance));
  QVERIFY2(cell(*table, "RMSE of supply current", 3).startsWith("R² 0.99"),
           qPrintable(cell(*table, "RMSE of supply current", 3)));
  click(dialog, "fitSave");
  ComponentInfoDialog* info = nullptr;
  QTRY_VERIFY((info = dialog->findChild<ComponentInfoDialog*>()) != nullptr && info->isVisible());
  type(info, "infoName", "X2216 fitted");
  const auto* source = info->findChild<QPlainTextEdit*>("infoSource");
  QVERIFY2(source->toPlainText().contains(kName) && source->toPlainText().contains("Resistance"),
           qPrintable(source->toPlainText()));
  click(info, "infoOk");
  QTRY_COMPARE(dialog->findChild<QLabel*>("fitMessage")->text(),
               QString("“X2216 fitted” is in the component library."));
  dialog->close();
  QTRY_VERIFY(window.findChild<FitDialog*>() == nullptr);
}

/// From the library's button beside a part of the experiment.
void TestMeasurementJourney::pick(MainWindow& window, const QString& path, const QString& name) {
  window.workbench().experiment().jumpTo(path);
  QToolButton* button = nullptr;
  QTRY_VERIFY((button = window.findChild<QToolButton*>(path + ".library")) != nullptr &&
              button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  LibraryDialog* library = nullptr;
  QTRY_VERIFY((library = window.findChild<LibraryDialog*>()) != nullptr && library->isVisible());
  QTest::keyClicks(library->findChild<QLineEdit*>("librarySearch"), name);
  auto* list = library->findChild<QTreeWidget*>("libraryList");
  const auto found = list->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
  QCOMPARE(found.size(), 1);
  list->setCurrentItem(found.front());
  click(library, "libraryUse");
  QTRY_VERIFY(window.findChild<LibraryDialog*>() == nullptr);
}

/// A propeller's table in blocks: one curve beside the run of a bench, the whole of it as the
/// propeller of a flight.
void TestMeasurementJourney::propellerFromTableToExperiment() {
  MainWindow window;
  showWindow(window);
  openCard(window, "propeller-bench-10x47");
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  auto* dialog = openTool<ImportDialog>(window, "toolImport");
  QVERIFY(dialog != nullptr);
  type(dialog, "importFile", QStringLiteral(TEST_DATA_DIR "/measurement/PER3_8x6S.dat"));
  QTest::keyClick(dialog->findChild<QLineEdit*>("importFile"), Qt::Key_Return);
  choose(dialog, "importSpeed", "Curve of 5000 rpm");
  const auto* report = dialog->findChild<QPlainTextEdit*>("importReport");
  QTRY_VERIFY2(report->toPlainText().startsWith("15 row(s) of over_advance.j"),
               qPrintable(report->toPlainText()));
  click(dialog, "importSavePropeller");
  ComponentInfoDialog* info = nullptr;
  QTRY_VERIFY((info = dialog->findChild<ComponentInfoDialog*>()) != nullptr && info->isVisible());
  type(info, "infoName", "Table 8x6");
  click(info, "infoOk");
  QTRY_COMPARE(report->toPlainText(), QString("“Table 8x6” is in the component library."));
  QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                    Qt::LeftButton);
  QTRY_VERIFY(window.findChild<ImportDialog*>() == nullptr);
  overlay(window, "CT, CP and efficiency over J", "PER3_8x6S");

  auto* compare = openTool<ResidualsDialog>(window, "toolResiduals");
  QVERIFY(compare != nullptr);
  const auto* table = compare->findChild<QTableWidget*>("residualsTable");
  // The bench goes to J = 0.8, the table to 0.84.
  QTRY_COMPARE(cell(*table, "over_advance.ct", 2), QString("14"));
  compare->close();
  QTRY_VERIFY(window.findChild<ResidualsDialog*>() == nullptr);
}

/// The propeller that was saved flies: the library of another window has it.
void TestMeasurementJourney::savedPropellerFlies() {
  MainWindow window;
  showWindow(window);
  openCard(window, "battery-flight");
  const QString path = "setup.vehicle.rotors.rotor.aerodynamics";
  pick(window, path, "Table 8x6");
  QCOMPARE(std::get<double>(window.documents().model().get(path + ".diameter")), 8 * 0.0254);
  QVERIFY(!window.documents().model().hasErrors());
  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
  QCOMPARE(window.controller().status().progress.time, 40.0);
}

QTEST_MAIN(TestMeasurementJourney)
#include "test_measurement_journey.moc"
