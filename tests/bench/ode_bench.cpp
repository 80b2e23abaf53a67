// RK4 and RK5(4)7M against Boost.Odeint, on the rigid birotor of the thesis' experiment 1 and on
// the hovering quadrotor with motors, in one run. Both sides call the same functor, and its
// parameters come from a function the compiler cannot look into, so that neither side folds them
// into its code. What is compared:
//  - stepper: one step after the other without a solver around it; Odeint's do_step on its own
//    steppers;
//  - free, sampled: our Solver, with its checks and statistics, over the span in one call or in one
//    call a step,
//    against the same loop of do_step;
//  - adaptive: at equal achieved error; our tolerance that reaches Odeint's error is searched for
//    first. The
//    quadrotor starts it tilted and turning, as there is nothing to control in a hover.
// Odeint's do_step does no error control: the fixed-step runs of RK5(4)7M are compared as steppers
// only. Odeint runs in the faster of two ways, component by component (std::array for the birotor;
// the quadrotor takes Eigen states only, so a plain-loop algebra does on them what array_algebra
// does on arrays) and with its Eigen expressions.
#include <benchmark/benchmark.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/external/eigen/eigen_algebra.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "sim/ode/solver.h"
#include "sim/vehicle/multirotor.h"
#include "tests/bench/loop_algebra.h"
#include "tests/bench/ratio_report.h"

// Odeint's factories copy steppers whose stages are not filled yet.
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

namespace {

namespace odeint = boost::numeric::odeint;
using namespace rotorbench;
using namespace rotorbench::ode;
using bench::Pair;

/// Rigid birotor with the damping of the thesis' program; [y, y', z, z', alpha, alpha'].
struct Birotor {
  using State = Eigen::Matrix<double, 6, 1>;
  using Components = std::array<double, 6>;
  using ComponentAlgebra = odeint::array_algebra;
  static constexpr double kStep = 0.01;  // s
  static constexpr int kSteps = 6000;
  double drag = 0.05, arm = 0.25, force1 = 1, force2 = 2, mass = 2;

  /// Out of line, one piece of code for both sides: whether a compiler puts it into this stepper or
  /// that one is chance and moves the times by half.
  [[gnu::noinline]] void derivative(const double* y, double* d) const {
    const double vy = y[1], vz = y[3], rate = y[5];
    const double sine = std::sin(y[4]), cosine = std::cos(y[4]);
    const double thrust = force1 + force2;
    d[0] = vy;
    d[1] = (-thrust * sine - drag * vy) / mass;
    d[2] = vz;
    d[3] = (thrust * cosine - drag * vz) / mass;
    d[4] = rate;
    d[5] = (force2 - force1 - 2.0 * drag * arm * arm * rate) / (arm * mass);
  }
  void operator()(double, const State& y, State& d) const { derivative(y.data(), d.data()); }
  void operator()(const State& y, State& d, double) const { derivative(y.data(), d.data()); }
  void operator()(const Components& y, Components& d, double) const {
    derivative(y.data(), d.data());
  }

  [[gnu::noipa]] static Birotor make() { return {}; }
  [[gnu::noipa]] static State start() { return (State() << 3, 1, 2, -1, 5, 2).finished(); }
  static State adaptiveStart(int i) {
    State y = start();
    y[4] += 0.4 * i;
    y[5] += 0.2 * i;
    return y;
  }
};

/// The derivative of Multirotor<4> and nothing else of it: Odeint has no counterpart to
/// afterStep().
struct Quadrotor {
  using Model = Multirotor<4>;
  using State = Model::State;
  using Components = State;
  using ComponentAlgebra = bench::LoopAlgebra;
  static constexpr double kStep = 1e-3;  // s
  static constexpr int kSteps = 2000;
  Model model;

  void operator()(double t, const State& y, State& d) const { model(t, y, d); }
  void operator()(const State& y, State& d, double t) const { model(t, y, d); }

  [[gnu::noipa]] static Quadrotor make() {
    Quadrotor plant{Model(buildMultirotor<4>({}, {}))};
    plant.model.setCommand(plant.model.steadyDuties(plant.model.hoverSpeeds()));
    return plant;
  }
  [[gnu::noipa]] static State start() { return make().model.initialState({}); }
  static State adaptiveStart(int i) {
    State y = start();
    y.segment<4>(Model::Layout::kAttitude) = quaternionOf({0.2 + 0.02 * i, -0.1, 0.4 - 0.03 * i});
    make().model.setBodyRates(y, {0.5 + 0.05 * i, -1.0 + 0.1 * i, 2.0 - 0.07 * i});
    return y;
  }
};

template <class Plant>
constexpr double kSpan = Plant::kStep* Plant::kSteps;

/// The adaptive runs start in this many states. What one of them ends with hangs on chance, so that
/// a single error says little about a tolerance; the root mean square of many does.
constexpr int kStarts = 16;

/// The plant and the start are built once: the benchmarks copy them, which costs nothing beside the
/// run.
template <class Plant>
struct Problem {
  using State = typename Plant::State;
  Plant plant = Plant::make();
  State start = Plant::start();
  std::array<State, kStarts> adaptiveStarts = [] {
    std::array<State, kStarts> starts;
    for (int i = 0; i < kStarts; ++i) starts[static_cast<std::size_t>(i)] = Plant::adaptiveStart(i);
    return starts;
  }();
  static Problem& get() {
    static Problem problem;
    benchmark::DoNotOptimize(problem);
    return problem;
  }
};

template <class To, class From>
To converted(const From& from) {
  if constexpr (std::is_same_v<To, From>) {
    return from;
  } else {
    To to;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.size()); ++i) {
      to[static_cast<decltype(to.size())>(i)] = from[static_cast<decltype(from.size())>(i)];
    }
    return to;
  }
}

SolverSettings settingsOf(Method method, double step, double tolerance = 1e-6) {
  SolverSettings s;
  s.method = method;
  s.step = step;
  ScaledErrorControl control;
  control.relativeTolerance = control.absoluteTolerance = tolerance;
  s.errorControl = control;
  return s;
}

template <class Plant, class Tableau>
typename Plant::State ownSteps() {
  Plant plant = Problem<Plant>::get().plant;
  auto y = Problem<Plant>::get().start;
  RungeKutta<Tableau, Plant> stepper;
  for (int i = 0; i < Plant::kSteps; ++i) {
    stepper.step(plant, i * Plant::kStep, Plant::kStep, y, y);
    stepper.accept();
  }
  return y;
}

template <class Plant, class Stepper, class Vector>
Vector odeintSteps() {
  Plant plant = Problem<Plant>::get().plant;
  auto y = converted<Vector>(Problem<Plant>::get().start);
  Stepper stepper;
  for (int i = 0; i < Plant::kSteps; ++i) {
    stepper.do_step(std::ref(plant), y, i * Plant::kStep, Plant::kStep);
  }
  return y;
}

template <class Plant>
typename Plant::State sampled(Method method) {
  Plant plant = Problem<Plant>::get().plant;
  auto y = Problem<Plant>::get().start;
  Solver<Plant> solver(settingsOf(method, Plant::kStep), plant);
  for (int i = 1; i <= Plant::kSteps; ++i) solver.advanceTo(i * Plant::kStep, y);
  return y;
}

template <class Plant>
typename Plant::State free(Method method) {
  Plant plant = Problem<Plant>::get().plant;
  auto y = Problem<Plant>::get().start;
  Solver<Plant> solver(settingsOf(method, Plant::kStep), plant);
  solver.integrate(kSpan<Plant>, y);
  return y;
}

template <class Plant>
using Ends = std::array<typename Plant::State, kStarts>;

template <class Plant>
Ends<Plant> ownAdaptive(double tolerance) {
  Plant plant = Problem<Plant>::get().plant;
  Ends<Plant> ends = Problem<Plant>::get().adaptiveStarts;
  for (auto& y : ends) {
    Solver<Plant> solver(settingsOf(Method::Rk547M, Plant::kStep, tolerance), plant);
    solver.integrate(kSpan<Plant>, y);
  }
  return ends;
}

template <class Plant, class Stepper, class Vector>
Ends<Plant> odeintAdaptive(double tolerance) {
  Plant plant = Problem<Plant>::get().plant;
  Ends<Plant> ends = Problem<Plant>::get().adaptiveStarts;
  for (auto& end : ends) {
    auto y = converted<Vector>(end);
    odeint::integrate_adaptive(odeint::make_controlled<Stepper>(tolerance, tolerance),
                               std::ref(plant), y, 0.0, kSpan<Plant>, Plant::kStep);
    end = converted<typename Plant::State>(y);
  }
  return ends;
}

template <class Vector, class Algebra>
using OdeintRk4 = odeint::runge_kutta4<Vector, double, Vector, double, Algebra>;
template <class Vector, class Algebra>
using OdeintDopri5 = odeint::runge_kutta_dopri5<Vector, double, Vector, double, Algebra>;

template <class Run>
void add(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run());
  })->Unit(benchmark::kMicrosecond);
}

/// Runs of one plant, named after it.
template <class Plant>
class Comparison {
 public:
  Comparison(std::string name, std::vector<Pair>& pairs) : name_(std::move(name)), pairs_(pairs) {}

  void addFixed() {
    add(name_ + "_RK4_stepper", ownSteps<Plant, Rk4Tableau>);
    add(name_ + "_RK4_free", [] { return free<Plant>(Method::Rk4); });
    add(name_ + "_RK4_sampled", [] { return sampled<Plant>(Method::Rk4); });
    add(name_ + "_RK547M_stepper", ownSteps<Plant, Rk547MTableau>);
    add(name_ + "_RK4_odeint_components", odeintSteps<Plant, OdeintRk4<Part, PartAlgebra>, Part>);
    add(name_ + "_RK4_odeint_eigen", odeintSteps<Plant, OdeintRk4<State, EigenAlgebra>, State>);
    add(name_ + "_RK547M_odeint_components",
        odeintSteps<Plant, OdeintDopri5<Part, PartAlgebra>, Part>);
    add(name_ + "_RK547M_odeint_eigen",
        odeintSteps<Plant, OdeintDopri5<State, EigenAlgebra>, State>);
    for (const char* run : {"RK4_stepper", "RK4_free", "RK4_sampled", "RK547M_stepper"}) {
      compare(run, std::string(run).substr(0, std::string(run).find('_')) + "_odeint");
    }
  }

  /// Odeint at `tolerance`, and ours where it reaches the same error.
  void addAdaptive(double tolerance) {
    auto components = [tolerance] {
      return odeintAdaptive<Plant, OdeintDopri5<Part, PartAlgebra>, Part>(tolerance);
    };
    auto eigen = [tolerance] {
      return odeintAdaptive<Plant, OdeintDopri5<State, EigenAlgebra>, State>(tolerance);
    };
    const double wanted = error(components());
    const double own = toleranceFor(wanted);
    char label[32];
    std::snprintf(label, sizeof label, "%.0e", tolerance);
    std::printf("%s, adaptive: Odeint at %s has error %.3e; ours at %.2e has %.3e\n", name_.c_str(),
                label, wanted, own, error(ownAdaptive<Plant>(own)));
    const std::string run = std::string("RK547M_adaptive_") + label;
    add(name_ + "_" + run, [own] { return ownAdaptive<Plant>(own); });
    add(name_ + "_" + run + "_odeint_components", components);
    add(name_ + "_" + run + "_odeint_eigen", eigen);
    compare(run, run + "_odeint");
  }

 private:
  using State = typename Plant::State;
  using Part = typename Plant::Components;
  using PartAlgebra = typename Plant::ComponentAlgebra;
  using EigenAlgebra = odeint::vector_space_algebra;

  void compare(const std::string& ours, const std::string& theirs) {
    for (const char* way : {"components", "eigen"}) {
      pairs_.push_back({name_ + " " + ours + ", Odeint " + way, name_ + "_" + ours,
                        name_ + "_" + theirs + "_" + way});
    }
  }
  [[nodiscard]] double error(const Ends<Plant>& ends) const {
    double sum = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) sum += (ends[i] - exact_[i]).squaredNorm();
    return std::sqrt(sum / kStarts);
  }
  /// The largest tolerance of ours that ends with the wanted error or less, among 30 a decade.
  [[nodiscard]] double toleranceFor(double wanted) const {
    for (int i = -60; i > -420; --i) {
      const double tolerance = std::pow(10.0, i / 30.0);
      if (error(ownAdaptive<Plant>(tolerance)) <= wanted) return tolerance;
    }
    return 1e-14;
  }

  std::string name_;
  std::vector<Pair>& pairs_;
  Ends<Plant> exact_ = ownAdaptive<Plant>(1e-14);
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<Pair> pairs;
  Comparison<Birotor> birotor("birotor", pairs);
  Comparison<Quadrotor> quadrotor("quadrotor", pairs);
  birotor.addFixed();
  quadrotor.addFixed();
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    birotor.addAdaptive(tolerance);
    quadrotor.addAdaptive(tolerance);
  }
  return bench::runWithRatios(argc, argv, pairs);
}
