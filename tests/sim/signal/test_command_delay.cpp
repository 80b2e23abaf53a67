#include <QtTest>
#include <cmath>

#include "sim/signal/command_delay.h"

using namespace rotorbench;

class TestCommandDelay : public QObject {
  Q_OBJECT
 private slots:
  void actsLaterInOrder() {
    CommandDelay delay(0.25, 0.1);
    QVERIFY(std::isinf(delay.next()));
    delay.give(0.1, 1);
    delay.give(0.2, 2);
    delay.give(0.3, 3);
    QCOMPARE(delay.next(), 0.1 + 0.25);
    QCOMPARE(delay.take(), 1.0);
    QCOMPARE(delay.next(), 0.2 + 0.25);
    QCOMPARE(delay.take(), 2.0);
    QCOMPARE(delay.take(), 3.0);
    QVERIFY(std::isinf(delay.next()));
  }
  void withoutDelayItActsAtOnce() {
    CommandDelay delay(0, 1e-3);
    delay.give(0.5, 0.7);
    QCOMPARE(delay.next(), 0.5);
    QCOMPARE(delay.take(), 0.7);
  }
  void theSameAgainIsNoCommand() {
    CommandDelay delay(1, 0.1);
    delay.give(0, 5);
    delay.give(0.1, 5);
    QCOMPARE(delay.take(), 5.0);
    QVERIFY(std::isinf(delay.next()));
  }
  /// A command every interval for long: the ring goes round and nothing is lost.
  void ringGoesRound() {
    const double interval = 0.01, wait = 0.0637;
    CommandDelay delay(wait, interval);
    double last = -1;
    int taken = 0;
    for (int k = 0; k < 1000; ++k) {
      const double now = k * interval;
      while (delay.next() <= now) {
        const double value = delay.take();
        QCOMPARE(value, last + 1);
        last = value;
        ++taken;
      }
      delay.give(now, k);
    }
    QVERIFY(taken >= 1000 - 8);
  }
};

QTEST_APPLESS_MAIN(TestCommandDelay)
#include "test_command_delay.moc"
