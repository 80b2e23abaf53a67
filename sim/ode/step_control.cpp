#include "sim/ode/step_control.h"

#include <limits>

namespace rotorbench::ode {
namespace {

constexpr double kPiBeta = 0.04;         // dopri5's default
constexpr double kSmallestError = 1e-4;  // dopri5: the PI memory never holds less

}  // namespace

StepControl::StepControl(const SolverSettings& settings) {
  if (const auto* thesis = std::get_if<ThesisErrorControl>(&settings.errorControl)) {
    absolute_ = thesis->tolerance;
    norm_ = thesis->norm;
    grow_ = std::numeric_limits<double>::infinity();
    thesis_ = true;
  } else {
    const auto& scaled = std::get<ScaledErrorControl>(settings.errorControl);
    relative_ = scaled.relativeTolerance;
    absolute_ = scaled.absoluteTolerance;
    norm_ = scaled.norm;
    safety_ = scaled.safety;
    shrink_ = scaled.shrinkLimit;
    grow_ = scaled.growthLimit;
    if (scaled.controller == StepController::ProportionalIntegral) {
      beta_ = kPiBeta;
      exponent_ = 0.2 - 0.75 * kPiBeta;
    }
    // Where the error does not change, the factor is safety * error^-(exponent - beta).
    const double kept = scaled.keptChange, inverse = 1 / (exponent_ - beta_);
    if (kept > 0) {
      keepAbove_ = std::pow(safety_ / (1 + kept), inverse);
      keepUpTo_ = std::min(1.0, std::pow(safety_ / (1 - kept), inverse));
    }
  }
  forget();
}

void StepControl::forget() {
  rejected_ = false;
  lastError_ = 0;
}

double StepControl::changeAfter(double error) {
  double factor = 0;
  if (beta_ > 0) {
    factor = safety_ * std::exp(beta_ * std::log(std::max(lastError_, kSmallestError)) -
                                exponent_ * std::log(error));
    lastError_ = error;
  } else {
    factor = safety_ * std::pow(error, -exponent_);
  }
  factor = std::clamp(factor, shrink_, grow_);
  if (rejected_ && !thesis_) factor = std::min(factor, 1.0);
  rejected_ = false;
  return factor;
}

double StepControl::growAfterCut(double error) const {
  return std::clamp(safety_ * std::pow(error, -0.2), shrink_, grow_);
}

double StepControl::shrinkAfter(double error) {
  rejected_ = true;
  constexpr double kNotFinite = 0.1;
  if (!std::isfinite(error)) return std::max(kNotFinite, shrink_);
  const double factor = safety_ * std::pow(error, -exponent_);
  return std::clamp(factor, shrink_, 1.0);
}

}  // namespace rotorbench::ode
