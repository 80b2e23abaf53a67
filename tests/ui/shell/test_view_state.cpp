// How a document is looked at goes with the document: another one starts with a view of its own.
#include <QLabel>
#include <QScrollBar>
#include <QTreeWidget>

#include "tests/ui/shell/shell_fixture.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/signal_tree.h"
#include "ui/forms/parameter_form.h"
#include "ui/runs/runs_panel.h"
#include "ui/scene/playback_bar.h"
#include "ui/scene/scene_panel.h"
#include "ui/scene/scene_view.h"
#include "ui/shell/status_bar.h"

using namespace rotorbench;

namespace {

const QString kFlagship = "f450-hover-and-steps";
const QString kMotorBench = "motor-bench-e305";

void runToEnd(MainWindow& window) {
  clickAction(window, "actionRun");
  QTRY_COMPARE_WITH_TIMEOUT(window.controller().state(), RunState::Finished, 60000);
}

/// Drags a rectangle in the plot, in shares of its sides from the upper left.
void dragBand(PlotWidget& plot, QPointF from, QPointF to) {
  const QRectF area = plot.plotLayout().plot;
  const auto at = [&](QPointF share) {
    return QPointF(area.left() + share.x() * area.width(), area.top() + share.y() * area.height())
        .toPoint();
  };
  QTest::mousePress(&plot, Qt::LeftButton, {}, at(from));
  QTest::mouseMove(&plot, at((from + to) / 2));
  QTest::mouseMove(&plot, at(to));
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, at(to));
}

void openFromGallery(MainWindow& window, const QString& name) {
  window.findChild<QAction*>("actionGallery")->trigger();
  openCard(window, name);
}

QStringList hiddenCurves(const ChartPane& pane) {
  QStringList names;
  for (const Curve& curve : pane.curves().curves)
    if (curve.hidden) names << curve.label;
  return names;
}

qsizetype pointsInView(const ChartPane& pane) {
  const ChartFrame& frame = pane.plot()->frame();
  qsizetype count = 0;
  for (const FrameCurve& curve : frame.curves) {
    const Span x = frame.x.scale.span;
    for (const QPointF& point : curve.points) count += point.x() >= x.low && point.x() <= x.high;
  }
  return count;
}

}  // namespace

class TestViewState : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void zoomGoesWithTheDocument();
  void panelsStartAfresh();
  void sameDocumentKeepsItsView();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestViewState::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  useSettingsIn(folder_->path());
  QLocale::setDefault(QLocale::c());
}

/// The flagship zoomed to 8..18 s, then the motor bench, whose run is over before that.
void TestViewState::zoomGoesWithTheDocument() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  QTRY_COMPARE(window.workbench().charts().panes().size(), std::size_t{7});
  choosePace(window, "As fast as possible");
  runToEnd(window);
  ChartGrid& charts = window.workbench().charts();
  ChartPane* first = charts.panes().front();
  QTRY_VERIFY(pointsInView(*first) > 0);
  dragBand(*first->plot(), {0.4, 0.1}, {0.9, 0.6});
  QTRY_VERIFY(first->view().x.has_value());
  QVERIFY(!first->view().y.empty());
  const QRectF plot = first->plot()->plotLayout().plot;
  QTest::mouseClick(first->plot(), Qt::LeftButton, {}, plot.center().toPoint());
  QVERIFY(charts.link()->cursor(Cursor::A).has_value());
  auto* legend = first->findChild<QWidget*>("legend:" + first->curves().curves.front().label);
  QTest::mouseClick(legend, Qt::LeftButton);
  QCOMPARE(hiddenCurves(*first).size(), 1);
  charts.link()->setFollows(true);
  charts.maximize(first);

  openFromGallery(window, kMotorBench);
  QVERIFY(charts.maximizedPane() == nullptr);
  QVERIFY(!charts.link()->timeRange().has_value());
  QVERIFY(!charts.link()->follows());
  QVERIFY(!charts.link()->cursor(Cursor::A).has_value());
  QTRY_COMPARE(charts.currentPane(), charts.panes().front());
  runToEnd(window);
  for (ChartPane* pane : charts.panes()) {
    QVERIFY2(pane->view() == ChartView{}, pane->spec().title.c_str());
    QCOMPARE(hiddenCurves(*pane), QStringList());
    QVERIFY(!pane->back());  // nothing of the other document to go back to
    pane->refresh();
    QVERIFY2(pointsInView(*pane) > 0, pane->spec().title.c_str());
  }
  // And back: no view is kept for a document that is opened again.
  openFromGallery(window, kFlagship);
  for (const ChartPane* pane : charts.panes()) {
    QVERIFY(pane->view() == ChartView{});
    QCOMPARE(hiddenCurves(*pane), QStringList());
  }
}

void TestViewState::panelsStartAfresh() {
  MainWindow window;
  showWindow(window);
  openCard(window, kFlagship);
  choosePace(window, "As fast as possible");
  runToEnd(window);
  Workbench& bench = window.workbench();
  bench.bringUp(bench.signalTree());
  QTest::keyClicks(bench.signalTree().search(), "thrust");
  window.workbench().experiment().jumpTo("setup.control.controller.roll.kp");
  ScenePanel& scene = bench.scene();
  scene.setTime(12);
  const CameraView before = scene.view().stage().camera().view(1);
  QTest::keyClick(&scene.view(), Qt::Key_Left);
  QTest::keyClick(&scene.view(), Qt::Key_Plus);
  scene.playback().setSpeed(10);
  scene.playback().setLooping(true);
  auto* status = window.findChild<QLabel*>("runStatus");
  QCOMPARE(status->text(), QString("Finished"));
  QCOMPARE(bench.runs().selection().size(), std::size_t{1});

  openFromGallery(window, kFlagship);
  QCOMPARE(bench.signalTree().search()->text(), QString());
  QCOMPARE(bench.experiment().form()->section(), QString());
  QCOMPARE(scene.time(), 0.0);
  QVERIFY(!bench.charts().link()->cursor(Cursor::A).has_value());
  QCOMPARE(scene.playback().speed(), 1.0);
  QVERIFY(!scene.playback().isLooping());
  const CameraView after = scene.view().stage().camera().view(1);
  QVERIFY(((after.eye - after.target) - (before.eye - before.target)).norm() < 1e-9);
  // The run that finished is not this document's.
  QCOMPARE(status->text(), QString("Not run yet"));
  QVERIFY(bench.runs().selection().empty());
  // The old run can still be looked at: one click shows its figures.
  auto* list = bench.runs().findChild<QAbstractItemView*>("runsView");
  bench.bringUp(bench.runs());
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualRect(list->model()->index(0, 0)).center());
  auto* table = window.findChild<QTableWidget*>("metricsTable");
  QTRY_VERIFY(table->isVisible() && table->rowCount() > 0);
}

void TestViewState::sameDocumentKeepsItsView() {
  MainWindow window;
  showWindow(window);
  openCard(window, kMotorBench);
  runToEnd(window);
  ChartGrid& charts = window.workbench().charts();
  ChartPane* first = charts.panes().front();
  QTRY_VERIFY(pointsInView(*first) > 0);
  dragBand(*first->plot(), {0.2, 0.0}, {0.8, 0.03});
  QTRY_VERIFY(first->view().x.has_value());
  const ChartView zoomed = first->view();
  runToEnd(window);
  QTest::qWait(200);
  QVERIFY(first->view() == zoomed);
}

QTEST_MAIN(TestViewState)
#include "test_view_state.moc"
