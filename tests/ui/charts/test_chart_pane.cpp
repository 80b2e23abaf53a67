// A chart as a person uses it: wheel, band, pan, fit, back, cursors, legend, channels dropped and
// removed, while a run is written.
#include <QAbstractButton>
#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <atomic>
#include <thread>

#include "chart_fixture.h"
#include "ui/charts/channel_mime.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/chart_pane.h"

using namespace rotorbench;

namespace {

ChartSpec thrustSpec() {
  return {"Thrust", ChartKind::Time, "", "rotor*.thrust", false, false, false};
}

QPoint at(const ChartPane& pane, double unitX, double unitY) {
  const QRectF plot = pane.plot()->plotLayout().plot;
  return QPointF(plot.left() + unitX * plot.width(), plot.bottom() - unitY * plot.height())
      .toPoint();
}

void wheel(QWidget* widget, QPoint place, int notches, Qt::KeyboardModifiers keys = {}) {
  QWheelEvent event(place, widget->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, keys,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &event);
}

void drag(QWidget* widget, Qt::MouseButton button, QPoint from, QPoint to,
          Qt::KeyboardModifiers keys = {}) {
  QTest::mousePress(widget, button, keys, from);
  for (int i = 1; i <= 4; ++i) {
    const QPoint place = from + (to - from) * i / 4;
    QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button,
                     keys);
    QApplication::sendEvent(widget, &move);
  }
  QTest::mouseRelease(widget, button, keys, to);
}

QStringList texts(const ChartPane& pane) {
  QStringList all;
  for (const auto* item : pane.legend()->items()) all += item->text();
  return all;
}

/// Runs, link and one pane on the screen.
struct Bench {
  RunSet runs;
  ChartLink link;
  ChartPane pane{&runs, &link};
  explicit Bench(const ChartSpec& spec = thrustSpec(), bool withRun = true) {
    if (withRun) runs.add(fixture::run("1", fixture::ramp(10001)));
    pane.setSpec(spec);
    pane.resize(700, 420);
    pane.show();
    if (!QTest::qWaitForWindowExposed(&pane)) qFatal("not shown");
    while (pane.refresh()) {
    }
  }
  void settle() {
    while (pane.refresh()) {
    }
  }
  [[nodiscard]] Span x() const { return pane.plot()->frame().x.scale.span; }
  [[nodiscard]] Span y(std::size_t i = 0) const { return pane.plot()->frame().y.at(i).scale.span; }
};

bool close(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

class TestChartPane : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { QVERIFY(QApplication::topLevelWidgets().isEmpty()); }
  void showsWhatThereIs();
  void saysWhatToDoNext();
  void fillsWhileWriting();
  void wheelZoomsTimeAtThePointer();
  void wheelOverAnAxisZoomsThatAxis();
  void bandThenBackThenFit();
  void thinBandZoomsOneAxis();
  void panByMiddleOrShift_data();
  void panByMiddleOrShift();
  void linkedTimeAxes();
  void followKeepsItsWidth();
  void cursorsReadThePreviousSample();
  void cursorDraggedAndMovedByKey();
  void xyChartMarksTheCursorTime();
  void legendHidesAndRemembers();
  void channelsDroppedAndRemoved();
  void titleEdited();
  void logAxis();
  void germanLabels();
  void darkPalette();
};

void TestChartPane::showsWhatThereIs() {
  Bench b;
  const ChartFrame& frame = b.pane.plot()->frame();
  QCOMPARE(frame.curves.size(), std::size_t{4});
  QCOMPARE(b.x(), (Span{0, 10}));
  QCOMPARE(b.y(), (Span{1, 14}));  // 1 + 0 to 4 + 10
  QCOMPARE(frame.x.title, QStringLiteral("time [s]"));
  QCOMPARE(frame.y[0].title, QStringLiteral("thrust [N]"));
  QCOMPARE(texts(b.pane),
           (QStringList{"rotor1.thrust", "rotor2.thrust", "rotor3.thrust", "rotor4.thrust"}));
  for (const auto& curve : frame.curves) {
    QVERIFY(curve.points.size() > 500);
    QVERIFY(curve.points.size() <= 2 * (700 + 4));
  }
  b.pane.setSpec(
      {"", ChartKind::Time, "", "rotor1.thrust, position.x, error", false, false, false});
  b.settle();
  QCOMPARE(b.pane.plot()->frame().y.size(), std::size_t{2});  // N and m
  QCOMPARE(b.pane.plot()->frame().y[1].title, QStringLiteral("x, error [m]"));
}

void TestChartPane::saysWhatToDoNext() {
  Bench b({}, false);
  QCOMPARE(b.pane.plot()->hint(),
           QStringLiteral("Drag channels here from the signal tree, or double-click one there."));
  b.pane.addChannel("wind.x");
  QCOMPARE(b.pane.plot()->hint(), QStringLiteral("Press Run (F5) to fill this chart."));
  b.runs.add(fixture::run("1", fixture::ramp(10)));
  QCOMPARE(b.pane.plot()->hint(), QStringLiteral("The shown runs have no channel wind.x."));
  b.pane.addChannel("error");
  QCOMPARE(b.pane.plot()->hint(), QString());
}

void TestChartPane::fillsWhileWriting() {
  auto recording = std::make_shared<Recording>(fixture::channels());
  Bench b(thrustSpec(), false);
  b.runs.add(fixture::run("1", recording));
  std::atomic<bool> half{false};
  std::atomic<bool> goOn{false};
  std::thread writer([&] {
    for (int i = 0; i < 20000; ++i) {
      fixture::appendRow(*recording, i * 0.001);
      if (i % 100 == 0) recording->publish();
      if (i == 10000) {
        half = true;
        while (!goOn) std::this_thread::yield();
      }
    }
    recording->finish();
  });
  QTRY_VERIFY(half);
  b.settle();
  QVERIFY(close(b.pane.plot()->frame().curves[0].points.last().x(), 10, 0.1));
  goOn = true;
  QTRY_VERIFY(recording->finished());
  writer.join();
  b.settle();
  QCOMPARE(b.pane.plot()->frame().curves[0].points.last(),
           QPointF(19999 * 0.001, 1 + 19999 * 0.001));
  QVERIFY(close(b.x().high, 19.999, 1e-9));
}

void TestChartPane::wheelZoomsTimeAtThePointer() {
  Bench b;
  wheel(b.pane.plot(), at(b.pane, 0.25, 0.5), 1);
  b.settle();
  QVERIFY(close(b.x().width(), 8, 1e-9));
  QVERIFY(close(b.x().low + 0.25 * b.x().width(), 2.5, 0.02));
  QVERIFY(b.pane.view().y.empty());
  wheel(b.pane.plot(), at(b.pane, 0.25, 0.5), -1);
  b.settle();
  QVERIFY(close(b.x().width(), 10, 1e-9));
}

void TestChartPane::wheelOverAnAxisZoomsThatAxis() {
  Bench b({"", ChartKind::Time, "", "rotor1.thrust, position.x", false, false, false});
  const Span left = b.y(0);
  const Span right = b.y(1);
  const QPointF overRight = b.pane.plot()->plotLayout().yStrips[1].center();
  wheel(b.pane.plot(), overRight.toPoint(), 2);
  b.settle();
  QCOMPARE(b.y(0), left);
  QVERIFY(close(b.y(1).width(), right.width() * 0.64, 1e-9));
  QVERIFY(!b.pane.view().x);
  wheel(b.pane.plot(),
        QPoint(350, static_cast<int>(b.pane.plot()->plotLayout().xStrip.center().y())), 1);
  b.settle();
  QVERIFY(close(b.x().width(), 8, 1e-9));
  QVERIFY(close(b.y(1).width(), right.width() * 0.64, 1e-9));
}

void TestChartPane::bandThenBackThenFit() {
  Bench b;
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.2, 0.8), at(b.pane, 0.6, 0.4));
  b.settle();
  QVERIFY(close(b.x().low, 2, 0.03) && close(b.x().high, 6, 0.03));
  QVERIFY(close(b.y().low, 1 + 0.4 * 13, 0.1) && close(b.y().high, 1 + 0.8 * 13, 0.1));
  const Span first = b.x();
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.5, 0.9), at(b.pane, 0.75, 0.1));
  b.settle();
  QVERIFY(close(b.x().width(), 1, 0.03));
  QTest::mouseClick(b.pane.plot(), Qt::RightButton, {}, at(b.pane, 0.5, 0.5));
  b.settle();
  QCOMPARE(b.x(), first);
  QTest::keyClick(b.pane.plot(), Qt::Key_Backspace);
  b.settle();
  QCOMPARE(b.x(), (Span{0, 10}));
  QCOMPARE(b.y(), (Span{1, 14}));
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.2, 0.8), at(b.pane, 0.6, 0.4));
  QTest::keyClick(b.pane.plot(), Qt::Key_F);
  b.settle();
  QCOMPARE(b.x(), (Span{0, 10}));
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.2, 0.8), at(b.pane, 0.6, 0.4));
  b.settle();
  QTest::mouseDClick(b.pane.plot(), Qt::LeftButton, {}, at(b.pane, 0.5, 0.5));
  b.settle();
  QCOMPARE(b.x(), (Span{0, 10}));
  QVERIFY(!b.link.cursor(Cursor::A));
}

void TestChartPane::thinBandZoomsOneAxis() {
  Bench b;
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.2, 0.5), at(b.pane, 0.6, 0.5));
  b.settle();
  QVERIFY(close(b.x().width(), 4, 0.05));
  QVERIFY(b.pane.view().y.empty());
}

void TestChartPane::panByMiddleOrShift_data() {
  QTest::addColumn<Qt::MouseButton>("button");
  QTest::addColumn<Qt::KeyboardModifiers>("keys");
  QTest::addRow("middle") << Qt::MiddleButton << Qt::KeyboardModifiers();
  QTest::addRow("shift and left") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
}

void TestChartPane::panByMiddleOrShift() {
  QFETCH(Qt::MouseButton, button);
  QFETCH(Qt::KeyboardModifiers, keys);
  Bench b;
  b.pane.setView({Span{2, 6}, {}});
  b.settle();
  drag(b.pane.plot(), button, at(b.pane, 0.5, 0.5), at(b.pane, 0.25, 0.5), keys);
  b.settle();
  QVERIFY(close(b.x().low, 3, 0.03) && close(b.x().width(), 4, 1e-9));
  QTest::keyClick(b.pane.plot(), Qt::Key_Backspace);
  b.settle();
  QCOMPARE(b.x(), (Span{2, 6}));
}

void TestChartPane::linkedTimeAxes() {
  Bench b;
  ChartPane other(&b.runs, &b.link);
  other.setSpec({"", ChartKind::Time, "", "error", false, true, false});
  other.resize(600, 300);
  other.show();
  wheel(b.pane.plot(), at(b.pane, 0.5, 0.5), 3);
  other.refresh();
  b.settle();
  QCOMPARE(other.plot()->frame().x.scale.span, b.x());
  QVERIFY(other.back());  // nothing of its own to undo: the whole time again
  b.settle();
  QCOMPARE(b.x(), (Span{0, 10}));
}

void TestChartPane::followKeepsItsWidth() {
  Bench b;
  b.link.setTimeRange(Span{0, 2});
  b.link.setFollows(true);
  b.link.newestTime(9);
  b.settle();
  QCOMPARE(b.x(), (Span{7, 9}));
  drag(b.pane.plot(), Qt::MiddleButton, at(b.pane, 0.5, 0.5), at(b.pane, 0.7, 0.5));
  QVERIFY(!b.link.follows());
}

void TestChartPane::cursorsReadThePreviousSample() {
  RunSet runs;
  ChartLink link;
  ChartPane pane(&runs, &link);
  runs.add(fixture::run("1", fixture::ramp(11)));  // samples at 0, 1, ... 10 s
  pane.setSpec(thrustSpec());
  pane.resize(700, 420);
  pane.show();
  QVERIFY(QTest::qWaitForWindowExposed(&pane));
  pane.refresh();
  QSignalSpy moved(&link, &ChartLink::timeCursorMoved);
  QTest::mouseClick(pane.plot(), Qt::LeftButton, {}, at(pane, 0.26, 0.5));
  QCOMPARE(moved.size(), 1);
  QVERIFY(close(moved[0][0].toDouble(), 2.6, 0.02));
  // The last sample not after 2.6 s is that at 2 s: 1 + 2.
  QCOMPARE(pane.legend()->items()[0]->cells(), QStringList{"3 N"});
  QTest::mouseClick(pane.plot(), Qt::LeftButton, Qt::ControlModifier, at(pane, 0.87, 0.5));
  QCOMPARE(pane.legend()->items()[3]->cells(), (QStringList{"6 N", "12 N", "6 N"}));
  QCOMPARE(pane.legend()->heads().size(), 3);
  QVERIFY(pane.legend()->heads()[0].startsWith("A  2."));
  QVERIFY(pane.legend()->items()[3]->accessibleDescription().contains("12 N"));
  QTest::keyClick(pane.plot(), Qt::Key_Escape);
  QVERIFY(pane.legend()->heads().isEmpty());
}

void TestChartPane::cursorDraggedAndMovedByKey() {
  Bench b;
  b.link.setCursor(Cursor::A, 5.0);
  drag(b.pane.plot(), Qt::LeftButton, at(b.pane, 0.5, 0.5), at(b.pane, 0.8, 0.5));
  QVERIFY(close(*b.link.cursor(Cursor::A), 8, 0.03));
  QCOMPARE(b.x(), (Span{0, 10}));
  const double before = *b.link.cursor(Cursor::A);
  QTest::keyClick(b.pane.plot(), Qt::Key_Left);
  QVERIFY(*b.link.cursor(Cursor::A) < before);
  QVERIFY(close(*b.link.cursor(Cursor::A), before, 0.05));
}

void TestChartPane::xyChartMarksTheCursorTime() {
  Bench b({"", ChartKind::XY, "rotor1.thrust", "position.x", false, false, false});
  QCOMPARE(b.pane.plot()->frame().x.title, QStringLiteral("rotor1.thrust [N]"));
  QCOMPARE(b.y(), (Span{-20, 0}));
  const QImage before = b.pane.plot()->grab().toImage();
  b.link.setCursor(Cursor::A, 4.0);
  const QImage after = b.pane.plot()->grab().toImage();
  // The ring is drawn around thrust 5, position -8.
  const auto& frame = b.pane.plot()->frame();
  const QPoint ring = at(b.pane, frame.x.scale.toUnit(5), frame.y[0].scale.toUnit(-8));
  const QRect around(ring - QPoint(7, 7), QSize(15, 15));
  QVERIFY(before.copy(around) != after.copy(around));
  QVERIFY(before.copy(0, 0, 60, 300) == after.copy(0, 0, 60, 300));
}

void TestChartPane::legendHidesAndRemembers() {
  Bench b;
  QTest::mouseClick(b.pane.legend()->items()[3], Qt::LeftButton);
  b.settle();
  QVERIFY(b.pane.plot()->frame().curves[3].hidden);
  QVERIFY(b.pane.plot()->frame().curves[3].points.isEmpty());
  QVERIFY(b.pane.legend()->items()[3]->accessibleName().contains("hidden"));
  QCOMPARE(b.y().high, 13.0);                               // fits the three that are left
  b.runs.setRuns({fixture::run("2", fixture::ramp(101))});  // run again
  QVERIFY(b.pane.curves().curves[3].hidden);
  QVERIFY(!b.pane.curves().curves[2].hidden);
  b.runs.add(fixture::run("3", fixture::ramp(101)));
  QCOMPARE(b.pane.legend()->items().size(), std::size_t{8});
  QTest::mouseClick(b.pane.legend()->items()[3], Qt::LeftButton);
  QVERIFY(!b.pane.curves().curves[3].hidden);
  QVERIFY(b.pane.curves().curves[7].hidden);
  QTest::keyClick(b.pane.legend()->items()[7], Qt::Key_Return);
  QVERIFY(!b.pane.curves().curves[7].hidden);
}

void TestChartPane::channelsDroppedAndRemoved() {
  Bench b;
  QSignalSpy edited(&b.pane, &ChartPane::specChanged);
  const auto data = channelMimeData({"position.x", "rotor2.thrust"});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(&b.pane, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(&b.pane, &drop);
  QCOMPARE(edited.size(), 1);
  QCOMPARE(b.pane.spec().channels, std::string("rotor*.thrust, position.x"));
  QCOMPARE(texts(b.pane).last(), QStringLiteral("position.x"));
  QMimeData text;
  text.setText("position.x");
  QDragEnterEvent foreign({50, 50}, Qt::CopyAction, &text, Qt::LeftButton, {});
  QApplication::sendEvent(&b.pane, &foreign);
  QVERIFY(!foreign.isAccepted());

  QTest::keyClick(b.pane.legend()->items()[1], Qt::Key_Delete);
  QCOMPARE(texts(b.pane),
           (QStringList{"rotor1.thrust", "rotor3.thrust", "rotor4.thrust", "position.x"}));
  emit b.pane.menu()->aboutToShow();
  auto* remove = b.pane.menu()->findChild<QMenu*>("removeChannelMenu");
  QCOMPARE(remove->actions().size(), 4);
  remove->actions().last()->trigger();
  QCOMPARE(texts(b.pane).size(), 3);
}

void TestChartPane::titleEdited() {
  Bench b;
  QSignalSpy edited(&b.pane, &ChartPane::specChanged);
  auto* title = b.pane.findChild<QLineEdit*>("chartTitle");
  QCOMPARE(title->text(), QStringLiteral("Thrust"));
  title->selectAll();
  QTest::keyClicks(title, "Front rotors");
  QTest::keyClick(title, Qt::Key_Return);
  QCOMPARE(edited.size(), 1);
  QCOMPARE(b.pane.spec().title, std::string("Front rotors"));
}

void TestChartPane::logAxis() {
  Bench b({"", ChartKind::Time, "", "error", false, true, false});
  QCOMPARE(b.y(), (Span{1e-10, 1}));
  QStringList labels;
  for (const auto& tick : b.pane.plot()->frame().y[0].ticks.major) labels += tick.label;
  QVERIFY2(labels.contains("10⁻¹⁰"), qPrintable(labels.join(' ')));
  // A negative channel has no logarithm: an empty, usable axis.
  b.pane.setSpec({"", ChartKind::Time, "", "position.x", false, true, false});
  b.settle();
  QVERIFY(b.pane.plot()->frame().curves[0].points.isEmpty());
  QCOMPARE(b.y(), (Span{0.1, 1}));
  emit b.pane.menu()->aboutToShow();
  b.pane.menu()->findChild<QAction*>("logY")->trigger();
  b.settle();
  QCOMPARE(b.y(), (Span{-20, 0}));
}

void TestChartPane::germanLabels() {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  {
    Bench b({"", ChartKind::Time, "", "error", false, false, false});
    b.link.setCursor(Cursor::A, 0.0);
    QStringList labels;
    for (const auto& tick : b.pane.plot()->frame().y[0].ticks.major) labels += tick.label;
    QVERIFY2(labels.contains("0,2"), qPrintable(labels.join(' ')));
    b.link.setCursor(Cursor::A, 0.3);
    QVERIFY(b.pane.legend()->items()[0]->cells()[0].startsWith("0,501"));  // 10^-0.3
  }
  QLocale::setDefault(before);
}

void TestChartPane::darkPalette() {
  Bench b;
  const QImage light = b.pane.plot()->grab().toImage();
  QVERIFY(light.pixelColor(1, 1).lightness() > 200);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(27, 30, 32));
  dark.setColor(QPalette::Text, QColor(250, 250, 250));
  b.pane.setPalette(dark);
  b.settle();
  const QImage image = b.pane.plot()->grab().toImage();
  QCOMPARE(image.pixelColor(1, 1), QColor(27, 30, 32));
}

QTEST_MAIN(TestChartPane)
#include "test_chart_pane.moc"
