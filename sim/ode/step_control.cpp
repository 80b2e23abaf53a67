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
  }
  forget();
}

void StepControl::forget() {
  rejected_ = false;
  lastTerm_ = beta_ * std::log(kSmallestError);
}

double StepControl::growAfter(double error) {
  double factor = 0;
  if (beta_ > 0) {
    factor = safety_ * std::exp(lastTerm_ - exponent_ * std::log(error));
    lastTerm_ = beta_ * std::log(std::max(error, kSmallestError));
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
