#include <QtTest>
#include <array>
#include <cmath>

#include "sim/analysis/curve_figures.h"

using namespace rotorbench;

namespace {

/// y over x from 0 on in steps of 0.1.
template <class Function>
std::unique_ptr<Recording> curve(int points, Function f) {
  auto r = std::make_unique<Recording>(
      std::vector<Channel>{{"x", "1", "Abscissa"}, {"y", "1", "Ordinate"}});
  for (int k = 0; k < points; ++k) r->append(std::array{0.1 * k, f(0.1 * k)});
  r->publish();
  return r;
}

}  // namespace

class TestCurveFigures : public QObject {
  Q_OBJECT
 private slots:
  /// Between two points of a parabola the peak is exact.
  void peakOfAParabola() {
    const auto r = curve(11, [](double x) { return 3 - 2 * (x - 0.437) * (x - 0.437); });
    const CurvePeak peak = peakOf(*r, 0, 1);
    QVERIFY(std::abs(peak.x - 0.437) < 1e-12);
    QVERIFY(std::abs(peak.y - 3) < 1e-12);
  }
  void noPeakAtAnEnd() {
    QVERIFY(std::isnan(peakOf(*curve(11, [](double x) { return x; }), 0, 1).x));
    QVERIFY(std::isnan(peakOf(*curve(11, [](double x) { return -x; }), 0, 1).y));
    QVERIFY(std::isnan(peakOf(*curve(0, [](double x) { return x; }), 0, 1).y));
  }
  void zeroOfALine() {
    const double zero = fallsThroughZero(*curve(11, [](double x) { return 0.62 - x; }), 0, 1);
    QVERIFY(std::abs(zero - 0.62) < 1e-12);
    QVERIFY(std::isnan(fallsThroughZero(*curve(11, [](double x) { return x - 0.5; }), 0, 1)));
    QVERIFY(std::isnan(fallsThroughZero(*curve(1, [](double x) { return x; }), 0, 1)));
  }
  void extremes() {
    const auto r = curve(11, [](double x) { return x < 0.25 ? 2 * x : -5 * x; });
    QCOMPARE(largestMagnitude(*r, "y"), 5.0);
    QCOMPARE(largestValue(*r, "y"), 0.4);
    QCOMPARE(largestMagnitude(*r, "z"), 0.0);
    QVERIFY(std::isnan(largestValue(*r, "z")));
    QVERIFY(std::isnan(largestValue(*curve(0, [](double x) { return x; }), "y")));
  }
};

QTEST_APPLESS_MAIN(TestCurveFigures)
#include "test_curve_figures.moc"
