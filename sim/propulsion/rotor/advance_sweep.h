// What a propeller does over the advance ratio at one rotor speed, as wind tunnels report it: T =
// CT rho n^2 D^4, P = CP rho n^3 D^5, J = V/(n D), eta = J CT/CP, n in turns per second.
//   McCormick, Aerodynamics, Aeronautics and Flight Mechanics, 2nd ed., ch. 6
#pragma once

#include <optional>
#include <vector>

#include "sim/propulsion/rotor/blade_element.h"

namespace rotorbench {

/// One advance ratio.
struct AdvancePoint {
  double advanceRatio = 0;       ///< J
  double thrustCoefficient = 0;  ///< CT
  double powerCoefficient = 0;   ///< CP
  double efficiency = 0;         ///< eta; 0 unless both thrust and power are positive
};

struct AdvanceSweep {
  std::vector<AdvancePoint> points;  ///< from rest to a little beyond zero thrust
  double figureOfMerit = 0;          ///< ideal over actual power at rest, CT^1.5 sqrt(2/pi)/CP
  std::optional<AdvancePoint> best;  ///< of the highest efficiency among the points
  std::optional<double> zeroThrust;  ///< J between the points where thrust changes sign
};

/// Coefficients of loads that are known, at speed omega in rad/s and an axial speed in m/s; all 0
/// where there is no speed or no air.
AdvancePoint coefficientsOf(const AxialLoad& load, double omega, double axialSpeed, double diameter,
                            double density);

/// Coefficients at speed omega, rad/s and above 0, and one axial speed, m/s.
AdvancePoint advancePoint(const BladeElementRotor& rotor, double omega, double axialSpeed,
                          const AirState& air);

/// Steps of J from rest until the thrust is negative, at most to J = 2. The step is above 0.
AdvanceSweep advanceSweep(const BladeElementRotor& rotor, double omega, const AirState& air,
                          double step = 0.05);

}  // namespace rotorbench
