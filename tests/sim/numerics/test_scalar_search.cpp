// Roots and extremes of functions that have them in closed form, and what happens where there are
// none.
#include <QtTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sim/numerics/bracketed_root.h"
#include "sim/numerics/scalar_search.h"

using namespace rotorbench;

namespace {

struct Case {
  const char* name;
  double (*f)(double);
  double low, high, root;
};

/// Roots by their closed forms. Steep, flat, with a kink, with a jump, at an end, far from 1.
const Case kCases[]{
    {"parabola", [](double x) { return x * x - 2; }, 0, 2, std::numbers::sqrt2},
    {"cosine", [](double x) { return std::cos(x); }, 0, 3, std::numbers::pi / 2},
    {"steep", [](double x) { return std::exp(x) - 1e6; }, 0, 100, std::log(1e6)},
    {"flat", [](double x) { return std::pow(x - 0.3, 9); }, 0, 1, 0.3},
    {"kink", [](double x) { return std::min(1e-3 * (x - 0.2), 50 * (x - 0.2)); }, -1, 1, 0.2},
    {"jump", [](double x) { return x < 0.7 ? -1.0 : 2.0; }, 0, 1, 0.7},
    {"falls", [](double x) { return 1 - x; }, 0, 5, 1},
    {"at the lower end", [](double x) { return x; }, 0, 1, 0},
    {"at the upper end", [](double x) { return x - 1; }, 0, 1, 1},
    {"large numbers", [](double x) { return 1e-20 * (x - 3e8); }, -1e9, 1e9, 3e8},
};

}  // namespace

class TestScalarSearch : public QObject {
  Q_OBJECT
 private slots:
  void roots_data() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < int(std::size(kCases)); ++i) QTest::addRow("%s", kCases[i].name) << i;
  }
  /// As near as asked for, and no call outside the interval. The search that is inlined in loops
  /// agrees.
  void roots() {
    QFETCH(int, index);
    const Case& c = kCases[index];
    const double low = c.low, high = c.high;
    const ScalarFunction given = c.f;
    int calls = 0;
    const auto f = [&](double x) {
      ++calls;
      if (x < low || x > high) throw std::out_of_range("outside the interval");
      return given(x);
    };
    for (const double part : {1e-3, 1e-6, 1e-12}) {
      const double tolerance = part * (high - low);
      calls = 0;
      const double root = findRoot(f, low, high, tolerance);
      QVERIFY2(std::abs(root - c.root) <= tolerance * (1 + 1e-9),
               qPrintable(QString::number(root, 'g', 17)));
      QVERIFY2(calls <= 310, qPrintable(QString::number(calls)));
      QCOMPARE(findRoot(f, low, f(low), high, f(high), tolerance), root);
      const double inlined = bracketedRoot(f, low, f(low), high, f(high), tolerance);
      QVERIFY(std::abs(inlined - root) <= 4 * tolerance);
    }
  }

  /// Fewer than half of the 40 calls that halving the interval takes.
  void smoothFunctionsTakeFewCalls() {
    int calls = 0;
    findRoot([&](double x) { return ++calls, std::exp(-x) - 0.1 * x; }, 0, 10, 1e-11);
    QVERIFY2(calls < 20, qPrintable(QString::number(calls)));
  }

  void whereThereIsNoRootTheNearerEnd() {
    QCOMPARE(findRoot([](double x) { return x + 1; }, 0, 4, 1e-9), 0.0);
    QCOMPARE(findRoot([](double x) { return x - 5; }, 0, 4, 1e-9), 4.0);
    QCOMPARE(findRoot([](double x) { return x; }, 2, 2, 1e-9), 2.0);
  }

  void extremes_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<double>("at");
    QTest::addRow("between") << -3.0 << 2.0 << 0.4;
    QTest::addRow("near an end") << 0.399 << 50.0 << 0.4;
    QTest::addRow("at the upper end") << -2.0 << 0.1 << 0.1;
    QTest::addRow("at the lower end") << 1.0 << 3.0 << 1.0;
    QTest::addRow("far from 0") << -1e6 << 1.0 << 0.4;
  }
  /// cosh(x - 0.4), least at 0.4 or at the end nearest to it; the greatest of its negative stands
  /// in the same place.
  void extremes() {
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(double, at);
    const double scale = high - low;
    const auto f = [&](double x) { return std::cosh((x - 0.4) / scale) - 3; };
    for (const double part : {1e-2, 1e-4, 1e-7}) {
      // Values within rounding of the least one are least too, a root of the resolution wide.
      const double tolerance = part * scale, flat = 3e-8 * scale;
      const Extremum least = findMinimum(f, low, high, tolerance);
      QVERIFY2(std::abs(least.at - at) <= tolerance + flat,
               qPrintable(QString::number(least.at, 'g', 17)));
      QCOMPARE(least.value, f(least.at));
      const Extremum most = findMaximum([&](double x) { return -f(x); }, low, high, tolerance);
      QCOMPARE(most.at, least.at);
      QCOMPARE(most.value, -least.value);
    }
  }

  /// x^2 from 1 on, and nothing below or at the ends.
  void valuesThatAreNotFiniteAreAvoided() {
    for (const double none : {HUGE_VAL, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
      const auto f = [&](double x) { return x < 1 || x > 2.9 ? none : x * x; };
      const Extremum least = findMinimum(f, 0, 3, 1e-6);
      QVERIFY2(std::abs(least.at - 1) < 1e-5, qPrintable(QString::number(least.at)));
      QVERIFY(std::isfinite(least.value));
      QCOMPARE(findMinimum([&](double) { return none; }, 0, 1, 1e-3).value, HUGE_VAL);
      QCOMPARE(findMaximum([&](double) { return none; }, 0, 1, 1e-3).value, -HUGE_VAL);
    }
  }

  void lastPlaceWhereAConditionHolds() {
    const auto below = [](double x) { return x <= 0.3; };
    QCOMPARE(findLast(below, 0, 1), 0.3);
    QCOMPARE(findLast([](double) { return false; }, 2, 3), 2.0);
    const double all = findLast([](double) { return true; }, 2, 3);
    QVERIFY(all <= 3 && all > 3 - 1e-15);
  }
};

QTEST_GUILESS_MAIN(TestScalarSearch)
#include "test_scalar_search.moc"
