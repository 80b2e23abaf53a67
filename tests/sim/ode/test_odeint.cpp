// The same right-hand side through Boost.Odeint: RK4 and RK5(4)7M at equal steps agree to rounding,
// and a controlled run ends at the same place.
#include <QtTest>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "tests/sim/ode/function_system.h"

using namespace rotorbench::ode;
using namespace rotorbench::test;
namespace odeint = boost::numeric::odeint;

namespace {

using System = FunctionSystem<4>;
using State = System::State;
using Algebra = odeint::vector_space_algebra;

/// Double pendulum with a time-dependent pivot: no symmetry hides a wrong weight.
void doublePendulum(double t, const State& y, State& d) {
  const double s = std::sin(y[0] - y[1]);
  const double c = std::cos(y[0] - y[1]);
  const double g = 9.81 + std::sin(3.0 * t);
  const double rest = 2.0 - c * c;
  d << y[2], y[3],
      (-2.0 * g * std::sin(y[0]) + g * c * std::sin(y[1]) - s * (y[3] * y[3] + c * y[2] * y[2])) /
          rest,
      (2.0 * g * (c * std::sin(y[0]) - std::sin(y[1])) +
       s * (2.0 * y[2] * y[2] + c * y[3] * y[3])) /
          rest;
}

const State kStart(0.4, -0.3, 0.2, 0.1);

template <class Stepper>
State odeintRun(double h, int steps) {
  Stepper stepper;
  State y = kStart;
  for (int i = 0; i < steps; ++i) {
    stepper.do_step([](const State& x, State& d, double t) { doublePendulum(t, x, d); }, y, i * h,
                    h);
  }
  return y;
}

State ownRun(Method method, double h, int steps) {
  System system{doublePendulum};
  Solver<System> solver(equalSteps(method, h), system);
  State y = kStart;
  for (int i = 1; i <= steps; ++i) solver.advanceTo(i * h, y);
  return solver.statistics().steps == steps ? y : State::Constant(NAN);
}

}  // namespace

class TestOdeint : public QObject {
  Q_OBJECT
 private slots:
  void euler() {
    compare(ownRun(Method::Euler, 1e-3, 2000),
            odeintRun<odeint::euler<State, double, State, double, Algebra>>(1e-3, 2000));
  }
  void rk4() {
    compare(ownRun(Method::Rk4, 0.01, 500),
            odeintRun<odeint::runge_kutta4<State, double, State, double, Algebra>>(0.01, 500));
  }
  void rk547m() {
    compare(
        ownRun(Method::Rk547M, 0.01, 500),
        odeintRun<odeint::runge_kutta_dopri5<State, double, State, double, Algebra>>(0.01, 500));
  }
  void controlled() {
    using Array = std::array<double, 4>;
    Array z{kStart[0], kStart[1], kStart[2], kStart[3]};
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_dopri5<Array>>(1e-12, 1e-12),
        [](const Array& x, Array& d, double t) {
          State out;
          doublePendulum(t, State(x[0], x[1], x[2], x[3]), out);
          for (int i = 0; i < 4; ++i) d[static_cast<std::size_t>(i)] = out[i];
        },
        z, 0.0, 5.0, 0.01);
    System system{doublePendulum};
    for (const MethodInfo& m : kMethods) {
      if (!m.adaptive) continue;
      Solver<System> solver(adaptive(m.method, 1e-12), system);
      State y = kStart;
      QCOMPARE(solver.integrate(5.0, y), Status::Done);
      QVERIFY2((y - State(z[0], z[1], z[2], z[3])).norm() < 1e-9, m.name.data());
    }
  }

 private:
  static void compare(const State& own, const State& theirs) {
    QVERIFY((own - kStart).norm() > 0.1);
    const double difference = (own - theirs).cwiseAbs().maxCoeff();
    // Rounding of 2000 steps at most, grown by the (not chaotic) motion.
    QVERIFY2(difference < 2e-12, qPrintable(QString::number(difference)));
  }
};

QTEST_APPLESS_MAIN(TestOdeint)
#include "test_odeint.moc"
