// Runs as the window shows them: the controller keeps records current, the panel renames, hides,
// compares and deletes them, the metrics table copies.
#include <QClipboard>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolBar>
#include <QtTest>

#include "sim/run/simulation.h"
#include "tests/sim/run/fake_simulation.h"
#include "ui/runs/metrics_panel.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_delegate.h"
#include "ui/runs/run_marks.h"
#include "ui/runs/runs_panel.h"

using namespace rotorbench;

namespace {

RunController::Builder fake(const FakePlan& plan) {
  return [plan](const Experiment&, const std::filesystem::path&) {
    return std::make_unique<FakeSimulation>(plan);
  };
}

Experiment titled(const std::string& title) {
  Experiment experiment;
  experiment.title = title;
  return experiment;
}

/// Runs to the end and returns the id.
int finishedRun(RunController& controller, const Experiment& experiment) {
  const int id = controller.start(experiment);
  [&] { QTRY_COMPARE(controller.state(), RunState::Finished); }();
  return id;
}

}  // namespace

class TestRunList : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void recordFollowsTheRun();
  void buildErrorBecomesAFailedRecord();
  void secondStartEndsTheFirst();
  void destroyedDuringRun();
  void marksOlderInputs();
  void panelHidesRenamesDeletes();
  void comparesTwoRuns();
  void copiesMetrics();
  void eventsAreMarks();
};

void TestRunList::recordFollowsTheRun() {
  RunList runs;
  RunController controller(runs, fake({}));
  QSignalSpy states(&controller, &RunController::stateChanged);
  const int id = finishedRun(controller, titled("Hover"));
  const RunRecord& record = *runs.find(id);
  QCOMPARE(record.name, QString("Run 1: Hover"));
  QCOMPARE(record.status.outputs.at(0).recording->rows(), std::size_t{1000});
  QVERIFY(record.status.wallSeconds > 0);
  QVERIFY(runDetail(record).startsWith("Finished, 1 s in "));
  // So short a run may be over before anybody looks at its beginning.
  QVERIFY(states.count() >= 1);
}

/// What happens on the way is told by the tool tip and marked in charts, with the changes; a limit
/// that acts is no verdict.
void TestRunList::eventsAreMarks() {
  RunList runs;
  FakePlan plan;
  plan.events = {{0.2, 0.3, "motors_saturated", "motor 2 saturated"},
                 {0.7, 0.7, "recording_thinned", "recording thinned out to its limit of memory"}};
  RunController controller(runs, fake(plan));
  const RunRecord& record = *runs.find(finishedRun(controller, titled("Hover")));
  const std::vector<RunMark> marks = marksOf(record);
  QCOMPARE(marks.size(), std::size_t{2});
  QCOMPARE(marks[0].time, 0.2);
  QCOMPARE(marks[0].text, QString("motor 2 saturated"));
  QVERIFY(runDetail(record).startsWith("Finished, "));
  const QString tip = runs.index(0).data(Qt::ToolTipRole).toString();
  QVERIFY2(tip.contains("\nmotor 2 saturated at 0.2 s\n"), qPrintable(tip));
  QVERIFY2(tip.contains("thinned out to its limit of memory at 0.7 s"), qPrintable(tip));
}

void TestRunList::buildErrorBecomesAFailedRecord() {
  RunList runs;
  RunController controller(
      runs, [](const Experiment&, const std::filesystem::path&) -> std::unique_ptr<Simulation> {
        throw InputError("", {{"setup.duration", "-1 s is too small", "above 0 s", false}});
      });
  const int id = controller.start(titled("Wrong"));
  QTRY_COMPARE(controller.state(), RunState::Failed);
  QCOMPARE(runs.find(id)->status.problems.size(), std::size_t{1});
  QCOMPARE(runDetail(*runs.find(id)), QString("Could not start"));
}

void TestRunList::secondStartEndsTheFirst() {
  FakePlan plan;
  plan.ticks = 600000;
  plan.tickCost = std::chrono::microseconds(20);
  RunList runs;
  RunController controller(runs, fake(plan));
  const int first = controller.start(titled("One"));
  QTRY_COMPARE(controller.state(), RunState::Running);
  const int second = controller.start(titled("Two"));
  QCOMPARE(runs.find(first)->status.state, RunState::Stopped);
  QTRY_COMPARE(runs.find(second)->status.state, RunState::Running);
  QVERIFY(runs.find(first)->color != runs.find(second)->color);
}

void TestRunList::destroyedDuringRun() {
  FakePlan plan;
  plan.ticks = 600000;
  plan.tickCost = std::chrono::microseconds(20);
  RunList runs;
  QElapsedTimer clock;
  {
    RunController controller(runs, fake(plan));
    controller.start(titled("Long"));
    QTRY_COMPARE(controller.state(), RunState::Running);
    clock.start();
  }
  QVERIFY(clock.elapsed() < 2000);
}

void TestRunList::marksOlderInputs() {
  RunList runs;
  RunController controller(runs, fake({}));
  Experiment experiment = titled("Hover");
  runs.setCurrentExperiment(experiment);
  const int id = finishedRun(controller, experiment);
  const auto outOfDate = [&] {
    return runs.index(runs.rowOf(id)).data(RunList::OutOfDateRole).toBool();
  };
  QVERIFY(!outOfDate());
  experiment.title = "Another title";
  runs.setCurrentExperiment(experiment);
  QVERIFY(!outOfDate());
  experiment.seed = 7;
  runs.setCurrentExperiment(experiment);
  QVERIFY(outOfDate());
  QVERIFY(runs.index(0).data(RunList::DetailRole).toString().endsWith("older inputs"));
}

void TestRunList::panelHidesRenamesDeletes() {
  RunList runs;
  RunController controller(runs, fake({}));
  finishedRun(controller, titled("One"));
  finishedRun(controller, titled("Two"));
  RunsPanel panel(runs);
  panel.resize(300, 400);
  panel.show();
  QVERIFY(QTest::qWaitForWindowExposed(&panel));
  auto* view = panel.findChild<QListView*>("runsView");
  const QRect top = view->visualRect(runs.index(0));

  QStyleOptionViewItem option;
  option.initFrom(view);
  option.rect = top;
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, RunDelegate::checkRect(option).center());
  QVERIFY(!runs.records().front().visible);
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, RunDelegate::checkRect(option).center());
  QVERIFY(runs.records().front().visible);

  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, top.center());
  QCOMPARE(panel.selection(), std::vector<int>{2});
  QTest::keyClick(view, Qt::Key_F2);
  auto* editor = view->findChild<QLineEdit*>();
  QVERIFY(editor != nullptr);
  editor->selectAll();
  QTest::keyClicks(editor, "Calm air");
  QTest::keyClick(editor, Qt::Key_Return);
  QTRY_COMPARE(runs.find(2)->name, QString("Calm air"));

  QTest::keyClick(view, Qt::Key_Delete);
  auto* box = panel.findChild<QMessageBox*>("deleteRunsBox");
  QVERIFY(box != nullptr);
  QVERIFY(box->text().contains("Calm air"));
  for (QAbstractButton* button : box->buttons()) {
    if (box->buttonRole(button) == QMessageBox::DestructiveRole)
      QTest::mouseClick(button, Qt::LeftButton);
  }
  QTRY_COMPARE(runs.records().size(), std::size_t{1});
  QCOMPARE(runs.records().front().id, 1);
}

void TestRunList::comparesTwoRuns() {
  RunList runs;
  RunController controller(runs, fake({}));
  finishedRun(controller, titled("One"));
  Experiment other = titled("One");
  other.seed = 42;
  finishedRun(controller, other);
  RunsPanel panel(runs);
  panel.show();
  auto* view = panel.findChild<QListView*>("runsView");
  view->selectAll();
  auto* compare = panel.findChild<QAction*>("compareRuns");
  QVERIFY(compare->isEnabled());
  compare->trigger();
  auto* dialog = panel.findChild<QDialog*>("compareDialog");
  QVERIFY(dialog != nullptr);
  auto* inputs = dialog->findChild<QTableWidget*>("compareInputs");
  QCOMPARE(inputs->rowCount(), 1);
  QCOMPARE(inputs->item(0, 0)->text(), QString("seed"));
  QCOMPARE(inputs->item(0, 1)->text(), QString("42"));
  QCOMPARE(inputs->item(0, 2)->text(), QString("1"));
  auto* figures = dialog->findChild<QTableWidget*>("compareMetrics");
  QCOMPARE(figures->rowCount(), 1);
  QCOMPARE(figures->item(0, 3)->text(), QString("1000"));
}

void TestRunList::copiesMetrics() {
  MetricsPanel panel;
  panel.setMetrics(
      "Run 1",
      {{"Euler", {{"max_error_norm", "1", "Largest error", 0.25}}},
       {"RK4", {{"max_error_norm", "1", "Largest error", 1e-9}, {"time", "s", "Time", 0.5}}}});
  auto* table = panel.findChild<QTableWidget*>("metricsTable");
  QCOMPARE(table->rowCount(), 2);
  QCOMPARE(table->item(0, 0)->text(), QString("max error norm"));
  QCOMPARE(table->item(0, 2)->text(), QString("0.25"));
  QCOMPARE(table->item(1, 2)->text(), QString("–"));
  QTest::mouseClick(panel.findChild<QPushButton*>("copyMetricsCsv"), Qt::LeftButton);
  QCOMPARE(QGuiApplication::clipboard()->text(),
           QString("metric,unit,Euler,RK4\nmax_error_norm,1,0.25,1e-09\ntime,s,,0.5\n"));
  QTest::mouseClick(panel.findChild<QPushButton*>("copyMetricsText"), Qt::LeftButton);
  QVERIFY(QGuiApplication::clipboard()->text().contains("max_error_norm"));
}

QTEST_MAIN(TestRunList)
#include "test_run_list.moc"
