// The induced velocity at which a residual R(v) vanishes. In hover and climb there is one root. In descent,
// stalled sections leave several; then the roots' alternating sum is taken, first less second plus third, which
// is the length of v over which R still has the sign it has at 0. It leads from the lone root on one side of such
// a range to the one on the other without a jump, through the middle of the hysteresis. In fast descent that
// length is measured with a soft edge instead, for the inflow of a vortex ring is a mean over fluctuations
// anyway: the loads become smooth there and can be tabulated.
#pragma once

#include "sim/propulsion/analytic_section.h"
#include "sim/propulsion/bracketed_root.h"

namespace rotorbench {

/// How the root is taken, by the advance ratio J = V/(n D).
struct RootRule {
  bool many = false;    ///< look for several roots
  double softness = 0;  ///< weight of the soft edge, 0 to 1

  /// One root above J = -0.1, several below, the soft edge coming in from -0.35 to -0.6.
  static RootRule at(double advance) {
    constexpr double kSeveral = -0.1, kSoftFrom = -0.35, kSoftTo = -0.6;
    const double t = std::clamp((advance - kSoftFrom) / (kSoftTo - kSoftFrom), 0.0, 1.0);
    return {advance < kSeveral, t * t * (3 - 2 * t)};
  }
};

inline constexpr double kInflowTolerance = 1e-10;  // of the section's speed

/// Alternating sum of the roots between 0 and `end`, R having opposite signs there.
template <class Residual>
double alternatingRoots(const Residual& residual, double atZero, double end, double atEnd,
                        double tolerance) {
  constexpr int kSteps = 24;
  double sum = 0, sign = 1, from = 0, atFrom = atZero;
  for (int i = 1; i <= kSteps; ++i) {
    const double to = end * i / kSteps, atTo = i < kSteps ? residual(to) : atEnd;
    if ((atTo > 0) != (atFrom > 0)) {
      sum += sign * bracketedRoot(residual, from, atFrom, to, atTo, tolerance);
      sign = -sign;
    }
    from = to, atFrom = atTo;
  }
  return sum;
}

/// The same length with a soft edge: the integral of 1/(1 + exp(R/e)), R taken as straight between its values at
/// equal steps. It begins a little before 0, so that the edge of a small root is not cut off.
template <class Residual>
double softRoot(const Residual& residual, double end) {
  constexpr int kSteps = 32;
  constexpr double kEdge = 0.08, kBefore = 0.25;  // e and the lead, as parts of `end`
  const auto softplus = [](double x) {
    return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x)));
  };
  const double sign = end < 0 ? -1 : 1, length = std::abs(end);
  const double before = kBefore * length, edge = kEdge * length, step = (length + before) / kSteps;
  double sum = -before, r = sign * residual(-sign * before), area = softplus(-r / edge);
  for (int i = 1; i <= kSteps; ++i) {
    const double next = sign * residual(sign * (i * step - before));
    const double nextArea = softplus(-next / edge);
    // The difference quotient loses its digits where R is level.
    constexpr double kLevel = 1e-6;
    sum += std::abs(next - r) > kLevel * edge ? step * edge * (area - nextArea) / (next - r)
                                              : step * logistic(-next / edge);
    r = next, area = nextArea;
  }
  return sign * sum;
}

/// Induced velocity, m/s, for a residual that tends to v for large v. The bracket starts with `reach`, the
/// induced velocity at which the section has no lift; `speed` is that of the section, m/s, above 0.
template <class Residual>
double inflowRoot(const Residual& residual, double reach, double speed, RootRule rule) {
  constexpr double kLeastBracket = 0.02, kGrowth = 1.4;
  const double atZero = residual(0);
  if (atZero == 0) return 0;
  const double least = kLeastBracket * speed;
  double end = atZero < 0 ? std::max(reach, least) : std::min(reach, -least);
  double atEnd = residual(end);
  for (int i = 0; i < 60 && (atEnd > 0) == (atZero > 0) && atEnd != 0; ++i) {
    end *= kGrowth;
    atEnd = residual(end);
  }
  const double tolerance = kInflowTolerance * speed;
  if (!rule.many) return bracketedRoot(residual, 0, atZero, end, atEnd, tolerance);
  const double soft = rule.softness > 0 ? softRoot(residual, end) : 0;
  if (rule.softness >= 1) return soft;
  const double sharp = alternatingRoots(residual, atZero, end, atEnd, tolerance);
  return sharp + rule.softness * (soft - sharp);
}

}  // namespace rotorbench
