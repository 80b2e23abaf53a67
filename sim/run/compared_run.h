// One method's part in a solver comparison: it runs over the problem, its error against the
// reference is recorded and its cost counted. Used for the recorded runs, for the timing pass and
// for each point of the work-precision diagram.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "sim/document/solver_comparison.h"
#include "sim/ode/solver.h"
#include "sim/run/reference_solution.h"

namespace rotorbench {

/// The settings a method runs with in a comparison. `refinement` divides the step of a fixed-step
/// method and `tolerance` multiplies the tolerances of an embedded one.
ode::SolverSettings comparedSettings(const SolverComparison& comparison, ode::Method method,
                                     double refinement = 1, double toleranceFactor = 1);

template <class Plant>
class ComparedRun {
 public:
  using State = typename Plant::State;
  using Reference = ReferenceSolution<Plant>;
  /// Called with time, state, error norm and length of the step or sample; false ends the run.
  using Observer = std::function<bool(double, const State&, double, double)>;

  ComparedRun(const SolverComparison& comparison, const ode::SolverSettings& settings, Plant& plant)
      : mode_(comparison.mode),
        interval_(comparison.sampleInterval),
        duration_(comparison.duration),
        budget_(settings.maximumSteps),
        solver_(settings, plant),
        y_(plant.initialState()) {}

  /// Sampled mode: on to the next sample instant. Free mode: on by about `kFreeSlice` tried steps.
  /// Failed too where the whole run takes more steps than the settings' budget: with a hopeless
  /// tolerance it would never end.
  ode::Status advance(Reference* reference, const Observer& observer) {
    const ode::Status status = mode_ == DrivingMode::Free ? advanceFreely(reference, observer)
                                                          : advanceToSample(reference, observer);
    const bool spent = !done() && solver_.statistics().attempts() >= budget_;
    return spent ? ode::Status::Failed : status;
  }

  [[nodiscard]] bool done() const { return !(solver_.time() < duration_); }
  [[nodiscard]] const State& state() const { return y_; }
  [[nodiscard]] double maxError() const { return maxError_; }
  [[nodiscard]] const ode::Solver<Plant>& solver() const { return solver_; }

 private:
  static constexpr std::int64_t kFreeSlice = 5000;

  ode::Status advanceToSample(Reference* reference, const Observer& observer) {
    ++samples_;
    const double end = std::min(duration_, static_cast<double>(samples_) * interval_);
    const bool last = duration_ - end < 1e-9 * interval_;
    const ode::Status status = solver_.advanceTo(last ? duration_ : end, y_);
    if (status != ode::Status::Failed && !observe(reference, observer, interval_))
      return ode::Status::Stopped;
    return status;
  }

  ode::Status advanceFreely(Reference* reference, const Observer& observer) {
    const std::int64_t enough = solver_.statistics().attempts() + kFreeSlice;
    bool stopped = false;
    ode::Watch<State> watch;
    watch.onStep = [&](const ode::StepView<State>& step) {
      stopped = !observe(reference, observer, step.end - step.start);
      return !stopped && solver_.statistics().attempts() < enough;
    };
    const ode::Status status = solver_.integrate(duration_, y_, watch);
    if (status == ode::Status::Failed) return status;
    return stopped ? ode::Status::Stopped : ode::Status::Done;
  }

  bool observe(Reference* reference, const Observer& observer, double step) {
    double error = 0;
    if (reference != nullptr) {
      error = (y_ - reference->at(solver_.time())).norm();
      // NaN must not hide behind max(): a diverged method has no finite error.
      maxError_ = std::isfinite(error) ? std::max(maxError_, error)
                                       : std::numeric_limits<double>::infinity();
    }
    return !observer || observer(solver_.time(), y_, error, step);
  }

  DrivingMode mode_;
  double interval_, duration_;
  std::int64_t budget_;
  ode::Solver<Plant> solver_;
  State y_;
  std::int64_t samples_ = 0;
  double maxError_ = 0;
};

}  // namespace rotorbench
