// Dense output and events of free runs.
#include <QtTest>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/sim/ode/function_system.h"

using namespace rotorbench::ode;
using namespace rotorbench::test;

namespace {

using System = FunctionSystem<3>;
using State = System::State;

void oscillator(double t, const State& y, State& d) {
  d << y[1], -y[0], std::cos(t) * y[2];
}
State exactAt(double t) {
  return {std::cos(t), -std::sin(t), std::exp(std::sin(t))};
}
const State kStart(1.0, 0.0, 1.0);

/// A ball dropped from 1 m; [height, speed, -].
void ball(double, const State& y, State& d) {
  d << y[1], -9.81, 0.0 * y[0];
}

/// Largest error of the dense output inside the steps, and largest jump between two steps.
struct DenseQuality {
  double inside = 0, jump = 0, slopeJump = 0;
};
DenseQuality denseQuality(Method m, double h) {
  System system{oscillator};
  Solver<System> solver(equalSteps(m, h), system);
  State y = kStart;
  DenseQuality q;
  State last = kStart;
  State lastSlope = State::Constant(NAN);
  Watch<State> watch;
  watch.onStep = [&](const StepView<State>& s) {
    for (int i = 0; i <= 20; ++i) {
      const double t = s.start + (s.end - s.start) * i / 20;
      q.inside = std::max(q.inside, (s.dense.at(t) - exactAt(t)).norm());
    }
    q.jump = std::max(q.jump, (s.dense.at(s.start) - last).norm());
    const double d = 1e-5 * (s.end - s.start);
    const State slope = (s.dense.at(s.start + d) - s.dense.at(s.start)) / d;
    if (lastSlope.allFinite()) q.slopeJump = std::max(q.slopeJump, (slope - lastSlope).norm());
    lastSlope = (s.dense.at(s.end) - s.dense.at(s.end - d)) / d;
    last = s.dense.at(s.end);
    return true;
  };
  solver.integrate(6.0, y, watch);
  q.jump = std::max(q.jump, (last - y).norm());
  return q;
}

}  // namespace

class TestOdeWatch : public QObject {
  Q_OBJECT
 private slots:
  void denseOutput_data() { methods(); }
  void denseOutput() {
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    const DenseQuality coarse = denseQuality(m, 0.1);
    const DenseQuality fine = denseQuality(m, 0.05);
    QVERIFY2(fine.jump < 1e-13, qPrintable(QString::number(fine.jump)));
    QVERIFY2(fine.slopeJump < 1e-4, qPrintable(QString::number(fine.slopeJump)));
    // The interpolant is of fourth order (error h^5 inside a step) for 7M, of third for the others.
    const double order = std::log2(coarse.inside / fine.inside);
    const double least = m == Method::Euler ? 0.8 : m == Method::Rk547M ? 4.6 : 3.6;
    QVERIFY2(order > least, qPrintable(QString::number(order)));
    QVERIFY2(m == Method::Euler || fine.inside < (m == Method::Rk547M ? 5e-8 : 5e-6),
             qPrintable(QString::number(fine.inside)));
  }

  void watchingDoesNotChangeTheRun_data() { methods(); }
  void watchingDoesNotChangeTheRun() {
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    const SolverSettings s = isAdaptive(m) ? adaptive(m, 1e-7) : fixedStep(m, 0.01);
    System system{oscillator};
    Solver<System> plain(s, system);
    Solver<System> watched(s, system);
    State a = kStart;
    State b = kStart;
    Watch<State> watch;
    watch.onStep = [](const StepView<State>&) { return true; };
    plain.integrate(7.0, a);
    watched.integrate(7.0, b, watch);
    QCOMPARE(b, a);
    // The derivative at the end of a step serves the next one: one evaluation more at most.
    QVERIFY(watched.statistics().evaluations <= plain.statistics().evaluations + 1);
  }

  void pausingDoesNotChangeTheRun_data() { methods(); }
  void pausingDoesNotChangeTheRun() {
    // A long run is cut in slices so that it can be stopped: neither the state nor the count may
    // show it.
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    const SolverSettings s = isAdaptive(m) ? adaptive(m, 1e-7) : fixedStep(m, 0.0078125);
    System system{oscillator};
    Solver<System> whole(s, system);
    Solver<System> sliced(s, system);
    State a = kStart;
    State b = kStart;
    Watch<State> watch;
    watch.onStep = [](const StepView<State>&) { return true; };
    whole.integrate(7.0, a, watch);
    int step = 0;
    watch.onStep = [&](const StepView<State>&) { return ++step % 3 != 0; };
    while (sliced.integrate(7.0, b, watch) == Status::Stopped) {
    }
    QVERIFY(step > 6);
    QCOMPARE(b, a);
    QCOMPARE(sliced.statistics().evaluations, whole.statistics().evaluations);
  }

  void crossings_data() {
    QTest::addColumn<int>("direction");
    QTest::addColumn<QList<double>>("times");
    const double half = std::numbers::pi / 2;
    QTest::addRow("any") << static_cast<int>(Crossing::Any)
                         << QList<double>{half, 3 * half, 5 * half};
    QTest::addRow("rising") << static_cast<int>(Crossing::Rising) << QList<double>{3 * half};
    QTest::addRow("falling") << static_cast<int>(Crossing::Falling)
                             << QList<double>{half, 5 * half};
  }
  void crossings() {
    QFETCH(int, direction);
    QFETCH(QList<double>, times);
    System system{oscillator};
    Solver<System> solver(adaptive(Method::Rk547M, 1e-10), system);
    State y = kStart;
    std::vector<double> found;
    Watch<State> watch;
    watch.events.push_back(
        {[](double, const State& s) { return s[0]; }, static_cast<Crossing>(direction), false});
    watch.onEvent = [&](const Occurrence<State>& o) { found.push_back(o.time); };
    QCOMPARE(solver.integrate(9.0, y, watch), Status::Done);
    QCOMPARE(solver.time(), 9.0);
    QCOMPARE(found.size(), static_cast<std::size_t>(times.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
      QVERIFY(std::abs(found[i] - times[static_cast<qsizetype>(i)]) < 1e-8);
    }
  }

  void bouncingBall_data() { methods(); }
  void bouncingBall() {
    // With restitution e the n-th impact is at t1 (1 + 2 (e + e^2 + ...)), t1 = sqrt(2 h / g).
    QFETCH(int, method);
    const auto m = static_cast<Method>(method);
    const double fall = std::sqrt(2.0 / 9.81);
    System system{ball};
    SolverSettings settings =
        isAdaptive(m) ? adaptive(m, 1e-9) : fixedStep(m, m == Method::Euler ? 1e-5 : 0.01);
    // The flight is a parabola, which these methods solve exactly at any step: the bound lets no
    // bounce hide.
    settings.maximumStep = 0.05;
    Solver<System> solver(settings, system);
    State y(1.0, 0.0, 0.0);
    Watch<State> watch;
    watch.events.push_back({[](double, const State& s) { return s[0]; }, Crossing::Falling, true});
    double expected = fall;
    double bounce = 1.0;
    for (int n = 0; n < 5; ++n) {
      QCOMPARE(solver.integrate(10.0, y, watch), Status::Stopped);
      QVERIFY2(std::abs(solver.time() - expected) < (m == Method::Euler ? 3e-4 : 1e-9),
               qPrintable(QString("%1: %2").arg(n).arg(solver.time() - expected)));
      QVERIFY(std::abs(y[0]) < 1e-12);
      y[0] = 0.0;
      y[1] = -0.8 * y[1];
      solver.restart();
      bounce *= 0.8;
      expected += 2 * fall * bounce;
    }
  }

  void eventsInOrderUpToTheTerminalOne() {
    System system{oscillator};
    SolverSettings s = embeddedFixed(Method::Rk547M, 1.0);  // all inside one step
    Solver<System> solver(s, system);
    State y = kStart;
    std::vector<std::size_t> order;
    Watch<State> watch;
    const auto at = [](double when) { return [when](double t, const State&) { return t - when; }; };
    watch.events = {{at(0.8), Crossing::Any, false},
                    {at(0.6), Crossing::Any, true},
                    {at(0.2), Crossing::Rising, false},
                    {at(0.3), Crossing::Falling, false}};
    watch.onEvent = [&](const Occurrence<State>& o) { order.push_back(o.event); };
    double end = 0;
    watch.onStep = [&](const StepView<State>& v) { return end = v.end, true; };
    QCOMPARE(solver.integrate(2.0, y, watch), Status::Stopped);
    QCOMPARE(order, (std::vector<std::size_t>{2, 1}));
    QVERIFY(std::abs(solver.time() - 0.6) < 1e-14);
    QCOMPARE(end, solver.time());
    QVERIFY((y - exactAt(0.6)).norm() < 1e-3);
  }

  void observerStops() {
    System system{oscillator};
    Solver<System> solver(fixedStep(Method::Rk4, 0.125), system);
    State y = kStart;
    Watch<State> watch;
    watch.onStep = [](const StepView<State>& s) { return s.end < 1.0; };
    QCOMPARE(solver.integrate(5.0, y, watch), Status::Stopped);
    QCOMPARE(solver.time(), 1.0);
    QCOMPARE(solver.integrate(2.0, y), Status::Done);
    QVERIFY((y - exactAt(2.0)).norm() < 1e-4);
  }

  void rootPastFindsTheFarEnd() {
    int calls = 0;
    const auto g = [&](double x) { return ++calls, x * x * x - 2.0; };
    const double root = rootPast(g, 0.0, 2.0, -2.0, 6.0);
    QVERIFY(std::abs(root - std::cbrt(2.0)) < 1e-15 && root * root * root >= 2.0 - 1e-15);
    QVERIFY2(calls < 30, qPrintable(QString::number(calls)));
    const auto step = [](double x) { return x < 0.3 ? -1.0 : 1.0; };  // a jump has no smooth root
    QCOMPARE(rootPast(step, 0.0, 1.0, -1.0, 1.0), 0.3);
  }

 private:
  static void methods() {
    QTest::addColumn<int>("method");
    for (std::size_t i = 0; i < 6; ++i)
      QTest::addRow("%s", kMethods[i].name.data()) << static_cast<int>(i);
  }
};

QTEST_APPLESS_MAIN(TestOdeWatch)
#include "test_ode_watch.moc"
