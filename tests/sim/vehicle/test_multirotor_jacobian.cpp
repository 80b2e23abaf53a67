#include <Eigen/Core>  // AutoDiff does not include it itself
#include <QtTest>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "sim/vehicle/multirotor.h"

using namespace rotorbench;
using Plant = Multirotor<4>;
constexpr int kInputs = Plant::kStates + 4;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, kInputs, 1>>;

class TestMultirotorJacobian : public QObject {
  Q_OBJECT
 private slots:
  void exactJacobianEqualsCentralDifferences_data();
  void exactJacobianEqualsCentralDifferences();
};

void TestMultirotorJacobian::exactJacobianEqualsCentralDifferences_data() {
  QTest::addColumn<bool>("moving");
  QTest::addRow("hover") << false;
  QTest::addRow("fast turning flight") << true;
}

void TestMultirotorJacobian::exactJacobianEqualsCentralDifferences() {
  QFETCH(bool, moving);
  VehicleParameters v;
  RotorCoefficients rotor;
  rotor.inflow.flapping = 1e-5;
  std::get<EqualRotors>(v.rotors).rotor.aerodynamics = rotor;
  v.drag = {0.05, {0.01, 0.02, 0.03}, {0.001, 0.002, 0.003}};
  std::get<SupplyParameters>(v.supply).internalResistance = 0.03;
  v.deviations = {{2, {0.01, 0.02, 0.03}, 0.02}};
  Plant plant(buildMultirotor<4>(v, {}));
  FlightStart start;
  if (moving) {
    start.velocity = {5, -3, 2};
    start.attitude = {0.4, -0.3, 1};
    start.rates = {1, -2, 3};
  }
  Eigen::Matrix<double, kInputs, 1> x;
  x << plant.initialState(start), 0.5, 0.6, 0.4, 0.7;

  const auto evaluate = [&](const auto& in) {
    using S = typename std::decay_t<decltype(in)>::Scalar;
    Plant::StateOf<S> y = in.template head<Plant::kStates>(), d;
    Plant::CommandOf<S> u = in.template tail<4>();
    plant.derivative(u, y, d);
    return d;
  };
  Eigen::Matrix<Dual, kInputs, 1> dual;
  for (int k = 0; k < kInputs; ++k) dual[k] = Dual(x[k], kInputs, k);
  const Plant::StateOf<Dual> exact = evaluate(dual);
  const Plant::State value = evaluate(x);
  for (int k = 0; k < kInputs; ++k) {
    const double step = 1e-5 * std::max(1.0, std::abs(x[k]));
    auto up = x, down = x;
    up[k] += step;
    down[k] -= step;
    const Plant::State difference = (evaluate(up) - evaluate(down)) / (2 * step);
    for (int i = 0; i < Plant::kStates; ++i) {
      QCOMPARE(exact[i].value(), value[i]);
      const double error = std::abs(exact[i].derivatives()[k] - difference[i]);
      // Differences lose digits of the value by 1/step; the rest is their own truncation.
      const double allowed =
          1e-6 * std::abs(difference[i]) + 1e-7 + 1e-14 * std::abs(value[i]) / step;
      QVERIFY2(error < allowed, qPrintable(QString("d(%1)/d(%2): %3 against %4")
                                               .arg(i)
                                               .arg(k)
                                               .arg(exact[i].derivatives()[k])
                                               .arg(difference[i])));
    }
  }
}

QTEST_APPLESS_MAIN(TestMultirotorJacobian)
#include "test_multirotor_jacobian.moc"
