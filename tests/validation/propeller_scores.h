// How far a computed propeller is from its measured coefficients, in percent and points, and the
// median and 90 % quantile of that over many propellers.
//   static:         mean of |model/measured - 1| over the speeds
//   in flight:      mean of |model - measured| over all points, over the measured static coefficient at that speed
//   peak efficiency: points between the highest measured efficiency of a run and the highest of the model
//   zero thrust:    advance ratio at which CT passes 0, model/measured - 1, runs that get there
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/propulsion/blade_element.h"
#include "sim/propulsion/bracketed_root.h"
#include "tests/validation/uiuc_data.h"

namespace uiuc {

/// Air of the tunnel; the coefficients depend on it through the Reynolds number only.
inline constexpr rotorbench::AirState kTunnelAir{1.18, 1.83e-5};

struct Coefficients {
  double thrust, power;
};

inline Coefficients computed(const rotorbench::BladeElementRotor& rotor, double rpm,
                             double advance) {
  const double n = rpm / 60, d = 2 * rotor.radius(), turn = 2 * std::numbers::pi;
  const auto load = rotor.axial(turn * n, advance * n * d, kTunnelAir);
  const double scale = kTunnelAir.density * n * n * std::pow(d, 4);
  return {load.thrust / scale, load.torque * turn / (scale * d)};
}

/// Errors of one set; in flight and the peaks are means over the runs' points or runs.
struct Score {
  double thrust = 0, power = 0;
  std::optional<double> flightThrust, flightPower, peak, zeroThrust;
};

inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

inline std::optional<double> meanIfAny(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

/// Linear between order statistics.
inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  const std::size_t k = std::min(i + 1, values.size() - 1);
  return values[i] + (place - static_cast<double>(i)) * (values[k] - values[i]);
}

/// Static coefficients at a speed, linear between the measured ones, the ends beyond them.
inline Coefficients stillAt(const Set& set, double rpm) {
  std::vector<Row> rows = set.still;
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.rpm < b.rpm; });
  if (rpm <= rows.front().rpm) return {rows.front().thrust, rows.front().power};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rpm > rows[i].rpm) continue;
    const Row &a = rows[i - 1], &b = rows[i];
    const double t = (rpm - a.rpm) / (b.rpm - a.rpm);
    return {a.thrust + t * (b.thrust - a.thrust), a.power + t * (b.power - a.power)};
  }
  return {rows.back().thrust, rows.back().power};
}

/// Advance ratio where CT of a run passes 0 from above, if it does.
inline std::optional<double> zeroThrustAdvance(const std::vector<Row>& run) {
  for (std::size_t i = 1; i < run.size(); ++i) {
    const Row &a = run[i - 1], &b = run[i];
    if (a.thrust > 0 && b.thrust <= 0) {
      return a.advance + (b.advance - a.advance) * a.thrust / (a.thrust - b.thrust);
    }
  }
  return std::nullopt;
}

inline double peakEfficiency(const std::vector<Row>& run) {
  double peak = 0;
  for (const Row& r : run) {
    if (r.power > 0) peak = std::max(peak, r.advance * r.thrust / r.power);
  }
  return peak;
}

inline double zeroThrustAdvance(const rotorbench::BladeElementRotor& rotor, double rpm) {
  constexpr double kMost = 3;  // no propeller here has a pitch of three diameters
  const auto thrust = [&](double advance) { return computed(rotor, rpm, advance).thrust; };
  return rotorbench::bracketedRoot(thrust, 0, thrust(0), kMost, thrust(kMost), 1e-6);
}

inline Score stillScore(const Set& set, const rotorbench::BladeElementRotor& rotor) {
  std::vector<double> thrust, power;
  for (const Row& r : set.still) {
    const Coefficients c = computed(rotor, r.rpm, 0);
    thrust.push_back(std::abs(c.thrust / r.thrust - 1));
    power.push_back(std::abs(c.power / r.power - 1));
  }
  return {100 * mean(thrust), 100 * mean(power), {}, {}, {}, {}};
}

inline Score score(const Set& set, const rotorbench::BladeElementRotor& rotor) {
  Score s = stillScore(set, rotor);
  std::vector<double> thrust, power, peak, zero;
  for (const auto& run : set.flights) {
    std::vector<Row> model = run;
    for (Row& r : model) {
      const Coefficients c = computed(rotor, r.rpm, r.advance), still = stillAt(set, r.rpm);
      thrust.push_back(100 * std::abs(c.thrust - r.thrust) / still.thrust);
      power.push_back(100 * std::abs(c.power - r.power) / still.power);
      r.thrust = c.thrust, r.power = c.power;
    }
    if (run.empty()) continue;
    peak.push_back(100 * std::abs(peakEfficiency(model) - peakEfficiency(run)));
    if (const auto measured = zeroThrustAdvance(run)) {
      zero.push_back(100 * std::abs(zeroThrustAdvance(rotor, run.front().rpm) / *measured - 1));
    }
  }
  s.flightThrust = meanIfAny(thrust), s.flightPower = meanIfAny(power);
  s.peak = meanIfAny(peak), s.zeroThrust = meanIfAny(zero);
  return s;
}

}  // namespace uiuc
