// Chooses the step of the embedded methods from their local error. Scaled control after Hairer,
// Norsett, Wanner I, section II.4 (elementary: h_new = safety h err^(-1/5)) and the PI controller
// of dopri5 (II, section IV.2, beta = 0.04); the 2014 thesis' control is the elementary one with an
// absolute tolerance and no limits. Scaled control keeps a step it would change by less than a few
// percent: where steps change all the time, each has to wait for the error of the one before it,
// and a kept step is nearly as good.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/ode/solver_settings.h"

namespace rotorbench::ode {

class StepControl {
 public:
  explicit StepControl(const SolverSettings& settings);

  /// Norm of the local error e of the step from y0 to y1: accepted up to 1; NaN if anything is not
  /// finite.
  template <class State>
  [[nodiscard]] double norm(const State& e, const State& y0, const State& y1) const {
    const auto q = e.array() / scale(y0, y1);
    if (norm_ == Norm::Maximum) return q.abs().template maxCoeff<Eigen::PropagateNaN>();
    const double squares = q.square().sum();
    return std::sqrt(norm_ == Norm::Rms ? squares / static_cast<double>(e.size()) : squares);
  }
  /// Norm against which derivatives are measured when the first step is chosen.
  template <class State>
  [[nodiscard]] double squaredSize(const State& v, const State& y) const {
    return (v.array() / (absolute_ + relative_ * y.array().abs())).square().sum();
  }
  /// Component with the largest share in the error.
  template <class State>
  [[nodiscard]] int worst(const State& e, const State& y0, const State& y1) const {
    int index = 0;
    (e.array() / scale(y0, y1)).abs().maxCoeff(&index);
    return index;
  }

  /// Ratio of the next step to the accepted one with error norm `error`.
  double growAfter(double error) {
    if (error > keepAbove_ && error <= keepUpTo_ && !rejected_) [[likely]] {
      lastError_ = error;
      return 1.0;
    }
    return changeAfter(error);
  }
  /// The same where a step cut short by the end of the span was accepted: it teaches the controller
  /// nothing.
  [[nodiscard]] double growAfterCut(double error) const;
  /// Ratio of the next try to the rejected one; `error` may be NaN.
  double shrinkAfter(double error);
  /// Forgets the errors of earlier steps.
  void forget();

  /// The thesis tries the whole span first.
  [[nodiscard]] bool startsWithWholeSpan() const { return thesis_; }

 private:
  double changeAfter(double error);

  template <class State>
  [[nodiscard]] auto scale(const State& y0, const State& y1) const {
    return absolute_ + relative_ * y0.array().abs().max(y1.array().abs());
  }

  double relative_ = 0, absolute_ = 0;
  Norm norm_ = Norm::Rms;
  double safety_ = 0.9, shrink_ = 0, grow_ = 0;
  double exponent_ = 0.2, beta_ = 0;
  bool thesis_ = false;
  bool rejected_ = false;  ///< the last try was rejected
  double lastError_ = 0;   ///< of the last accepted step
  // Errors between which the step is kept as it is; none where the first is infinite.
  double keepAbove_ = std::numeric_limits<double>::infinity(), keepUpTo_ = 0;
};

}  // namespace rotorbench::ode
