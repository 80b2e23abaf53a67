// The reference of a solver comparison: the problem integrated by RK4 with a small step, kept at
// every step, and read at any time by one more, shorter RK4 step from the kept state before it: as
// accurate there as at the steps.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/ode/solver.h"

namespace rotorbench {

template <class Plant>
class ReferenceSolution {
 public:
  using State = typename Plant::State;

  ReferenceSolution(Plant& plant, double step, double duration)
      : step_(step),
        count_(static_cast<std::int64_t>(std::ceil(duration / step - 1e-9))),
        solver_({.method = ode::Method::Rk4, .step = step}, plant),
        between_({.method = ode::Method::Rk4, .step = step}, plant),
        y_(plant.initialState()) {
    states_.reserve(static_cast<std::size_t>(count_) + 1);
    states_.push_back(y_);
  }

  /// Integrates to time t (or to the end). Failed if the solution stops being finite.
  ode::Status extendTo(double t) {
    while (static_cast<std::int64_t>(states_.size()) <= count_ && solver_.time() < t) {
      const auto next = static_cast<double>(states_.size()) * step_;
      if (solver_.advanceTo(next, y_) == ode::Status::Failed) return ode::Status::Failed;
      states_.push_back(y_);
    }
    return ode::Status::Done;
  }

  /// The solution at time t within the span integrated so far.
  State at(double t) {
    const double steps = t / step_;
    const auto last = static_cast<double>(states_.size() - 1);
    const double nearest = std::min(std::round(steps), last);
    if (std::abs(steps - nearest) < 1e-7) return states_[static_cast<std::size_t>(nearest)];
    const double before = std::min(std::floor(steps), last);
    State y = states_[static_cast<std::size_t>(before)];
    between_.reset(before * step_);
    between_.advanceTo(t, y);
    return y;
  }

  [[nodiscard]] double time() const { return solver_.time(); }
  [[nodiscard]] RunFailure runFailure() const { return solver_.runFailure(); }

 private:
  double step_;
  std::int64_t count_;
  ode::Solver<Plant> solver_, between_;
  State y_;
  std::vector<State> states_;
};

}  // namespace rotorbench
