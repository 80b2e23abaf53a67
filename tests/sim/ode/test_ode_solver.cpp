// Driving: landing on sample instants, cut runs, kept steps, statistics, failures as values, no
// heap in a step.
#include <QtTest>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "tests/sim/ode/function_system.h"

using namespace rotorbench;
using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace {

/// An oscillator that notes when it is asked, may fail after a time, and projects its state on
/// request.
struct Probe {
  using State = Eigen::Matrix<double, 3, 1>;
  double failAfter = std::numeric_limits<double>::infinity();
  int failing = 1;
  double input = 0;
  double latest = 0;
  int calls = 0;
  bool project = false;

  void operator()(double t, const State& y, State& d) {
    ++calls;
    latest = std::max(latest, t);
    d << y[1], -4.0 * y[0] + input, std::cos(t);
    if (t > failAfter) d[failing] = std::numeric_limits<double>::quiet_NaN();
  }
  void afterStep(State& y) const {
    if (project) y.head<2>() /= std::sqrt(y[0] * y[0] + 0.25 * y[1] * y[1]);
  }
  [[nodiscard]] std::string_view componentName(int i) const {
    static constexpr std::string_view kNames[] = {"position", "speed", "phase"};
    return kNames[i];
  }
};
using State = Probe::State;

const State kStart(1.0, 0.0, 0.0);
State exactAt(double t) {
  return {std::cos(2 * t), -2 * std::sin(2 * t), std::sin(t)};
}

SolverSettings settingsOf(Method m) {
  return isAdaptive(m) ? adaptive(m, 1e-8) : fixedStep(m, 1e-3);
}

}  // namespace

class TestOdeSolver : public QObject {
  Q_OBJECT
 private slots:
  void sampledLandsExactly_data() { methods(); }
  void sampledLandsExactly() {
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    Probe probe;
    Solver<Probe> solver(settingsOf(m), probe);
    State y = kStart;
    for (int i = 1; i <= 300; ++i) {
      const double end = i * 0.0037;  // not a multiple of the step
      QCOMPARE(solver.advanceTo(end, y), Status::Done);
      QCOMPARE(solver.time(), end);
      QVERIFY2(probe.latest <= end * (1 + 1e-15), qPrintable(QString::number(probe.latest - end)));
    }
    QVERIFY((y - exactAt(solver.time())).norm() < (m == Method::Euler ? 0.02 : 1e-6));
    if (!isAdaptive(m)) QCOMPARE(solver.statistics().steps, 300 * 4);
    const auto before = solver.statistics().steps;
    QCOMPARE(solver.advanceTo(solver.time(), y), Status::Done);
    QCOMPARE(solver.statistics().steps, before);
  }

  void cutRunEqualsWhole_data() { methods(); }
  void cutRunEqualsWhole() {
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    if (isAdaptive(m)) QSKIP("an embedded method shortens a step at the cut");
    Probe probe;
    Solver<Probe> whole(fixedStep(m, 1.0 / 1024), probe);
    Solver<Probe> cut(fixedStep(m, 1.0 / 1024), probe);
    State a = kStart;
    State b = kStart;
    whole.integrate(2.0, a);
    cut.integrate(0.75, b);
    cut.advanceTo(1.25, b);
    cut.integrate(2.0, b);
    QCOMPARE(b, a);
    QCOMPARE(cut.statistics().evaluations, whole.statistics().evaluations);
  }

  void freeFixedStepDoesNotDrift() {
    Probe probe;
    Solver<Probe> solver(fixedStep(Method::Rk4, 0.1), probe);
    State y = kStart;
    std::vector<double> ends;
    Watch<State> watch;
    watch.onStep = [&](const StepView<State>& s) { return ends.push_back(s.end), true; };
    solver.integrate(1000.05, y, watch);
    QCOMPARE(ends.size(), std::size_t{10001});
    QCOMPARE(ends[9999], 10000 * 0.1);
    QCOMPARE(ends[10000], 1000.05);
  }

  void evaluations_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("perStep");
    QTest::addColumn<int>("once");
    const int perStep[] = {1, 4, 2, 6, 6, 6};
    const int once[] = {0, 0, 6, 1, 0, 1};  // ABM4: three RK4 steps; 7M, 7S: the first derivative
    for (int i = 0; i < 6; ++i) {
      QTest::addRow("%s", kMethods[static_cast<std::size_t>(i)].name.data())
          << i << perStep[i] << once[i];
    }
  }
  void evaluations() {
    QFETCH(int, method);
    QFETCH(int, perStep);
    QFETCH(int, once);
    Probe probe;
    Solver<Probe> solver(equalSteps(static_cast<Method>(method), 0.01), probe);
    State y = kStart;
    for (int i = 1; i <= 100; ++i) solver.advanceTo(i * 0.01, y);
    QCOMPARE(solver.statistics().steps, 100);
    QCOMPARE(solver.statistics().rejected, 0);
    QCOMPARE(solver.statistics().evaluations, 100 * perStep + once);
    QCOMPARE(solver.statistics().evaluations, probe.calls);
    solver.reset(0.0);
    QCOMPARE(solver.statistics().evaluations, 0);
    QCOMPARE(solver.time(), 0.0);
  }

  void rejectedStepsAreCounted() {
    Probe probe;
    SolverSettings s = adaptive(Method::Rk547M, 1e-9);
    s.initialStep = 2.0;
    Solver<Probe> solver(s, probe);
    State y = kStart;
    solver.integrate(5.0, y);
    const Statistics got = solver.statistics();
    QVERIFY(got.rejected >= 2);
    QCOMPARE(got.evaluations, 6 * got.attempts() + 1);
    QVERIFY((y - exactAt(5.0)).norm() < 1e-6);
  }

  void shortLastStepDoesNotSpoilTheNext() {
    Probe probe;
    Solver<Probe> solver(adaptive(Method::Rk547M, 1e-6), probe);
    State y = kStart;
    solver.advanceTo(5.0, y);
    const auto before = solver.statistics().attempts();
    solver.advanceTo(5.0 + 1e-9, y);
    solver.advanceTo(10.0, y);
    // Grown from 1e-9 s it would take about nine steps more.
    QVERIFY2(solver.statistics().attempts() - before <= before + 3,
             qPrintable(QString::number(solver.statistics().attempts() - before)));
  }

  void restartAfterInputJump_data() { methods(); }
  void restartAfterInputJump() {
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    Probe probe;
    Solver<Probe> solver(settingsOf(m), probe);
    State y = kStart;
    solver.advanceTo(0.5, y);
    probe.input = 4.0;
    solver.restart();
    const State jumped = y;
    solver.advanceTo(1.0, y);
    // From here on x - 1 oscillates freely.
    const double c = std::cos(1.0);
    const double s = std::sin(1.0);
    const State exact((jumped[0] - 1) * c + jumped[1] / 2 * s + 1,
                      -2 * (jumped[0] - 1) * s + jumped[1] * c, std::sin(1.0));
    QVERIFY((y - exact).norm() < (m == Method::Euler ? 0.02 : 2e-7));
  }

  void knownStartDerivative_data() { methods(); }
  void knownStartDerivative() {
    QFETCH(int, method);
    Probe probe;
    Solver<Probe> solver(equalSteps(static_cast<Method>(method), 0.01), probe);
    State a = kStart;
    solver.advanceTo(0.01, a);
    const int calls = probe.calls;
    solver.reset(0.0);
    State b = kStart;
    State d;
    probe(0.0, b, d);
    solver.setStartDerivative(d);
    probe.calls = 0;
    solver.advanceTo(0.01, b);
    QCOMPARE(b, a);
    QCOMPARE(probe.calls, calls - 1);
  }

  void projection_data() { methods(); }
  void projection() {
    QFETCH(int, method);
    Probe probe;
    probe.project = true;
    Solver<Probe> solver(settingsOf(static_cast<Method>(method)), probe);
    State y = kStart;
    solver.integrate(20.0, y);
    QVERIFY(std::abs(y[0] * y[0] + 0.25 * y[1] * y[1] - 1.0) < 1e-14);
    QVERIFY((y - exactAt(20.0)).norm() <
            (static_cast<Method>(method) == Method::Euler ? 0.1 : 1e-5));
  }

  void nonFiniteDerivative_data() { methods(); }
  void nonFiniteDerivative() {
    QFETCH(int, method);
    Probe probe;
    probe.failAfter = 0.7;
    Solver<Probe> solver(settingsOf(static_cast<Method>(method)), probe);
    State y = kStart;
    QCOMPARE(solver.integrate(2.0, y), Status::Failed);
    QCOMPARE(solver.failure().kind, FailureKind::NonFinite);
    QVERIFY(std::abs(solver.failure().time - 0.7) < 2e-3);
    QVERIFY(y.allFinite());
    QCOMPARE(solver.time(), solver.failure().time);
    const RunFailure f = solver.runFailure();
    QCOMPARE(f.component, std::string("speed"));
    QVERIFY(f.message.find("speed") != std::string::npos &&
            f.message.find("0.") != std::string::npos);
  }

  void stepUnderflow() {
    // x' = x^2 leaves every bound at t = 1.
    FunctionSystem<3> blowUp{[](double, const State& y, State& d) { d << 0.0, 0.0, y[2] * y[2]; }};
    SolverSettings s = adaptive(Method::Rk547M, 1e-8);
    s.minimumStep = 1e-6;
    Solver<FunctionSystem<3>> solver(s, blowUp);
    State y(0, 0, 1);
    QCOMPARE(solver.integrate(2.0, y), Status::Failed);
    QCOMPARE(solver.failure().kind, FailureKind::StepUnderflow);
    QCOMPARE(solver.failure().component, 2);
    QVERIFY(std::abs(solver.failure().time - 1.0) < 1e-3);
    QVERIFY(solver.runFailure().message.find("y[2]") != std::string::npos);
  }

  void budget_data() { methods(); }
  void budget() {
    QFETCH(int, method);
    Probe probe;
    SolverSettings s = settingsOf(static_cast<Method>(method));
    s.maximumSteps = 5;
    Solver<Probe> solver(s, probe);
    State y = kStart;
    QCOMPARE(solver.integrate(100.0, y), Status::Failed);
    QCOMPARE(solver.failure().kind, FailureKind::BudgetExceeded);
    QCOMPARE(solver.statistics().attempts(), 5);
    QCOMPARE(solver.failure().time, solver.time());
    QVERIFY(solver.runFailure().message.find("5 solver steps") != std::string::npos);
    QCOMPARE(solver.advanceTo(solver.time() + 1e-9, y), Status::Done);
  }

  void maximumStep() {
    Probe probe;
    SolverSettings s = adaptive(Method::Rk547S, 1e-2);
    s.maximumStep = 0.03;
    Solver<Probe> solver(s, probe);
    State y = kStart;
    double longest = 0;
    Watch<State> watch;
    watch.onStep = [&](const StepView<State>& v) {
      longest = std::max(longest, v.end - v.start);
      return true;
    };
    solver.integrate(10.0, y, watch);
    QVERIFY(longest <= 0.03 * (1 + 1e-9) && longest > 0.029);
  }

  void noHeapInAStep_data() { methods(); }
  void noHeapInAStep() {
    QFETCH(int, method);
    Probe probe;
    Solver<Probe> solver(settingsOf(static_cast<Method>(method)), probe);
    State y = kStart;
    const long before = allocations;
    for (int i = 1; i <= 1000; ++i) {
      probe.input = i % 7;
      solver.restart();
      if (solver.advanceTo(i * 0.0013, y) != Status::Done) QFAIL("failed");
    }
    const long during = allocations - before;
    QCOMPARE(during, 0L);
    const auto list = std::vector<int>(10);  // the counter does count
    QVERIFY(allocations > before && !list.empty());
  }

 private:
  static void methods() {
    QTest::addColumn<int>("method");
    for (std::size_t i = 0; i < 6; ++i)
      QTest::addRow("%s", kMethods[i].name.data()) << static_cast<int>(i);
  }
};

QTEST_APPLESS_MAIN(TestOdeSolver)
#include "test_ode_solver.moc"
