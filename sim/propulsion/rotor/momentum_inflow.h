// The induced velocity momentum theory asks for, given the thrust of an annulus, in hover, climb,
// descent and oblique flow. Speeds along the rotor axis are positive in climb (air coming from the
// front); the induced velocity is positive when it adds to the climb, that is for positive thrust.
//   axial flow:   H. Glauert; J. G. Leishman, Principles of Helicopter Aerodynamics, 2nd ed., sec.
//     2.13
//   oblique flow: H. Glauert, "A general theory of the autogyro", ARC R&M 1111, 1926
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"

namespace rotorbench {

/// Prandtl's factor of the induced velocity lost around the tips, from B (R - r)/(2 r) and the sine
/// of the inflow angle.
inline double tipLoss(double tipDistance, double sine) {
  constexpr double kLeast = 1e-4;
  const double exponent = tipDistance / std::max(std::abs(sine), 1e-12);
  return std::max(kLeast, 2 / kPi * std::acos(std::exp(-exponent)));
}

/// Ends of the vortex ring state, in axial speeds over the hover induced velocity: where the
/// empirical curve leaves the climb and the windmill solution.
inline constexpr double kRingTop = -1.5, kRingBottom = -2.5;

/// Induced velocity in axial flow, m/s, for h = v^2 in hover, m^2/s^2: v (V + v) = h in hover,
/// climb and slow descent, v (V + v) = -h in the windmill brake state, and between them, where
/// momentum theory has no answer, a cubic that meets both with their slopes. Odd: v(-h, -V) = -v(h,
/// V).
inline double axialInducedVelocity(double h, double axial) {
  if (h < 0) return -axialInducedVelocity(-h, -axial);
  if (h == 0) return 0;
  const double q = std::sqrt(h), half = axial / 2;
  if (axial >= kRingTop * q) {
    const double root = std::sqrt(half * half + h);
    return axial > 0 ? h / (half + root) : root - half;
  }
  if (axial <= kRingBottom * q) return h / (-half + std::sqrt(std::max(0.0, half * half - h)));
  // The ends and slopes of both solutions in v/q against V/q: 1/2 and 1/3, 2 and -4/5.
  constexpr double kLow = 0.5, kLowSlope = 1.0 / 3, kHigh = 2, kHighSlope = -0.8;
  const double t = axial / q - kRingBottom, s = 1 - t;
  return q * (kLow * (1 + 2 * t) * s * s + kLowSlope * t * s * s + kHigh * t * t * (3 - 2 * t) -
              kHighSlope * t * t * s);
}

/// Induced velocity with an in-plane speed, m/s: Glauert's v sqrt(Vi^2 + (V + v)^2) = h, with the
/// speed through the disc continued through the vortex ring state so that no in-plane speed gives
/// axialInducedVelocity().
inline double inducedVelocity(double h, double axial, double inPlane) {
  if (h < 0) return -inducedVelocity(-h, -axial, inPlane);
  const double still = axialInducedVelocity(h, axial);
  if (inPlane == 0 || h == 0 || still <= 0) return still;
  const double q = std::sqrt(h), m = inPlane / q, top = still / q;
  // Speed through the disc near the axial solution: 1/top there, growing with v in climb, falling
  // in the windmill brake state, the slope passing smoothly from one to the other.
  const double t = std::clamp(axial / q - kRingBottom, 0.0, 1.0);
  const double slope = 2 * t * t * (3 - 2 * t) - 1;
  const double atTop = 1 / top;
  // Newton's method between nothing and the axial solution, where w sqrt(...) passes 1; halving
  // where it would leave them.
  constexpr int kMostSteps = 60;
  constexpr double kSmallStep = 1e-6;  // the error after it is of the order of its square
  double low = 0, high = top, w = 1 / std::sqrt(m * m + atTop * atTop);
  for (int i = 0; i < kMostSteps; ++i) {
    const double through = atTop + slope * (w - top);
    const double speed = std::sqrt(m * m + through * through);
    const double excess = w * speed - 1;
    (excess < 0 ? low : high) = w;
    const double next = w - excess * speed / (speed * speed + w * through * slope);
    const double last = w;
    w = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(w - last) <= kSmallStep * top) break;
  }
  return w * q;
}

}  // namespace rotorbench
