// Exponential RK4: the phi functions, fourth order, RK4 at small steps, stiff motor pairs where RK4
// explodes.
#include <Eigen/Eigenvalues>
#include <QtTest>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "tests/sim/ode/function_system.h"

using namespace rotorbench;
using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {

/// A direct-current motor with a quadratic load, turning a pointer: [angle, speed, current,
/// energy].
struct Motor {
  using State = Eigen::Matrix<double, 4, 1>;
  static constexpr int kPairs = 1;
  static constexpr std::pair<int, int> pair(int) { return {1, 2}; }
  double inductance = 50e-6, resistance = 0.1, constant = 0.01, inertia = 3e-5, load = 5e-8,
         voltage = 10;

  [[nodiscard]] Eigen::Matrix2d linear(int) const {
    Eigen::Matrix2d a;
    a << 0.0, constant / inertia, -constant / inductance, -resistance / inductance;
    return a;
  }
  void operator()(double t, const State& y, State& d) const {
    const double v = voltage * (1.0 + 0.2 * std::sin(20.0 * t));
    d << y[1], (constant * y[2] - load * y[1] * y[1]) / inertia,
        (v - resistance * y[2] - constant * y[1]) / inductance, v * y[2];
  }
};
using State = Motor::State;

State run(const Motor& motor, const SolverSettings& settings, double end, State y = State::Zero()) {
  Motor m = motor;
  Solver<Motor> solver(settings, m);
  if (solver.integrate(end, y) != Status::Done)
    y.setConstant(std::numeric_limits<double>::infinity());
  return y;
}

}  // namespace

class TestOdeExponential : public QObject {
  Q_OBJECT
 private slots:
  void phi_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addRow("tiny") << -1e-9 << -1e-3;
    QTest::addRow("moderate") << -0.7 << -3.0;
    QTest::addRow("stiff") << -0.2 << -200.0;
    QTest::addRow("growing") << 2.0 << -1.0;
  }
  void phi() {
    // In the eigenbasis the phi functions are scalars; there they are summed in closed form or by
    // their series.
    QFETCH(double, a);
    QFETCH(double, b);
    Eigen::Matrix<long double, 2, 2> basis;
    basis << 1.0L, 0.3L, -0.5L, 1.0L;
    const auto inverse = basis.inverse().eval();
    const long double values[] = {a, b};
    Eigen::Matrix<long double, 2, 1> diagonal(values[0], values[1]);
    const auto phi = phiFunctions(basis * diagonal.asDiagonal() * inverse);
    for (int k = 0; k < 4; ++k) {
      Eigen::Matrix<long double, 2, 1> expected(scalarPhi(k, values[0]), scalarPhi(k, values[1]));
      const Eigen::Matrix<long double, 2, 2> m = basis * expected.asDiagonal() * inverse;
      const auto defect =
          static_cast<double>((phi[static_cast<std::size_t>(k)] - m).cwiseAbs().maxCoeff());
      QVERIFY2(defect < 1e-15 * std::max(1.0, static_cast<double>(m.cwiseAbs().maxCoeff())),
               qPrintable(QString("phi%1 %2").arg(k).arg(defect)));
    }
  }
  void phiOfSingularAndZero() {
    using Matrix = Eigen::Matrix<long double, 2, 2>;
    const auto zero = phiFunctions(Matrix::Zero());
    const long double expected[] = {1.0L, 1.0L, 0.5L, 1.0L / 6.0L};
    for (std::size_t k = 0; k < 4; ++k) {
      QVERIFY((zero[k] - expected[k] * Matrix::Identity()).cwiseAbs().maxCoeff() < 1e-18L);
    }
    Matrix nilpotent;
    nilpotent << 0.0L, 4.0L, 0.0L, 0.0L;  // phi_k = 1/k! + z/(k+1)!
    const auto phi = phiFunctions(nilpotent);
    QVERIFY(std::abs(phi[1](0, 1) - 2.0L) < 1e-17L);
    QVERIFY(std::abs(phi[3](0, 1) - 4.0L / 24.0L) < 1e-17L);
  }

  void fourthOrder() {
    const Motor motor;  // electrical time constant 0.5 ms
    const State exact = run(motor, adaptive(Method::Rk547M, 1e-13), 0.05);
    double errors[3];
    for (int i = 0; i < 3; ++i) {
      errors[i] =
          (run(motor, fixedStep(Method::ExponentialRk4, 1e-3 / (1 << i)), 0.05) - exact).norm();
    }
    for (int i = 0; i < 2; ++i) {
      const double order = std::log2(errors[i] / errors[i + 1]);
      QVERIFY2(order > 3.5 && order < 5.0, qPrintable(QString::number(order)));
    }
  }
  void meetsRk4AtSmallSteps() {
    const Motor motor;
    double before = 0;
    for (const double h : {4e-5, 2e-5, 1e-5}) {
      const State a = run(motor, fixedStep(Method::ExponentialRk4, h), 0.02);
      const State b = run(motor, fixedStep(Method::Rk4, h), 0.02);
      const double apart = (a - b).norm() / b.norm();
      if (before > 0) QVERIFY2(std::log2(before / apart) > 3.5, qPrintable(QString::number(apart)));
      before = apart;
    }
    QVERIFY2(before < 1e-8, qPrintable(QString::number(before)));
  }
  void stiffWhereRk4Explodes() {
    Motor motor;
    motor.inductance = 5e-6;  // electrical time constant 0.05 ms, step 1 ms
    const State exact = run(motor, adaptive(Method::Rk547M, 1e-12), 0.2);
    const State own = run(motor, fixedStep(Method::ExponentialRk4, 1e-3), 0.2);
    QVERIFY2(std::abs(own[1] / exact[1] - 1.0) < 1e-5,
             qPrintable(QString::number(own[1] - exact[1])));
    QVERIFY2(std::abs(own[2] - exact[2]) < 0.02, qPrintable(QString::number(own[2] - exact[2])));
    const State rk4 = run(motor, fixedStep(Method::Rk4, 1e-3), 0.2);
    QVERIFY(!(std::abs(rk4[2]) < 1e6));
  }
  void constantsFollowTheStepAndTheSystem() {
    // A shortened last step and a changed resistance must not use the old constants.
    Motor motor;
    Solver<Motor> solver(fixedStep(Method::ExponentialRk4, 1e-3), motor);
    State y = State::Zero();
    solver.integrate(0.0104, y);
    QVERIFY((y - run(motor, adaptive(Method::Rk547M, 1e-12), 0.0104)).norm() < 1e-2);
    State z = y;
    motor.resistance = 0.2;
    solver.relinearize();
    solver.restart();
    solver.advanceTo(0.0204, y);
    Solver<Motor> fresh(fixedStep(Method::ExponentialRk4, 1e-3), motor, 0.0104);
    fresh.advanceTo(0.0204, z);
    QCOMPARE(y, z);
  }
  void refusedWithoutPairs() {
    FunctionSystem<4> plain{nullptr};
    try {
      Solver<FunctionSystem<4>> solver(fixedStep(Method::ExponentialRk4, 1e-3), plain);
      QFAIL("accepted");
    } catch (const InputError& e) {
      QCOMPARE(e.problems().size(), std::size_t{1});
      QCOMPARE(e.problems()[0].path, std::string("method"));
    }
  }

 private:
  static long double scalarPhi(int k, long double z) {
    if (std::abs(z) < 4.0L) {
      long double term = 1.0L;
      for (int i = 2; i <= k; ++i) term /= i;
      long double sum = term;
      for (int n = 1; n < 60; ++n) sum += term *= z / (n + k);
      return sum;
    }
    long double value = std::exp(z);
    long double inverseFactorial = 1.0L;
    for (int i = 0; i < k; ++i) {
      value = (value - inverseFactorial) / z;
      inverseFactorial /= i + 1;
    }
    return value;
  }
};

QTEST_APPLESS_MAIN(TestOdeExponential)
#include "test_ode_exponential.moc"
