// RK4 and RK5(4)7M against Boost.Odeint on the rigid birotor of the thesis' experiment 1 (60 s), with one
// right-hand side for both. Odeint runs on std::array, its fastest state here, and on Eigen vectors. The adaptive runs
// are compared at equal achieved error: each side's tolerance is searched for first.
#include <benchmark/benchmark.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/external/eigen/eigen_algebra.hpp>
#include <cmath>
#include <cstdio>

#include "sim/ode/solver.h"
#include "tests/bench/ratio_report.h"

namespace {

namespace odeint = boost::numeric::odeint;
using namespace rotorbench::ode;
using Array = std::array<double, 6>;

constexpr double kSpan = 60.0;
constexpr double kStep = 0.01;
constexpr int kSteps = 6000;

/// Rigid birotor with the damping of the thesis' program; [y, y', z, z', alpha, alpha'].
struct Birotor {
  using State = Eigen::Matrix<double, 6, 1>;
  double drag = 0.05, arm = 0.25, force1 = 1, force2 = 2, mass = 2;

  template <class Vector>
  void derivative(const Vector& y, Vector& d) const {
    const double thrust = force1 + force2;
    d[0] = y[1];
    d[1] = (-thrust * std::sin(y[4]) - drag * y[1]) / mass;
    d[2] = y[3];
    d[3] = (thrust * std::cos(y[4]) - drag * y[3]) / mass;
    d[4] = y[5];
    d[5] = (force2 - force1 - 2.0 * drag * arm * arm * y[5]) / (arm * mass);
  }
  void operator()(double, const State& y, State& d) const { derivative(y, d); }
  void operator()(const State& y, State& d, double) const { derivative(y, d); }
  void operator()(const Array& y, Array& d, double) const { derivative(y, d); }
};

template <class Vector>
Vector initialState() {
  Vector y;
  y[0] = 3, y[1] = 1, y[2] = 2, y[3] = -1, y[4] = 5, y[5] = 2;
  return y;
}

template <class Vector>
double difference(const Vector& a, const Birotor::State& b) {
  double squares = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double d = a[static_cast<typename Birotor::State::Index>(i)] - b[static_cast<int>(i)];
    squares += d * d;
  }
  return std::sqrt(squares);
}
double difference(const Array& a, const Birotor::State& b) {
  return (Eigen::Map<const Birotor::State>(a.data()) - b).norm();
}

SolverSettings settingsOf(Method method, double tolerance = 1e-6) {
  SolverSettings s;
  s.method = method;
  s.step = kStep;
  ScaledErrorControl control;
  control.relativeTolerance = control.absoluteTolerance = tolerance;
  s.errorControl = control;
  return s;
}

Birotor::State sampled(Method method) {
  Birotor plant;
  SolverSettings settings = settingsOf(method, 1.0);
  settings.maximumStep = kStep;
  settings.initialStep = kStep;
  Solver<Birotor> solver(settings, plant);
  auto y = initialState<Birotor::State>();
  for (int i = 1; i <= kSteps; ++i) solver.advanceTo(i * kStep, y);
  return y;
}

Birotor::State free(Method method, double tolerance) {
  Birotor plant;
  Solver<Birotor> solver(settingsOf(method, tolerance), plant);
  auto y = initialState<Birotor::State>();
  solver.integrate(kSpan, y);
  return y;
}

template <class Stepper, class Vector>
Vector odeintFixed() {
  Birotor plant;
  Stepper stepper;
  auto y = initialState<Vector>();
  for (int i = 0; i < kSteps; ++i) stepper.do_step(std::ref(plant), y, i * kStep, kStep);
  return y;
}

template <class Vector, class Algebra>
Vector odeintAdaptive(double tolerance) {
  Birotor plant;
  auto y = initialState<Vector>();
  using Stepper = odeint::runge_kutta_dopri5<Vector, double, Vector, double, Algebra>;
  odeint::integrate_adaptive(odeint::make_controlled<Stepper>(tolerance, tolerance),
                             std::ref(plant), y, 0.0, kSpan, kStep);
  return y;
}

using State = Birotor::State;
using EigenAlgebra = odeint::vector_space_algebra;
using ArrayAlgebra = odeint::array_algebra;
using EigenRk4 = odeint::runge_kutta4<State, double, State, double, EigenAlgebra>;
using ArrayRk4 = odeint::runge_kutta4<Array, double, Array, double, ArrayAlgebra>;
using EigenDopri5 = odeint::runge_kutta_dopri5<State, double, State, double, EigenAlgebra>;
using ArrayDopri5 = odeint::runge_kutta_dopri5<Array, double, Array, double, ArrayAlgebra>;

/// The tolerance at which `run` ends with the wanted error, by bisection on its logarithm.
template <class Run>
double toleranceFor(Run&& run, double wanted, const State& exact) {
  double low = -13, high = -2;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (difference(run(std::pow(10.0, middle)), exact) > wanted ? high : low) = middle;
  }
  return std::pow(10.0, 0.5 * (low + high));
}

template <class Run>
void add(const char* name, Run run) {
  benchmark::RegisterBenchmark(name, [run](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run());
    state.counters["steps/s"] =
        benchmark::Counter(kSteps, benchmark::Counter::kIsIterationInvariantRate);
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

int main(int argc, char** argv) {
  Birotor plant;
  SolverSettings fine = settingsOf(Method::Rk547M, 1e-14);
  Solver<Birotor> reference(fine, plant);
  auto exact = initialState<State>();
  reference.integrate(kSpan, exact);

  add("RK4", [] { return sampled(Method::Rk4); });
  add("RK4_odeint_array", [] { return odeintFixed<ArrayRk4, Array>(); });
  add("RK4_odeint_eigen", [] { return odeintFixed<EigenRk4, State>(); });
  add("RK547M_fixed", [] { return sampled(Method::Rk547M); });
  add("RK547M_fixed_odeint_array", [] { return odeintFixed<ArrayDopri5, Array>(); });
  add("RK547M_fixed_odeint_eigen", [] { return odeintFixed<EigenDopri5, State>(); });

  std::vector<rotorbench::bench::Pair> pairs{
      {"RK4, h = 10 ms, Odeint on std::array", "RK4", "RK4_odeint_array"},
      {"RK4, h = 10 ms, Odeint on Eigen", "RK4", "RK4_odeint_eigen"},
      {"RK5(4)7M, h = 10 ms, Odeint on std::array", "RK547M_fixed", "RK547M_fixed_odeint_array"},
      {"RK5(4)7M, h = 10 ms, Odeint on Eigen", "RK547M_fixed", "RK547M_fixed_odeint_eigen"}};
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const double wanted = difference(odeintAdaptive<Array, ArrayAlgebra>(tolerance), exact);
    const double own =
        toleranceFor([](double x) { return free(Method::Rk547M, x); }, wanted, exact);
    char label[32];
    std::snprintf(label, sizeof label, "%.0e", tolerance);
    const std::string suffix = std::string("_error_of_odeint_at_") + label;
    const std::string same = std::string("_tolerance_") + label;
    std::printf(
        "Odeint at tolerance %s: error %.2e; ours at %.2e: error %.2e; ours at %s: error %.2e\n",
        label, wanted, own, difference(free(Method::Rk547M, own), exact), label,
        difference(free(Method::Rk547M, tolerance), exact));
    add(("RK547M" + suffix).c_str(), [own] { return free(Method::Rk547M, own); });
    add(("RK547M" + same).c_str(), [tolerance] { return free(Method::Rk547M, tolerance); });
    add(("RK547M" + same + "_odeint").c_str(),
        [tolerance] { return odeintAdaptive<Array, ArrayAlgebra>(tolerance); });
    pairs.push_back({"RK5(4)7M adaptive, equal error, Odeint at tolerance " + std::string(label),
                     "RK547M" + suffix, "RK547M" + same + "_odeint"});
    pairs.push_back({"RK5(4)7M adaptive, equal tolerance " + std::string(label), "RK547M" + same,
                     "RK547M" + same + "_odeint"});
  }
  return rotorbench::bench::runWithRatios(argc, argv, pairs);
}
