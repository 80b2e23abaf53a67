// File > New of kind, as a person does it: the experiment has charts, its channels are in the
// signal tree before any run, the status says that it has not run, and what it shows is filled by a
// run.
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTreeView>

#include "sim/document/experiment.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/plot_widget.h"
#include "ui/charts/signal_tree.h"

using namespace rotorbench;

namespace {

/// Opens a menu of the menu bar and clicks through the entries, by what they are named.
void clickMenu(MainWindow& window, const char* menuName, const QStringList& actions) {
  auto* menu = window.findChild<QMenu*>(menuName);
  QVERIFY(menu != nullptr);
  QMenuBar* bar = window.menuBar();
  QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu->menuAction()).center());
  for (const QString& name : actions) {
    QTRY_VERIFY(menu->isVisible());
    QAction* action = nullptr;
    for (QAction* entry : menu->actions()) {
      const QString own =
          entry->menu() != nullptr ? entry->menu()->objectName() : entry->objectName();
      if (own == name) action = entry;
    }
    QVERIFY2(action != nullptr, qPrintable(name));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
    if (action->menu() != nullptr) menu = action->menu();
  }
}

void collect(const QAbstractItemModel& model, const QModelIndex& parent, const QString& path,
             QStringList& names) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const QModelIndex index = model.index(row, 0, parent);
    const QString own =
        path.isEmpty() ? index.data().toString() : path + '.' + index.data().toString();
    names << own;
    collect(model, index, own, names);
  }
}

/// Everything the signal tree lists, groups and channels.
QStringList signalsShown(MainWindow& window) {
  QStringList names;
  const auto* view = window.workbench().signalTree().findChild<QTreeView*>();
  if (!view->isHidden()) collect(*view->model(), {}, {}, names);
  return names;
}

QString status(MainWindow& window) {
  return window.findChild<QLabel*>("runStatus")->text();
}

QString hintOf(const ChartPane& pane) {
  return pane.findChild<PlotWidget*>()->hint();
}

QStringList chartTitles(MainWindow& window) {
  QStringList titles;
  for (const ChartPane* pane : window.workbench().charts().panes())
    titles << pane->findChild<QLineEdit*>("chartTitle")->text();
  return titles;
}

}  // namespace

class TestNewExperiment : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void newOfEveryKind_data();
  void newOfEveryKind();
  void kindChosenInTheFormHasItsCharts();
  void chartsOfOnesOwnAreKept();

 private:
  QTemporaryDir folder_;
};

void TestNewExperiment::initTestCase() {
  useSettingsIn(folder_.path());
  QLocale::setDefault(QLocale::c());
}

void TestNewExperiment::newOfEveryKind_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("chart");
  QTest::addColumn<QStringList>("channels");
  QTest::addRow("flight") << "flight"
                          << "Attitude" << QStringList{"position.z", "rotor1.thrust", "setpoint.z"};
  QTest::addRow("motor-bench") << "motor-bench"
                               << "Currents"
                               << QStringList{"motor.current", "over_throttle.thrust"};
  QTest::addRow("propeller-bench")
      << "propeller-bench"
      << "CT, CP and efficiency over J" << QStringList{"thrust", "over_advance.ct"};
  QTest::addRow("thrust-stand") << "thrust-stand"
                                << "Thrust over throttle"
                                << QStringList{"thrust", "reached.thrust"};
  QTest::addRow("motor-speed-control")
      << "motor-speed-control"
      << "Control signal" << QStringList{"motor.speed", "controller.voltage"};
  QTest::addRow("solver-comparison")
      << "solver-comparison"
      << "Work-precision" << QStringList{"error_norm", "angular_velocity"};
  QTest::addRow("birotor") << "birotor"
                           << "Angular velocity" << QStringList{"angular_velocity", "energy"};
  QCOMPARE(schema::typeOf<Experiment>().field("setup")->options.size(), std::size_t{7});
}

void TestNewExperiment::newOfEveryKind() {
  QFETCH(QString, kind);
  QFETCH(QString, chart);
  QFETCH(QStringList, channels);
  MainWindow window;
  showWindow(window);
  // Another experiment has run before: its end is not that of the new one.
  openCard(window, "spring-bar-birotor");
  QCOMPARE(status(window), QString("Not run yet"));
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(status(window), QString("Finished"), 60000);

  clickMenu(window, "menuFile", {"menuNewOfKind", "new:" + kind});
  QTRY_COMPARE(status(window), QString("Not run yet"));
  QVERIFY(!window.isWindowModified());
  const QStringList titles = chartTitles(window);
  QVERIFY2(titles.size() >= 3 && titles.contains(chart), qPrintable(titles.join(", ")));
  for (const ChartPane* pane : window.workbench().charts().panes())
    QTRY_COMPARE(hintOf(*pane), QString("Press Run (F5) to fill this chart."));
  for (const QString& channel : channels)
    QTRY_VERIFY2(signalsShown(window).contains(channel), qPrintable(channel));
  // What the run before had and this one has not is gone; a new birotor has the same bar.
  QCOMPARE(signalsShown(window).contains("bar.length"), kind == "birotor");

  choosePace(window, "As fast as possible");
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(status(window), QString("Finished"), 120000);
  for (const ChartPane* pane : window.workbench().charts().panes())
    QTRY_VERIFY2(hintOf(*pane).isEmpty() && !pane->legend()->items().empty(),
                 qPrintable(QString::fromStdString(pane->spec().title) + ": " + hintOf(*pane)));
  for (const QString& channel : channels) QVERIFY(signalsShown(window).contains(channel));
}

/// The box at the head of the form: charts and channels are those of the kind chosen there, and
/// come back with Undo.
void TestNewExperiment::kindChosenInTheFormHasItsCharts() {
  MainWindow window;
  showWindow(window);
  QTest::mouseClick(window.findChild<QPushButton*>("galleryNew"), Qt::LeftButton);
  QTRY_VERIFY(window.workbench().isVisible());
  QTRY_VERIFY(signalsShown(window).contains("rotor1.thrust"));
  const QStringList before = chartTitles(window);
  window.workbench().experiment().jumpTo("setup");
  QComboBox* box = nullptr;
  QTRY_VERIFY((box = window.findChild<QComboBox*>("setup")) != nullptr && box->isVisible());
  const int stand = box->findText("Thrust stand");
  QVERIFY(stand >= 0);
  box->setCurrentIndex(stand);
  emit box->activated(stand);
  QTRY_VERIFY2(chartTitles(window).contains("Thrust over throttle"),
               qPrintable(chartTitles(window).join(", ")));
  QTRY_VERIFY(signalsShown(window).contains("reached.thrust"));
  QVERIFY(!signalsShown(window).contains("rotor1.thrust"));
  clickAction(window, "actionUndo");
  QTRY_COMPARE(chartTitles(window), before);
  QTRY_VERIFY(signalsShown(window).contains("rotor1.thrust"));
}

/// A chart taken away is taken away from those of the kind, and another kind does not bring it
/// back.
void TestNewExperiment::chartsOfOnesOwnAreKept() {
  MainWindow window;
  showWindow(window);
  QTest::mouseClick(window.findChild<QPushButton*>("galleryNew"), Qt::LeftButton);
  QTRY_VERIFY(window.workbench().isVisible());
  const auto count = window.workbench().charts().panes().size();
  QVERIFY(count >= 3);
  ChartPane* first = window.workbench().charts().panes().front();
  auto* remove = first->findChild<QAction*>("removeChart");
  QVERIFY(remove != nullptr);
  remove->trigger();
  QTRY_COMPARE(window.documents().experiment().outputs.charts.size(), count - 1);
  QCOMPARE(window.workbench().charts().panes().size(), count - 1);
  clickAction(window, "actionUndo");
  QTRY_COMPARE(window.workbench().charts().panes().size(), count);
}

QTEST_MAIN(TestNewExperiment)
#include "test_new_experiment.moc"
