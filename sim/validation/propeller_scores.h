// How far a computed propeller is from its measured coefficients, in percent and points:
//   static:          mean of |model/measured - 1| over the speeds
//   in flight:       mean of |model - measured| over all points, over the measured static
//     coefficient at that speed
//   peak efficiency: points between the highest measured efficiency of a run and the highest of the
//     model
//   zero thrust:     advance ratio at which CT passes 0, |model/measured - 1|, runs that get there
#pragma once

#include <optional>

#include "sim/propulsion/rotor/blade_element.h"
#include "sim/validation/uiuc_data.h"

namespace rotorbench::validation {

/// Air of the tunnel; the coefficients depend on it through the Reynolds number only.
inline constexpr AirState kTunnelAir{1.18, 1.83e-5};

struct Coefficients {
  double thrust = 0, power = 0;  ///< CT, CP
};

/// At speed omega, rad/s, above 0.
Coefficients coefficients(const BladeElementRotor& rotor, double omega, double advance,
                          const AirState& air = kTunnelAir);

/// Errors of one set, in percent (peak: points); in flight and the peaks are means over the runs'
/// points or runs.
struct PropellerScore {
  double thrust = 0, power = 0;
  std::optional<double> flightThrust, flightPower, peak, zeroThrust;
};

PropellerScore scoreAtRest(const PropellerSet& set, const BladeElementRotor& rotor);
PropellerScore scoreOf(const PropellerSet& set, const BladeElementRotor& rotor);

/// The twist offset, rad, within +-12 degrees, that fits the static coefficients best: least
/// squares of ln(model/measured) of CT and of CP, alike, over the speeds.
double fittedTwistOffset(const PropellerSet& set);

}  // namespace rotorbench::validation
