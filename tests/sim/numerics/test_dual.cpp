#include <QtTest>
#include <cmath>
#include <functional>

#include "sim/core/scalar.h"
#include "sim/numerics/dual.h"
#include "sim/numerics/least_norm.h"

using namespace rotorbench;

using Function = std::function<Dual(const Dual&)>;
Q_DECLARE_METATYPE(Function)

class TestDual : public QObject {
  Q_OBJECT
 private slots:
  void slopes_data();
  void slopes();
  void inVectors();
  void leastNorm();
};

void TestDual::slopes_data() {
  QTest::addColumn<Function>("f");
  const auto row = [](const char* name, const Function& f) { QTest::addRow("%s", name) << f; };
  row("sum", [](const Dual& x) { return 3 + x + x - 2; });
  row("negative", [](const Dual& x) { return -x - 0.5 * x; });
  row("product", [](const Dual& x) { return x * x * 2; });
  row("quotient", [](const Dual& x) { return (1 + x) / (2 - x * x); });
  row("over", [](const Dual& x) { return 5 / x; });
  row("in place", [](Dual x) {
    x += x * x;
    x *= 3;
    x -= 1 / x;
    x /= 2 + x;
    return x;
  });
  row("abs", [](const Dual& x) { return abs(x - 2); });
  row("sqrt", [](const Dual& x) { return sqrt(1 + x); });
  row("exp", [](const Dual& x) { return exp(-x); });
  row("log", [](const Dual& x) { return log(x * x); });
  row("pow", [](const Dual& x) { return pow(x, 2.7); });
  row("sin", [](const Dual& x) { return sin(2 * x); });
  row("cos", [](const Dual& x) { return cos(x * x); });
  row("tan", [](const Dual& x) { return tan(x); });
  row("asin", [](const Dual& x) { return asin(x / 2); });
  row("atan2", [](const Dual& x) { return atan2(x, 2 * x - 3); });
  row("max", [](const Dual& x) { return std::max(x, Dual(0.5)) * std::min(x, Dual(9)); });
}

/// Against central differences.
void TestDual::slopes() {
  QFETCH(Function, f);
  for (const double x : {0.7, 1.3}) {
    const double step = 1e-6;
    const double difference = (f(x + step).value() - f(x - step).value()) / (2 * step);
    const Dual exact = f(Dual(x, 1));
    QVERIFY(std::abs(exact.slope() - difference) < 1e-8 * std::max(1.0, std::abs(difference)));
    QCOMPARE(exact.value(), f(x).value());
    QCOMPARE(valueOf(exact), exact.value());
    // Linear in the direction.
    QVERIFY(std::abs(f(Dual(x, -2)).slope() + 2 * exact.slope()) <
            1e-13 * (1 + std::abs(exact.slope())));
  }
}

/// As the scalar of Eigen's vectors, beside numbers.
void TestDual::inVectors() {
  Eigen::Array<Dual, 3, 1> x(Dual(1, 1), Dual(2, 0), Dual(3, -1));
  const Eigen::Array3d weights(2, 3, 4);
  const Dual sum = (weights * x * x).sum();
  QCOMPARE(sum.value(), 2.0 + 12 + 36);
  QCOMPARE(sum.slope(), 2 * 2 * 1.0 - 2 * 4 * 3.0);
  QCOMPARE(Eigen::Vector3d(1, 2, 3).cast<Dual>().eval().squaredNorm().value(), 14.0);
}

/// Of all solutions the shortest; without one, the nearest.
void TestDual::leastNorm() {
  Eigen::MatrixXd flat(1, 2);
  flat << 3, 4;
  const Eigen::VectorXd x = leastNormSolution(flat, Eigen::VectorXd::Constant(1, 25));
  QVERIFY((x - Eigen::Vector2d(3, 4)).norm() < 1e-13);
  Eigen::MatrixXd rank(3, 2);
  rank << 1, 1, 1, 1, 0, 0;
  const Eigen::VectorXd y = leastNormSolution(rank, Eigen::Vector3d(1, 3, 7));
  QVERIFY((y - Eigen::Vector2d(1, 1)).norm() < 1e-13);
}

QTEST_APPLESS_MAIN(TestDual)
#include "test_dual.moc"
