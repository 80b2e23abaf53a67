// A flight changed while it goes on, as a person does it in the window: by the form, by keys of the
// 3D view, in a pause; what acts is marked, what does not is said, and the run's experiment repeats
// it.
#include <QCheckBox>
#include <QStatusBar>

#include "sim/document/changes.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/run/simulation.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_pane.h"
#include "ui/scene/hand_bar.h"
#include "ui/scene/marked_slider.h"
#include "ui/scene/scene_panel.h"
#include "ui/scene/scene_view.h"

using namespace rotorbench;

namespace {

const QString kRollGain = "setup.control.controller.roll.kp";

const RunRecord& record(MainWindow& window) {
  return *window.runs().find(window.controller().currentRun());
}

std::vector<Change> changesOf(MainWindow& window) {
  const auto changes = record(window).status.changes;
  return changes ? *changes : std::vector<Change>{};
}

/// The changes of one parameter.
QStringList valuesOf(MainWindow& window, const std::string& parameter) {
  QStringList values;
  for (const Change& change : changesOf(window))
    if (change.parameter == parameter) values << QString::fromStdString(change.value);
  return values;
}

double lastOf(MainWindow& window, const std::string& channel) {
  const Recording& r = *record(window).status.outputs.front().recording;
  return r.rows() == 0 ? 0 : r.value(*r.find(channel), r.rows() - 1);
}

void startFlight(MainWindow& window) {
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  choosePace(window, "2 ×");
  clickAction(window, "actionRun");
  QTRY_COMPARE(window.controller().state(), RunState::Running);
  QTRY_VERIFY(!record(window).status.outputs.empty() && lastOf(window, "time") > 0.1);
}

QString labelOf(MainWindow& window, const QString& path) {
  window.workbench().experiment().jumpTo(path);
  const auto* label = window.findChild<QLabel*>(path + ".label");
  return label == nullptr ? QString("no label") : label->text();
}

}  // namespace

class TestLiveEdits : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void formActsInTheRun();
  void whatNeedsANewRunIsSaid();
  void editsInAPause();
  void keysFly();
  void theRunsExperimentRepeatsIt();
  void windTurnsInTheScene();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestLiveEdits::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  QVERIFY(folder_->isValid());
  useSettingsIn(folder_->path());
  QLocale::setDefault(QLocale::c());
}

void TestLiveEdits::formActsInTheRun() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  auto* note = window.findChild<QLabel*>("flyingNote");
  QVERIFY(!note->isVisible());
  QVERIFY(!labelOf(window, kRollGain).contains(QChar(0x25CF)));
  choosePace(window, "2 ×");
  clickAction(window, "actionRun");
  QTRY_COMPARE(window.controller().state(), RunState::Running);
  QTRY_VERIFY(note->isVisible());
  QVERIFY2(note->text().startsWith("Run 1 is under way. What is marked"), qPrintable(note->text()));
  QVERIFY(labelOf(window, kRollGain).contains(QChar(0x25CF)));
  QVERIFY(!labelOf(window, "setup.duration").contains(QChar(0x25CF)));

  typeInto(window, kRollGain, "60");
  QTRY_COMPARE(valuesOf(window, "control.controller.roll.kp"), QStringList{"60 1/s^2"});
  clickAction(window, "actionUndo");
  QTRY_COMPARE(valuesOf(window, "control.controller.roll.kp").size(), qsizetype{2});
  // Charts and playback show when.
  const double time = changesOf(window).front().time;
  QVERIFY(time > 0);
  ChartPane* pane = window.workbench().charts().panes().front();
  QTRY_COMPARE(pane->plot()->marks().size(), std::size_t{2});
  QCOMPARE(pane->plot()->marks().front().time, time);
  QCOMPARE(pane->plot()->marks().front().text, QString("control.controller.roll.kp = 60 1/s^2"));
  auto* slider = window.findChild<MarkedSlider*>("timeSlider");
  QTRY_COMPARE(slider->marks().size(), std::size_t{2});
  pane->findChild<QAction*>("showMarks")->trigger();
  QVERIFY(pane->plot()->marks().empty());

  clickAction(window, "actionStop");
  QTRY_COMPARE(window.controller().state(), RunState::Stopped);
  QVERIFY(!note->isVisible());
  QVERIFY(!labelOf(window, kRollGain).contains(QChar(0x25CF)));
  typeInto(window, kRollGain, "61");
  QCOMPARE(changesOf(window).size(), std::size_t{2});
}

void TestLiveEdits::whatNeedsANewRunIsSaid() {
  MainWindow window;
  startFlight(window);
  typeInto(window, "setup.duration", "50");
  QTRY_COMPARE(window.statusBar()->currentMessage(),
               QString("“Duration” acts from the next run on."));
  QVERIFY(changesOf(window).empty());
  // And what acts still does.
  typeInto(window, kRollGain, "60");
  QTRY_COMPARE(changesOf(window).size(), std::size_t{1});
}

void TestLiveEdits::editsInAPause() {
  MainWindow window;
  startFlight(window);
  clickAction(window, "actionPause");
  QTRY_COMPARE(window.controller().state(), RunState::Paused);
  const double paused = window.controller().status().progress.time;
  typeInto(window, "setup.control.byHand.height", "2.5");
  window.workbench().experiment().jumpTo("setup.control.byHand.heightByHand");
  auto* box = window.findChild<QCheckBox*>("setup.control.byHand.heightByHand");
  QVERIFY(box != nullptr);
  QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
  QTRY_COMPARE(changesOf(window).size(), std::size_t{2});
  QCOMPARE(changesOf(window).back().time, paused);
  QCOMPARE(window.controller().state(), RunState::Paused);
  clickAction(window, "actionStep");
  QTRY_COMPARE(lastOf(window, "setpoint.z"), 2.5);
}

void TestLiveEdits::keysFly() {
  MainWindow window;
  startFlight(window);
  auto& scene = window.workbench().scene();
  auto* button = scene.findChild<QToolButton*>("flyByHand");
  auto* label = scene.findChild<QLabel*>("handLabel");
  window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&window));
  QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(label->text().contains("Arrows tilt"));
  QWidget* view = &scene.view();
  QVERIFY(view->hasFocus());
  QTest::keyPress(view, Qt::Key_Up);
  QTRY_VERIFY(std::abs(lastOf(window, "setpoint.pitch") - HandBar::kTilt) < 1e-12);
  QVERIFY2(label->text().contains("pitch 10"), qPrintable(label->text()));
  QTest::keyRelease(view, Qt::Key_Up);
  QTRY_COMPARE(lastOf(window, "setpoint.pitch"), 0.0);
  // From where the timeline has it.
  const double height = lastOf(window, "setpoint.z");
  QTest::keyClick(view, Qt::Key_W);
  QTRY_COMPARE(lastOf(window, "setpoint.z"), height + HandBar::kClimb);
  QTest::keyClick(view, Qt::Key_PageUp);
  QTRY_COMPARE(lastOf(window, "setpoint.z"), height + 2 * HandBar::kClimb);
  QTest::keyClick(view, Qt::Key_A);
  QTRY_VERIFY(std::abs(lastOf(window, "setpoint.yaw") - HandBar::kTurn) < 1e-12);
  // The timeline goes on where no hand is.
  QTest::mouseClick(scene.findChild<QToolButton*>("backToTimeline"), Qt::LeftButton);
  QTRY_COMPARE(lastOf(window, "setpoint.yaw"), 0.0);
  QVERIFY(!scene.findChild<QToolButton*>("backToTimeline")->isEnabled());
  // The document is not touched: flying is no edit.
  QVERIFY(!window.documents().model().undoStack()->canUndo());
  QTest::keyPress(view, Qt::Key_Right);
  QTRY_VERIFY(lastOf(window, "setpoint.roll") > 0.1);
  // A key that is held when the view loses the focus is let go.
  button->setFocus();
  QTRY_COMPARE(lastOf(window, "setpoint.roll"), 0.0);
}

void TestLiveEdits::theRunsExperimentRepeatsIt() {
  MainWindow window;
  startFlight(window);
  typeInto(window, kRollGain, "60");
  auto& scene = window.workbench().scene();
  scene.hand().setOn(true);
  QTest::keyClick(&scene.view(), Qt::Key_W);
  QVERIFY(!window.documents().model().set("setup.control.setPoints[1].height", 1.5));
  QTRY_VERIFY(changesOf(window).size() >= 3);
  QTRY_VERIFY(lastOf(window, "time") > 1);
  clickAction(window, "actionStop");
  QTRY_COMPARE(window.controller().state(), RunState::Stopped);
  const RunRecord& live = record(window);
  const Recording& recorded = *live.status.outputs.front().recording;
  const auto repeated =
      buildSimulation(readExperiment(writeExperiment(live.experiment), "saved.json"));
  repeated->advance(static_cast<std::int64_t>(recorded.rows()));
  const Recording& again = *repeated->runs().front().recording;
  QCOMPARE(again.rows(), recorded.rows());
  for (std::size_t c = 0; c < recorded.channels().size(); ++c)
    for (std::size_t row = 0; row < recorded.rows(); ++row)
      QVERIFY(again.value(c, row) == recorded.value(c, row) ||
              (std::isnan(again.value(c, row)) && std::isnan(recorded.value(c, row))));
}

void TestLiveEdits::windTurnsInTheScene() {
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-in-the-wind");
  choosePace(window, "Real time");
  clickAction(window, "actionRun");
  QTRY_VERIFY(window.controller().state() == RunState::Running &&
              !record(window).status.outputs.empty());
  const QString path = "setup.environment.wind.velocity";
  window.workbench().experiment().jumpTo(path);
  QVERIFY(labelOf(window, path).contains(QChar(0x25CF)));
  auto* x = window.findChild<QLineEdit*>(path + "[0]");
  QVERIFY(x != nullptr);
  x->setFocus();
  x->selectAll();
  QTest::keyClicks(x, "-3");
  QTest::keyClick(x, Qt::Key_Return);
  QTRY_COMPARE(changesOf(window).size(), std::size_t{1});
  QTRY_VERIFY(lastOf(window, "wind.x") < 0);
  const auto& pose = window.workbench().scene().view().stage().pose();
  QTRY_VERIFY(pose.wind && pose.wind->x() < 0);
}

QTEST_MAIN(TestLiveEdits)
#include "test_live_edits.moc"
