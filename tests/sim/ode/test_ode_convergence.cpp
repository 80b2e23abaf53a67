// Measured order of convergence of every method, and what every Runge-Kutta and linear multistep
// method keeps: linear invariants and, running back with the reversed field, the way it came.
#include <QtTest>
#include <cmath>

#include "tests/sim/ode/function_system.h"

using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {

using System = FunctionSystem<3>;
using State = System::State;

/// Euler's equations of a free rigid body with a time-dependent torque: non-linear and not
/// autonomous.
void rigidBody(double t, const State& w, State& d) {
  d << -0.8 * w[1] * w[2] + 0.3 * std::cos(t), 0.6 * w[2] * w[0], -0.4 * w[0] * w[1] - 0.1 * w[2];
}
/// Chemical kinetics: the sum of the three amounts is kept.
void reaction(double, const State& y, State& d) {
  const double forward = 2.0 * y[0] * y[1];
  const double back = 0.7 * y[2];
  d << back - forward, back - forward * 0.5 - y[1] * 0.1, forward * 1.5 - 2.0 * back + y[1] * 0.1;
}
void pendulum(double, const State& y, State& d) {
  d << y[1], -9.81 * std::sin(y[0]), -0.2 * y[2];
}
void pendulumBack(double t, const State& y, State& d) {
  pendulum(t, y, d);
  d = -d;
}

State solve(const SolverSettings& settings, System::Function f, State y, double end) {
  System system{f};
  Solver<System> solver(settings, system);
  if (solver.integrate(end, y) != Status::Done) y.setConstant(NAN);
  return y;
}

}  // namespace

class TestOdeConvergence : public QObject {
  Q_OBJECT
 private slots:
  void order_data() { methods(); }
  void order() {
    QFETCH(int, method);
    QFETCH(double, order);
    const auto m = static_cast<Method>(method);
    const State y0(1.0, 0.4, -0.7);
    const State exact = solve(adaptive(Method::Rk547M, 1e-14), rigidBody, y0, 2.0);
    const int steps = m == Method::Euler ? 2000 : 40;
    double errors[3];
    for (int i = 0; i < 3; ++i) {
      errors[i] = (solve(equalSteps(m, 2.0 / (steps << i)), rigidBody, y0, 2.0) - exact).norm();
    }
    for (int i = 0; i < 2; ++i) {
      const double measured = std::log2(errors[i] / errors[i + 1]);
      QVERIFY2(measured > order - 0.25 && measured < order + 0.75,
               qPrintable(QString::number(measured)));
    }
  }

  void linearInvariant_data() { methods(); }
  void linearInvariant() {
    QFETCH(int, method);
    const State y0(1.0, 0.8, 0.1);
    const State y = solve(equalSteps(static_cast<Method>(method), 0.01), reaction, y0, 5.0);
    QVERIFY((y - y0).norm() > 0.1);
    QVERIFY2(std::abs(y.sum() - y0.sum()) < 1e-13, qPrintable(QString::number(y.sum() - y0.sum())));
  }

  void timeReversal_data() { methods(); }
  void timeReversal() {
    QFETCH(int, method);
    QFETCH(double, order);
    // Forth and back leaves the method's own error twice: it must shrink with the method's order at
    // least.
    const auto m = static_cast<Method>(method);
    const State y0(0.7, 0.0, 1.0);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
      const SolverSettings s = equalSteps(m, (m == Method::Euler ? 2e-4 : 1e-2) / (1 << i));
      errors[i] = (solve(s, pendulumBack, solve(s, pendulum, y0, 3.0), 3.0) - y0).norm();
    }
    QVERIFY(errors[0] < (m == Method::Euler ? 0.05 : 1e-5));
    QVERIFY2(std::log2(errors[0] / errors[1]) > order - 0.3,
             qPrintable(QString::number(errors[1])));
  }

  void tolerance_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("controller");
    for (const MethodInfo& m : kMethods) {
      if (!m.adaptive) continue;
      for (const auto c : {StepController::Elementary, StepController::ProportionalIntegral}) {
        QTest::addRow("%s %d", m.name.data(), static_cast<int>(c))
            << static_cast<int>(m.method) << static_cast<int>(c);
      }
    }
  }
  void tolerance() {
    QFETCH(int, method);
    QFETCH(int, controller);
    const State y0(1.0, 0.4, -0.7);
    const State exact = solve(adaptive(Method::Rk547M, 1e-14), rigidBody, y0, 20.0);
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const auto s = adaptive(static_cast<Method>(method), tolerance, Norm::Rms,
                              static_cast<StepController>(controller));
      const double error = (solve(s, rigidBody, y0, 20.0) - exact).norm();
      QVERIFY2(error < 200.0 * tolerance, qPrintable(QString::number(error / tolerance)));
    }
  }

 private:
  static void methods() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("order");
    const double orders[] = {1, 4, 4, 5, 5, 5};
    for (int i = 0; i < 6; ++i) {
      QTest::addRow("%s", kMethods[static_cast<std::size_t>(i)].name.data()) << i << orders[i];
    }
  }
};

QTEST_APPLESS_MAIN(TestOdeConvergence)
#include "test_ode_convergence.moc"
