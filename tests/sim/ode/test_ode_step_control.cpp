// What the step control decides, and what the fixed-step loop does where it starts with a known
// derivative or fails.
#include <QtTest>
#include <cmath>

#include "tests/sim/ode/function_system.h"

using namespace rotorbench;
using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {

using State = Eigen::Matrix<double, 2, 1>;
using System = FunctionSystem<2>;

void oscillator(double /*t*/, const State& y, State& d) {
  d << y[1], -y[0];
}
/// 1000 times faster than it moves: explicit methods are held by stability, not by accuracy.
void stiff(double t, const State& y, State& d) {
  d << -1000 * (y[0] - std::cos(t)), -y[1];
}
void explodes(double /*t*/, const State& y, State& d) {
  d << y[0] / 0.0, y[1];
}

SolverSettings settings(double tolerance, StepController controller, double kept) {
  SolverSettings s = adaptive(Method::Rk547M, tolerance, Norm::Rms, controller);
  std::get<ScaledErrorControl>(s.errorControl).keptChange = kept;
  return s;
}

struct Ran {
  double error = 0;
  int changes = 0;
  Statistics statistics;
};

/// The oscillator from (1, 0) to t = 20.
Ran oscillate(const SolverSettings& s) {
  System system{oscillator};
  Solver<System> solver(s, system);
  State y(1, 0);
  Ran ran;
  double last = 0;
  Watch<State> watch;
  watch.onStep = [&](const StepView<State>& v) {
    const double h = v.end - v.start;
    if (std::abs(h - last) > 1e-12 * h) ++ran.changes;
    last = h;
    return true;
  };
  solver.integrate(20, y, watch);
  ran.error = (y - State(std::cos(20), -std::sin(20))).norm();
  ran.statistics = solver.statistics();
  return ran;
}

}  // namespace

class TestOdeStepControl : public QObject {
  Q_OBJECT
 private slots:
  void keptSteps_data() { controllers(); }
  void keptSteps() {
    QFETCH(int, controller);
    const auto c = static_cast<StepController>(controller);
    const Ran free = oscillate(settings(1e-8, c, 0));
    const Ran kept = oscillate(settings(1e-8, c, 0.05));
    QVERIFY2(free.changes > 20, qPrintable(QString::number(free.changes)));
    QVERIFY2(kept.changes < free.changes / 2, qPrintable(QString::number(kept.changes)));
    // Kept steps neither cost accuracy nor evaluations worth speaking of.
    QVERIFY2(kept.error < 1.5 * free.error, qPrintable(QString::number(kept.error / free.error)));
    QVERIFY(10 * kept.statistics.evaluations < 11 * free.statistics.evaluations);
  }

  /// Gustafsson: where stability holds the step, the last error alone makes it swing about the
  /// limit.
  void piControlSparesRejectedStepsAtTheStabilityLimit() {
    const auto rejected = [](StepController c) {
      System system{stiff};
      Solver<System> solver(settings(1e-4, c, 0.05), system);
      State y(1, 1);
      if (solver.integrate(5, y) != Status::Done) qFatal("the run failed");
      return solver.statistics().rejected;
    };
    const auto elementary = rejected(StepController::Elementary);
    const auto pi = rejected(StepController::ProportionalIntegral);
    QVERIFY2(4 * pi < elementary, qPrintable(QString("%1 against %2").arg(pi).arg(elementary)));
  }

  /// A start derivative handed over serves the first step only, and saves one evaluation.
  void knownStartDerivative() {
    System system{oscillator};
    Solver<System> plain(fixedStep(Method::Rk4, 0.125), system);
    Solver<System> told(fixedStep(Method::Rk4, 0.125), system);
    State a(1, 0), b(1, 0), d;
    oscillator(0, b, d);
    told.restart();
    told.setStartDerivative(d);
    QCOMPARE(plain.integrate(2, a), Status::Done);
    QCOMPARE(told.integrate(2, b), Status::Done);
    QCOMPARE(b, a);
    QCOMPARE(told.statistics().evaluations, plain.statistics().evaluations - 1);
  }

  void firstStepThatFails_data() {
    QTest::addColumn<bool>("known");
    QTest::addRow("start derivative unknown") << false;
    QTest::addRow("start derivative known") << true;
  }
  void firstStepThatFails() {
    QFETCH(bool, known);
    System system{explodes};
    Solver<System> solver(fixedStep(Method::Rk4, 0.125), system);
    State y(1, 2);
    if (known) solver.setStartDerivative(State(1, 1));
    QCOMPARE(solver.integrate(2, y), Status::Failed);
    QCOMPARE(y, State(1, 2));  // the state before the step that failed
    QCOMPARE(solver.time(), 0.0);
    QCOMPARE(solver.statistics().steps, 0);
    QCOMPARE(solver.failure().kind, FailureKind::NonFinite);
    QCOMPARE(solver.failure().component, 0);
  }

 private:
  static void controllers() {
    QTest::addColumn<int>("controller");
    QTest::addRow("elementary") << static_cast<int>(StepController::Elementary);
    QTest::addRow("PI") << static_cast<int>(StepController::ProportionalIntegral);
  }
};

QTEST_APPLESS_MAIN(TestOdeStepControl)
#include "test_ode_step_control.moc"
