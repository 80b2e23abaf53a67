// Marks of axes: round, evenly apart, where they were asked for.
#include <QtTest>
#include <cmath>

#include "sim/core/axis_marks.h"

using namespace rotorbench;

class TestAxisMarks : public QObject {
  Q_OBJECT
 private slots:
  /// 1, 2 or 5 times a power of ten, the smallest with which there are no more parts than asked
  /// for: the next smaller one of these would make more.
  void stepsAreRoundAndAsSmallAsAllowed_data() {
    QTest::addColumn<int>("most");
    for (const int most : {1, 2, 3, 5, 6, 10, 40}) QTest::addRow("%d parts", most) << most;
  }
  void stepsAreRoundAndAsSmallAsAllowed() {
    QFETCH(int, most);
    for (int i = -280; i <= 280; ++i) {
      const double width = 1.1 * std::pow(10.0, 0.37 * i);
      const double step = markStep(width, most);
      const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-6));
      const double digit = step / power;
      const double smaller = std::abs(digit - 5) < 1e-6 ? 2 * power : digit * power / 2;
      QVERIFY2(
          std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6,
          qPrintable(QString::number(step)));
      QVERIFY(width / step <= most * (1 + 1e-8));
      QVERIFY(width / smaller > most * (1 - 1e-8));
    }
  }

  /// Whole multiples, each one step after the other; no further one would fit within, and no fewer
  /// would do around.
  void marksAreAllMultiples() {
    for (const double low : {-1e6, -37.3, -0.2, 0.0, 1e-9, 0.3, 12.0, 98765.4}) {
      for (const double width : {1e-3, 0.1, 1.0, 7.7, 2e4}) {
        for (const int most : {2, 5, 9}) {
          const double high = low + width, step = markStep(width, most), near = 1e-6 * step;
          const auto within = marksWithin(low, high, step), around = marksAround(low, high, step);
          for (const auto& marks : {within, around}) {
            for (std::size_t i = 0; i < marks.size(); ++i) {
              QVERIFY(std::abs(std::remainder(marks[i], step)) < near);
              QVERIFY(i == 0 || std::abs(marks[i] - marks[i - 1] - step) < near);
            }
          }
          for (const double mark : within) QVERIFY(mark > low - near && mark < high + near);
          if (!within.empty()) {
            QVERIFY(within.front() - step < low + near && within.back() + step > high - near);
          }
          QVERIFY(around.size() >= 2);
          QVERIFY(around.front() < low + near && around.front() + step > low - near);
          QVERIFY(around.back() > high - near && around.back() - step < high + near);
          const auto [below, above] = marksBeyond(low, high, step);
          QCOMPARE(below, around.front());
          QCOMPARE(above, around.back());
        }
      }
    }
  }

  /// 0.1 + 0.2 is above 0.3 by rounding, and 0.3 a mark all the same.
  void endsThatAreMarksButForRounding() {
    QCOMPARE(marksWithin(0.1 + 0.2, 0.7, 0.1).size(), std::size_t{5});
    QCOMPARE(marksAround(0, 0.1 + 0.2, 0.1).size(), std::size_t{4});
    QCOMPARE(marksWithin(0.11, 0.19, 0.1).size(), std::size_t{0});
    QVERIFY(!std::signbit(marksAround(-0.01, 0, 0.01).back()));
  }

  /// Neighbouring doubles, between which there are no marks: they come to an end.
  void resolutionOfDoubles() {
    const double high = std::nextafter(1e9, 2e9);
    QVERIFY(marksAround(1e9, high, markStep(high - 1e9, 6)).size() < 100);
  }

  void decimals_data() {
    QTest::addColumn<double>("step");
    QTest::addColumn<int>("decimals");
    QTest::addRow("0.001") << 0.001 << 3;
    QTest::addRow("0.05") << 0.05 << 2;
    QTest::addRow("0.2") << 0.2 << 1;
    QTest::addRow("1") << 1.0 << 0;
    QTest::addRow("5000") << 5000.0 << 0;
  }
  void decimals() {
    QFETCH(double, step);
    QTEST(markDecimals(step), "decimals");
  }
};

QTEST_GUILESS_MAIN(TestAxisMarks)
#include "test_axis_marks.moc"
