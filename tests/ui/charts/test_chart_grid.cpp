// Charts side by side and the signal tree, as a person uses them.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <atomic>
#include <thread>

#include "chart_fixture.h"
#include "ui/charts/channel_mime.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/signal_tree.h"

using namespace rotorbench;

namespace {

std::vector<ChartSpec> specs(int count) {
  std::vector<ChartSpec> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    all[static_cast<std::size_t>(i)].title = "Chart " + std::to_string(i + 1);
    all[static_cast<std::size_t>(i)].channels = "rotor" + std::to_string(i % 4 + 1) + ".thrust";
  }
  return all;
}

/// Every text of the tree that is on show, top down, indented by level.
QStringList shownTexts(const QTreeView& view) {
  QStringList texts;
  for (QModelIndex i = view.model()->index(0, 0); i.isValid(); i = view.indexBelow(i)) {
    QString indent;
    for (QModelIndex up = i.parent(); up.isValid(); up = up.parent()) indent += QLatin1String("  ");
    texts += indent + i.data().toString();
  }
  return texts;
}

}  // namespace

class TestChartGrid : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QVERIFY(QApplication::topLevelWidgets().isEmpty()); }
  void emptyStateAddsAChart();
  void specsGoInAndOut();
  void samePanesKeepTheirView();
  void splitRemoveMaximize();
  void liveWhileWriting();
  void runOutsideTheViewIsBroughtIn_data();
  void runOutsideTheViewIsBroughtIn();
  void unfinishedRunMovesNothing();
  void timeCursorBothWays();
  void treeSplitsSearchesAndAdds();
  void treeKeepsItsShapeOnRerun();
  void treeDragsGroups();
};

void TestChartGrid::emptyStateAddsAChart() {
  RunSet runs;
  ChartGrid grid(&runs);
  grid.resize(600, 400);
  grid.show();
  auto* text = grid.findChild<QLabel*>("chartGridEmptyText");
  QVERIFY(text->isVisible());
  QSignalSpy changed(&grid, &ChartGrid::specsChanged);
  QTest::mouseClick(grid.findChild<QPushButton*>("addFirstChart"), Qt::LeftButton);
  QCOMPARE(grid.panes().size(), std::size_t{1});
  QCOMPARE(changed.size(), 1);
  QVERIFY(!text->isVisible());
  grid.addChannels({"error"});
  QCOMPARE(grid.specs()[0].channels, std::string("error"));
  QCOMPARE(changed.size(), 2);
}

void TestChartGrid::specsGoInAndOut() {
  RunSet runs;
  ChartGrid grid(&runs);
  QSignalSpy changed(&grid, &ChartGrid::specsChanged);
  for (const int count : {1, 2, 3, 4, 6, 9, 5, 0, 3}) {
    grid.setSpecs(specs(count));
    QCOMPARE(grid.specs(), specs(count));
  }
  QCOMPARE(changed.size(), 0);
}

void TestChartGrid::samePanesKeepTheirView() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(100)));
  ChartGrid grid(&runs);
  grid.setSpecs(specs(2));
  ChartPane* first = grid.panes()[0];
  first->setView({std::nullopt, {{"N", {0, 3}}}});
  auto edited = specs(2);
  edited[0].title = "Renamed";
  grid.setSpecs(edited);
  QCOMPARE(grid.panes()[0], first);
  QCOMPARE(first->view().y.at("N"), (Span{0, 3}));
}

void TestChartGrid::splitRemoveMaximize() {
  RunSet runs;
  ChartGrid grid(&runs);
  grid.setSpecs(specs(2));
  grid.resize(800, 600);
  grid.show();
  QVERIFY(QTest::qWaitForWindowExposed(&grid));
  QSignalSpy changed(&grid, &ChartGrid::specsChanged);
  ChartPane* first = grid.panes()[0];
  first->menu()->findChild<QAction*>("splitRight")->trigger();
  QCOMPARE(grid.panes().size(), std::size_t{3});
  QCOMPARE(grid.specs()[1], ChartSpec{});
  QCOMPARE(grid.currentPane(), grid.panes()[1]);
  QTRY_COMPARE(grid.panes()[1]->geometry().top(), first->geometry().top());
  first->menu()->findChild<QAction*>("splitBelow")->trigger();
  QCOMPARE(grid.panes().size(), std::size_t{4});
  QCOMPARE(grid.specs()[2], ChartSpec{});
  grid.panes()[1]->menu()->findChild<QAction*>("removeChart")->trigger();
  QTRY_COMPARE(grid.panes().size(), std::size_t{3});
  QCOMPARE(changed.size(), 3);
  ChartPane* last = grid.panes()[2];
  auto* button = last->findChild<QToolButton*>("maximizeChart");
  QTest::mouseClick(button, Qt::LeftButton);
  QCOMPARE(grid.maximizedPane(), last);
  QVERIFY(!first->isVisible());
  QVERIFY(last->isVisible());
  QTRY_VERIFY(last->height() > 550);
  QCOMPARE(button->accessibleName(), QStringLiteral("Show all charts"));
  QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(first->isVisible());
}

void TestChartGrid::liveWhileWriting() {
  RunSet runs;
  ChartGrid grid(&runs);
  grid.setSpecs(specs(4));
  grid.resize(800, 600);
  grid.show();
  auto recording = std::make_shared<Recording>(fixture::channels());
  runs.add(fixture::run("1", recording));
  std::atomic<int> written{0};
  std::atomic<int> goal{1000};
  std::thread writer([&] {
    for (int i = 0; i < 5000; ++i) {
      while (i >= goal) std::this_thread::yield();
      fixture::appendRow(*recording, i * 0.01);
      recording->publish();
      written = i + 1;
    }
    recording->finish();
  });
  const auto lastTime = [&](std::size_t pane) {
    const auto& curves = grid.panes()[pane]->plot()->frame().curves;
    return curves.empty() || curves[0].points.isEmpty() ? -1.0 : curves[0].points.last().x();
  };
  // Nobody calls refresh: the grid does it itself while the run grows.
  for (std::size_t pane = 0; pane < 4; ++pane) QTRY_VERIFY(std::abs(lastTime(pane) - 9.99) < 0.2);
  goal = 5000;
  for (std::size_t pane = 0; pane < 4; ++pane) QTRY_COMPARE(lastTime(pane), 4999 * 0.01);
  writer.join();
}

void TestChartGrid::runOutsideTheViewIsBroughtIn_data() {
  QTest::addColumn<double>("end");
  QTest::addColumn<bool>("yZoom");
  QTest::addColumn<bool>("timeKept");
  QTest::addColumn<bool>("yKept");
  QTest::addRow("ends before the view") << 5.0 << false << false << false;
  QTest::addRow("ends in the view") << 12.0 << false << true << false;
  QTest::addRow("reaches beyond the view") << 30.0 << false << true << false;
  QTest::addRow("at its time, with other values") << 12.0 << true << true << false;
  QTest::addRow("at its time and values") << 30.0 << true << true << true;
}

/// A view of 8 s to 18 s, in one chart also of 15 N to 19 N; thrust of the runs is 1 N + 1 N/s t.
void TestChartGrid::runOutsideTheViewIsBroughtIn() {
  QFETCH(double, end);
  QFETCH(bool, yZoom);
  QFETCH(bool, timeKept);
  QFETCH(bool, yKept);
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(101, 20)));
  ChartGrid grid(&runs);
  grid.setSpecs(specs(2));
  grid.resize(800, 600);
  grid.show();
  QVERIFY(QTest::qWaitForWindowExposed(&grid));
  ChartPane* first = grid.panes().front();
  QTest::qWait(100);  // the first run has arrived
  ChartView view{Span{8, 18}, {}};
  if (yZoom) view.y["N"] = {15, 19};
  first->setView(view);
  runs.add(fixture::run("2", fixture::ramp(101, end)));
  QTest::qWait(200);
  QCOMPARE(grid.link()->timeRange().has_value(), timeKept);
  QCOMPARE(first->view().y.contains("N"), yKept);
  if (first->view() == view) return;
  QTest::keyClick(first, Qt::Key_Backspace);
  QTRY_VERIFY(first->view() == view);  // as any other zoom
}

void TestChartGrid::unfinishedRunMovesNothing() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(101, 20)));
  ChartGrid grid(&runs);
  grid.setSpecs(specs(1));
  grid.resize(800, 600);
  grid.show();
  QVERIFY(QTest::qWaitForWindowExposed(&grid));
  QTest::qWait(100);
  grid.link()->setTimeRange(Span{8, 18});
  const auto growing = fixture::ramp(11, 1, false);
  runs.add(fixture::run("2", growing));
  QTest::qWait(200);
  QVERIFY(grid.link()->timeRange() == (Span{8, 18}));
  growing->finish();
  QTRY_VERIFY(!grid.link()->timeRange().has_value());
}

void TestChartGrid::timeCursorBothWays() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(100)));
  ChartGrid grid(&runs);
  grid.setSpecs(specs(2));
  grid.resize(800, 600);
  grid.show();
  QVERIFY(QTest::qWaitForWindowExposed(&grid));
  grid.refresh();
  QSignalSpy moved(&grid, &ChartGrid::timeCursorMoved);
  grid.setTimeCursor(3.0);
  QCOMPARE(moved.size(), 0);
  QCOMPARE(
      grid.panes()[1]->findChild<QWidget*>("legend:rotor2.thrust")->accessibleDescription().left(1),
      "4");
  PlotWidget* plot = grid.panes()[0]->plot();
  QTest::mouseClick(plot, Qt::LeftButton, {}, plot->plotLayout().plot.center().toPoint());
  QCOMPARE(moved.size(), 1);
  QVERIFY(std::abs(moved[0][0].toDouble() - 5) < 0.05);
}

void TestChartGrid::treeSplitsSearchesAndAdds() {
  RunSet runs;
  SignalTree tree(&runs);
  tree.resize(300, 500);
  tree.show();
  QVERIFY(tree.findChild<QLabel*>("signalHint")->isVisible());
  runs.add(fixture::run("1", fixture::ramp(10)));
  QVERIFY(!tree.findChild<QLabel*>("signalHint")->isVisible());
  QCOMPARE(shownTexts(*tree.view()),
           (QStringList{"time", "rotor1", "rotor2", "rotor3", "rotor4", "position", "error"}));
  QTest::keyClicks(tree.search(), "rotor3.th");
  QCOMPARE(shownTexts(*tree.view()), (QStringList{"rotor3", "  thrust"}));
  const QModelIndex group = tree.view()->model()->index(0, 0);
  const QModelIndex thrust = tree.view()->model()->index(0, 0, group);
  QCOMPARE(thrust.siblingAtColumn(1).data().toString(), QStringLiteral("N"));
  QCOMPARE(thrust.data(Qt::ToolTipRole).toString(), QStringLiteral("Thrust [N]"));
  QSignalSpy activated(&tree, &SignalTree::channelsActivated);
  tree.view()->setCurrentIndex(thrust);
  QTest::keyClick(tree.view(), Qt::Key_Return);
  QCOMPARE(activated.size(), 1);
  QCOMPARE(activated[0][0].toStringList(), QStringList{"rotor3.thrust"});
  const QPoint place = tree.view()->visualRect(thrust).center();
  QTest::mouseClick(tree.view()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(tree.view()->viewport(), Qt::LeftButton, {}, place);
  QCOMPARE(activated.size(), 2);
}

void TestChartGrid::treeKeepsItsShapeOnRerun() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(10)));
  SignalTree tree(&runs);
  tree.resize(300, 500);
  tree.show();
  tree.view()->expand(tree.view()->model()->index(1, 0));
  const QStringList before = shownTexts(*tree.view());
  QVERIFY(before.contains("  thrust"));
  runs.setRuns({});
  QVERIFY(shownTexts(*tree.view()).isEmpty());
  runs.setRuns({fixture::run("2", fixture::ramp(10))});
  QCOMPARE(shownTexts(*tree.view()), before);
  tree.search()->setText("error");
  tree.search()->clear();
  QCOMPARE(shownTexts(*tree.view()), before);
}

void TestChartGrid::treeDragsGroups() {
  RunSet runs;
  runs.add(fixture::run("1", fixture::ramp(10)));
  SignalTree tree(&runs);
  const QModelIndex rotor1 = tree.view()->model()->index(1, 0);
  const QModelIndex error = tree.view()->model()->index(6, 0);
  const std::unique_ptr<QMimeData> data(
      tree.view()->model()->mimeData({rotor1, rotor1.siblingAtColumn(1), error}));
  QCOMPARE(channelsIn(data.get()), (QStringList{"rotor1.thrust", "error"}));
}

QTEST_MAIN(TestChartGrid)
#include "test_chart_grid.moc"
