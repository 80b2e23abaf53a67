// The induced velocity at which a residual R(v) vanishes. In hover and climb there is one root. In
// descent, stalled sections leave several; then the roots' alternating sum is taken, first less
// second plus third, which is the length of v over which R still has the sign it has at 0. It leads
// from the lone root on one side of such a range to the one on the other without a jump, through
// the middle of the hysteresis. In fast descent that length is measured with a soft edge instead,
// for the inflow of a vortex ring is a mean over fluctuations anyway: the loads become smooth there
// and can be tabulated.
#pragma once

#include <array>
#include <limits>

#include "sim/core/constants.h"
#include "sim/numerics/bracketed_root.h"
#include "sim/propulsion/rotor/analytic_section.h"

namespace rotorbench {

/// 0 up to 0, 1 from 1 on, smooth in between.
inline double smoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// V/(n D) from the axial and the tip's speed; far outside every table at a standstill.
inline double advanceRatio(double axial, double tip) {
  return kPi * axial / std::max(tip, 1e-9 * std::abs(axial) + std::numeric_limits<double>::min());
}

/// How the root is taken, by the advance ratio J = V/(n D).
struct RootRule {
  bool many = false;    ///< look for several roots
  double softness = 0;  ///< weight of the soft edge, 0 to 1

  /// In axial flow one root above J = -0.1, several below, the soft edge coming in from -0.35 to
  /// -0.6. In a stream from the side, `edgewise` times the tips' speed, the blades pass all angles
  /// of attack in every turn, and their annuli jump between roots one after the other: from an
  /// edgewise ratio of 0.05 on the soft edge comes in from -0.05 to -0.2.
  static RootRule at(double advance, double edgewise = 0) {
    constexpr double kFullyEdgewise = 0.05;
    constexpr double kSeveral[] = {-0.1, -0.05}, kSoftFrom[] = {-0.35, -0.05},
                     kSoftTo[] = {-0.6, -0.2};
    const double share = smoothStep(edgewise / kFullyEdgewise);
    const double from = std::lerp(kSoftFrom[0], kSoftFrom[1], share),
                 to = std::lerp(kSoftTo[0], kSoftTo[1], share);
    return {advance < std::lerp(kSeveral[0], kSeveral[1], share),
            smoothStep((advance - from) / (to - from))};
  }
};

inline constexpr double kInflowTolerance = 1e-10;  // of the section's speed

/// R at equal steps from a little before 0 to `end`, between which and 0 it has opposite signs.
struct ResidualSamples {
  static constexpr int kBefore = 5, kSteps = 20;  ///< steps before 0 and up to `end`
  double end = 0;
  std::array<double, kBefore + kSteps + 1> values{};

  [[nodiscard]] double place(int i) const { return end * (i - kBefore) / kSteps; }

  template <class Residual>
  void take(const Residual& residual, int first, double atZero, double atEnd) {
    for (int i = first; i < kBefore + kSteps; ++i)
      values[static_cast<std::size_t>(i)] = i == kBefore ? atZero : residual(place(i));
    values.back() = atEnd;
  }
};

/// Alternating sum of the roots between 0 and the end.
template <class Residual>
double alternatingRoots(const Residual& residual, const ResidualSamples& samples,
                        double tolerance) {
  double sum = 0, sign = 1;
  for (int i = samples.kBefore; i < samples.kBefore + samples.kSteps; ++i) {
    const double from = samples.values[static_cast<std::size_t>(i)],
                 to = samples.values[static_cast<std::size_t>(i) + 1];
    if ((to > 0) == (from > 0)) continue;
    sum +=
        sign * bracketedRoot(residual, samples.place(i), from, samples.place(i + 1), to, tolerance);
    sign = -sign;
  }
  return sum;
}

/// The same length with a soft edge: the integral of 1/(1 + exp(R/e)), R taken as straight between
/// its samples. It begins before 0, so that the edge of a small root is not cut off; outside the
/// samples R goes on with a slope of 1, as it does far away. So a straight R gives its root
/// wherever the samples end.
inline double softRoot(const ResidualSamples& samples) {
  constexpr double kEdge = 0.08;  // e as a part of the end
  const auto softplus = [](double x) {
    return std::max(x, 0.0) + std::log1p(std::exp(-std::abs(x)));
  };
  const double sign = samples.end < 0 ? -1 : 1, length = std::abs(samples.end);
  const double edge = kEdge * length, step = length / samples.kSteps;
  double r = sign * samples.values[0], area = softplus(-r / edge);
  double sum = -step * samples.kBefore - edge * softplus(r / edge);
  for (std::size_t i = 1; i < samples.values.size(); ++i) {
    const double next = sign * samples.values[i];
    const double nextArea = softplus(-next / edge);
    // The difference quotient loses its digits where R is level.
    constexpr double kLevel = 1e-6;
    sum += std::abs(next - r) > kLevel * edge ? step * edge * (area - nextArea) / (next - r)
                                              : step * logistic(-next / edge);
    r = next, area = nextArea;
  }
  return sign * (sum + edge * area);
}

/// Induced velocity, m/s, for a residual that tends to v for large v. The bracket starts with
/// `reach`, the induced velocity at which the section has no lift; `speed` is that of the section,
/// m/s, above 0.
template <class Residual>
double inflowRoot(const Residual& residual, double reach, double speed, RootRule rule) {
  constexpr double kLeastBracket = 0.02, kGrowth = 1.4;
  const double atZero = residual(0);
  if (atZero == 0) return 0;
  const double least = kLeastBracket * speed;
  double end = atZero < 0 ? std::max(reach, least) : std::min(reach, -least);
  // The length of the bracket is part of a soft answer: it must not depend on the sign of next to
  // nothing.
  if (rule.many) end = std::copysign(std::max(std::abs(reach), least), -atZero);
  double atEnd = residual(end);
  double shorter = end, atShorter = atEnd;
  for (int i = 0; i < 60 && (atEnd > 0) == (atZero > 0) && atEnd != 0; ++i) {
    shorter = end, atShorter = atEnd;
    end *= kGrowth;
    atEnd = residual(end);
  }
  const double tolerance = kInflowTolerance * speed;
  if (!rule.many) return bracketedRoot(residual, 0, atZero, end, atEnd, tolerance);
  if (shorter != end) {
    // Nor may it grow in jumps.
    end = bracketedRoot(residual, shorter, atShorter, end, atEnd, tolerance);
    atEnd = -std::copysign(std::numeric_limits<double>::min(), atZero);
  }
  ResidualSamples samples;
  samples.end = end;
  samples.take(residual, rule.softness > 0 ? 0 : samples.kBefore, atZero, atEnd);
  const double soft = rule.softness > 0 ? softRoot(samples) : 0;
  if (rule.softness >= 1) return soft;
  const double sharp = alternatingRoots(residual, samples, tolerance);
  return sharp + rule.softness * (soft - sharp);
}

}  // namespace rotorbench
