#include "sim/validation/propeller_scores.h"

#include <cmath>

#include "sim/core/constants.h"
#include "sim/numerics/scalar_search.h"
#include "sim/propulsion/rotor/advance_sweep.h"
#include "sim/validation/statistics.h"

namespace rotorbench::validation {

namespace {

/// Static coefficients at a speed, linear between the measured ones, the ends beyond them.
Coefficients stillAt(const PropellerSet& set, double speed) {
  const auto& rows = set.still;
  if (speed <= rows.front().speed) return {rows.front().thrust, rows.front().power};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (speed > rows[i].speed) continue;
    const PropellerPoint &a = rows[i - 1], &b = rows[i];
    const double t = (speed - a.speed) / (b.speed - a.speed);
    return {a.thrust + t * (b.thrust - a.thrust), a.power + t * (b.power - a.power)};
  }
  return {rows.back().thrust, rows.back().power};
}

/// Advance ratio where CT of a run passes 0 from above, if it does.
std::optional<double> zeroThrustAdvance(const std::vector<PropellerPoint>& run) {
  for (std::size_t i = 1; i < run.size(); ++i) {
    const PropellerPoint &a = run[i - 1], &b = run[i];
    if (a.thrust > 0 && b.thrust <= 0) {
      return a.advance + (b.advance - a.advance) * a.thrust / (a.thrust - b.thrust);
    }
  }
  return std::nullopt;
}

double zeroThrustAdvance(const BladeElementRotor& rotor, double speed) {
  constexpr double kMost = 3;  // no propeller here has a pitch of three diameters
  const auto thrust = [&](double advance) { return coefficients(rotor, speed, advance).thrust; };
  return findRoot(thrust, 0, kMost, 1e-6);
}

double peakEfficiency(const std::vector<PropellerPoint>& run) {
  double peak = 0;
  for (const PropellerPoint& r : run) {
    if (r.power > 0) peak = std::max(peak, r.advance * r.thrust / r.power);
  }
  return peak;
}

}  // namespace

Coefficients coefficients(const BladeElementRotor& rotor, double omega, double advance,
                          const AirState& air) {
  const double speed = advance * omega / kTurn * 2 * rotor.radius();
  const AdvancePoint point = advancePoint(rotor, omega, speed, air);
  return {point.thrustCoefficient, point.powerCoefficient};
}

PropellerScore scoreAtRest(const PropellerSet& set, const BladeElementRotor& rotor) {
  std::vector<double> thrust, power;
  for (const PropellerPoint& r : set.still) {
    const Coefficients c = coefficients(rotor, r.speed, 0);
    thrust.push_back(std::abs(c.thrust / r.thrust - 1));
    power.push_back(std::abs(c.power / r.power - 1));
  }
  return {100 * mean(thrust), 100 * mean(power), {}, {}, {}, {}};
}

PropellerScore scoreOf(const PropellerSet& set, const BladeElementRotor& rotor) {
  PropellerScore s = scoreAtRest(set, rotor);
  std::vector<double> thrust, power, peak, zero;
  for (const auto& run : set.flights) {
    std::vector<PropellerPoint> model = run;
    for (PropellerPoint& r : model) {
      const Coefficients c = coefficients(rotor, r.speed, r.advance);
      const Coefficients still = stillAt(set, r.speed);
      thrust.push_back(100 * std::abs(c.thrust - r.thrust) / still.thrust);
      power.push_back(100 * std::abs(c.power - r.power) / still.power);
      r.thrust = c.thrust, r.power = c.power;
    }
    if (run.empty()) continue;
    peak.push_back(100 * std::abs(peakEfficiency(model) - peakEfficiency(run)));
    if (const auto measured = zeroThrustAdvance(run)) {
      zero.push_back(100 * std::abs(zeroThrustAdvance(rotor, run.front().speed) / *measured - 1));
    }
  }
  s.flightThrust = meanIfAny(thrust), s.flightPower = meanIfAny(power);
  s.peak = meanIfAny(peak), s.zeroThrust = meanIfAny(zero);
  return s;
}

double fittedTwistOffset(const PropellerSet& set) {
  constexpr double kMost = 12 * kDegree, kCoarse = 2 * kDegree;
  PropellerGeometry geometry = set.geometry;
  const auto error = [&](double offset) {
    geometry.twistOffset = offset;
    const BladeElementRotor rotor(geometry);
    double sum = 0;
    for (const PropellerPoint& r : set.still) {
      const Coefficients c = coefficients(rotor, r.speed, 0);
      // A twist without thrust or power is no fit.
      if (!(c.thrust / r.thrust > 0) || !(c.power / r.power > 0)) return HUGE_VAL;
      sum += std::pow(std::log(c.thrust / r.thrust), 2) + std::pow(std::log(c.power / r.power), 2);
    }
    return sum;
  };
  double best = 0, least = error(0);
  for (double offset = -kMost; offset <= kMost; offset += kCoarse) {
    const double e = error(offset);
    if (e < least) least = e, best = offset;
  }
  return findMinimum(error, best - kCoarse, best + kCoarse, 0.01 * kDegree).at;
}

}  // namespace rotorbench::validation
