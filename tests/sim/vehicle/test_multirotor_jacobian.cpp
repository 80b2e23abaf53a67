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
  void commandReachesTheMotors_data();
  void commandReachesTheMotors();
};

void TestMultirotorJacobian::exactJacobianEqualsCentralDifferences_data() {
  QTest::addColumn<bool>("moving");
  QTest::addColumn<EscParameters>("esc");
  QTest::addRow("hover") << false << RotorParameters{}.esc;
  QTest::addRow("fast turning flight") << true << RotorParameters{}.esc;
  QTest::addRow("hover with a lag") << false << EscParameters{.responseTime = 0.02};
  QTest::addRow("passive with a lag")
      << true << EscParameters{.responseTime = 0.02, .activeBraking = false};
  QTest::addRow("reversible and passive")
      << true << EscParameters{.responseTime = 0, .reverse = true, .activeBraking = false};
  QTest::addRow("at the limit of the current")
      << true << EscParameters{.responseTime = 0.01, .maxCurrent = 2};
}

void TestMultirotorJacobian::exactJacobianEqualsCentralDifferences() {
  QFETCH(bool, moving);
  QFETCH(EscParameters, esc);
  VehicleParameters v;
  RotorCoefficients rotor;
  rotor.inflow = {1.19e-4, 2.32e-4, 3.39e-3, 1e-5};
  std::get<EqualRotors>(v.rotors).rotor.aerodynamics = rotor;
  std::get<EqualRotors>(v.rotors).rotor.esc = esc;
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
  if (esc.reverse) x[Plant::kStates + 2] = -0.3;
  // Duties on the way from other commands: some drive, some let go.
  x.segment<4>(Plant::Layout::kDuty) << 0.45, 0.65, 0.3, 0.8;

  const auto evaluate = [&](const auto& in) {
    using S = typename std::decay_t<decltype(in)>::Scalar;
    Plant::StateOf<S> y = in.template head<Plant::kStates>(), d;
    Plant::CommandOf<S> u = in.template tail<4>();
    plant.derivative<typename std::decay_t<decltype(u)>::Scalar>(0, u, y, d);
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

/// What a linear model needs: a lag is a state with the pole -1/T that the command moves, and
/// without one the command moves the currents at once.
void TestMultirotorJacobian::commandReachesTheMotors_data() {
  QTest::addColumn<double>("responseTime");
  QTest::addRow("no lag") << 0.0;
  QTest::addRow("20 ms") << 0.02;
}

void TestMultirotorJacobian::commandReachesTheMotors() {
  QFETCH(double, responseTime);
  using L = Plant::Layout;
  VehicleParameters v;
  std::get<EqualRotors>(v.rotors).rotor.esc.responseTime = responseTime;
  const Plant plant(buildMultirotor<4>(v, {}));
  const Plant::State y = plant.initialState({});
  const Plant::Command u = plant.steadyDuties(plant.hoverSpeeds());
  Plant::StateOf<Dual> state, rate;
  Plant::CommandOf<Dual> command;
  for (int k = 0; k < Plant::kStates; ++k) state[k] = Dual(y[k], kInputs, k);
  for (int k = 0; k < 4; ++k) command[k] = Dual(u[k], kInputs, Plant::kStates + k);
  plant.derivative(0, command, state, rate);
  const double gain = 11.1 / 50e-6;  // V over L: an ideal supply of 11.1 V, 50 uH
  const auto slope = [&](int of, int by) { return rate[of].derivatives()[by]; };
  const bool lag = responseTime > 0;
  QVERIFY(std::abs(slope(L::kCurrent, L::kDuty) - (lag ? gain : 0)) < 1e-9 * gain);
  QVERIFY(std::abs(slope(L::kCurrent, Plant::kStates) - (lag ? 0 : gain)) < 1e-9 * gain);
  QCOMPARE(slope(L::kDuty, L::kDuty), lag ? -50.0 : 0.0);
  QCOMPARE(slope(L::kDuty, Plant::kStates), lag ? 50.0 : 0.0);
}

QTEST_APPLESS_MAIN(TestMultirotorJacobian)
#include "test_multirotor_jacobian.moc"
