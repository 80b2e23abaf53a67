// The playback bar by clicks and keys, and what a person reads on it.
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "ui/scene/playback_bar.h"

using namespace rotorbench;

class TestPlaybackBar : public QObject {
  Q_OBJECT

  std::unique_ptr<PlaybackBar> bar_;
  template <class T>
  T* find(const char* name) {
    T* widget = bar_->findChild<T*>(QLatin1String(name));
    if (!widget) qFatal("no %s", name);
    return widget;
  }
  QString label() { return find<QLabel>("timeLabel")->text(); }
  void click(const char* name) { QTest::mouseClick(find<QToolButton>(name), Qt::LeftButton); }

 private slots:
  void init() {
    bar_ = std::make_unique<PlaybackBar>();
    bar_->resize(500, 40);
    bar_->setRange(0, 10, false);
    bar_->show();
    QVERIFY(QTest::qWaitForWindowActive(bar_.get()));
  }
  void cleanup() { bar_.reset(); }

  void hasNothingToPlayAtFirst() {
    PlaybackBar empty;
    QVERIFY(!empty.findChild<QToolButton*>("playButton")->isEnabled());
    QVERIFY(!empty.findChild<QSlider*>("timeSlider")->isEnabled());
    empty.setPlaying(true);
    QVERIFY(!empty.isPlaying());
  }

  void playsPausesAndSaysSo() {
    QSignalSpy times(bar_.get(), &PlaybackBar::timeChanged);
    QCOMPARE(find<QToolButton>("playButton")->accessibleName(), QStringLiteral("Play"));
    click("playButton");
    QCOMPARE(find<QToolButton>("playButton")->accessibleName(), QStringLiteral("Pause"));
    QTRY_VERIFY(bar_->time() > 0.1);
    QVERIFY(times.count() > 1);
    QVERIFY(find<QSlider>("timeSlider")->value() > 0);
    click("playButton");
    QVERIFY(!bar_->isPlaying());
    const double stopped = bar_->time();
    QTest::qWait(80);  // long enough for two steps if it still ran
    QCOMPARE(bar_->time(), stopped);
  }

  void playsAtTheChosenSpeed() {
    find<QComboBox>("speedBox")->setFocus();
    QTest::keyClick(find<QComboBox>("speedBox"), Qt::Key_End);
    QCOMPARE(bar_->speed(), 10.0);
    QElapsedTimer clock;
    clock.start();
    click("playButton");
    QTRY_VERIFY(bar_->time() > 3.0);
    const double rate = bar_->time() / (1e-3 * static_cast<double>(clock.elapsed()));
    QVERIFY2(rate > 5 && rate < 10.5, qPrintable(QString::number(rate)));
    QTest::keyClick(find<QComboBox>("speedBox"), Qt::Key_Home);
    QCOMPARE(bar_->speed(), 0.1);
  }

  void stopsAtTheEndOrLoops_data() {
    QTest::addColumn<bool>("loop");
    QTest::addRow("stop") << false;
    QTest::addRow("loop") << true;
  }

  void stopsAtTheEndOrLoops() {
    QFETCH(bool, loop);
    if (loop) click("loopButton");
    QCOMPARE(bar_->isLooping(), loop);
    bar_->setTime(9.95);
    click("playButton");
    if (loop) {
      QTRY_VERIFY(bar_->time() < 5);
      QVERIFY(bar_->isPlaying());
    } else {
      QTRY_VERIFY(!bar_->isPlaying());
      QCOMPARE(bar_->time(), 10.0);
      QCOMPARE(label(), QStringLiteral("10.00 / 10.00 s"));
      click("playButton");
      QVERIFY(bar_->isPlaying());
      QVERIFY(bar_->time() < 1);
    }
  }

  void scrubsByKeysAndMouse() {
    QSignalSpy times(bar_.get(), &PlaybackBar::timeChanged);
    QSlider* slider = find<QSlider>("timeSlider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(std::abs(bar_->time() - 0.05) < 1e-9);
    QTest::keyClick(slider, Qt::Key_PageUp);
    QVERIFY(std::abs(bar_->time() - 0.55) < 1e-9);
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(bar_->time(), 10.0);
    QTest::keyClick(slider, Qt::Key_Home);
    QCOMPARE(bar_->time(), 0.0);
    QCOMPARE(times.count(), 4);
    QTest::mouseClick(slider, Qt::LeftButton, {}, slider->rect().center());
    QVERIFY(bar_->time() > 0);
  }

  void isReachableByKeyboard() {
    find<QToolButton>("playButton")->setFocus();
    QTest::keyClick(find<QToolButton>("playButton"), Qt::Key_Space);
    QVERIFY(bar_->isPlaying());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), find<QSlider>("timeSlider"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), find<QComboBox>("speedBox"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), find<QToolButton>("loopButton"));
  }

  void setTimeTellsOnceAndKeepsToTheRange() {
    QSignalSpy times(bar_.get(), &PlaybackBar::timeChanged);
    bar_->setTime(4.25);
    bar_->setTime(4.25);
    QCOMPARE(times.count(), 1);
    QCOMPARE(times[0][0].toDouble(), 4.25);
    QCOMPARE(label(), QStringLiteral("4.25 / 10.00 s"));
    bar_->setTime(99);
    QCOMPARE(bar_->time(), 10.0);
    bar_->setTime(-99);
    QCOMPARE(bar_->time(), 0.0);
    bar_->setTime(std::nan(""));
    QCOMPARE(bar_->time(), 0.0);
  }

  void twoTiedTimesDoNotChaseEachOther() {
    PlaybackBar other;
    other.setRange(0, 10, false);
    connect(bar_.get(), &PlaybackBar::timeChanged, &other, &PlaybackBar::setTime);
    connect(&other, &PlaybackBar::timeChanged, bar_.get(), &PlaybackBar::setTime);
    bar_->setTime(3.3333333333);
    QCOMPARE(other.time(), 3.3333333333);
    QCOMPARE(bar_->time(), 3.3333333333);
  }

  void followsAGrowingRunUntilTheUserLooksElsewhere() {
    bar_->setRange(0, 1, true);
    click("followButton");
    QVERIFY(bar_->isFollowing());
    QCOMPARE(bar_->time(), 1.0);
    bar_->setRange(0, 2.5, true);
    QCOMPARE(bar_->time(), 2.5);
    QTest::keyClick(find<QSlider>("timeSlider"), Qt::Key_Home);
    QVERIFY(!bar_->isFollowing());
    bar_->setRange(0, 4, true);
    QCOMPARE(bar_->time(), 0.0);
  }

  void namesEveryControl() {
    for (const QWidget* widget :
         bar_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
      QVERIFY(!widget->objectName().isEmpty());
      QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
    }
  }
};

QTEST_MAIN(TestPlaybackBar)
#include "test_playback_bar.moc"
