// Twist offset and drag of a blade-element propeller from measured coefficients, static or in
// flight. SI units.
//   T = CT rho n^2 D^4, P = CP rho n^3 D^5, J = V/(n D); rows hold CT and CP, or thrust and torque,
//     or one of each.
// The drag factor multiplies the profile drag of every analytic section of the blade
// (analytic_section.h). Both coefficients count in parts of their mean size.
#pragma once

#include <string>
#include <vector>

#include "sim/fitting/least_squares.h"
#include "sim/logs/measured_table.h"
#include "sim/propulsion/rotor/blade_element.h"

namespace rotorbench {

struct PropellerFitSetup {
  PropellerGeometry start;
  BladeElementSettings settings;
  AirState air;
  double speed = 0;  ///< rad/s where the table has no speed
  bool fitTwistOffset = true;
  bool fitDrag = false;
};

std::vector<std::string> missingForPropellerFit(const MeasuredTable& table,
                                                const PropellerFitSetup& setup);
/// Throws InputError with those sentences.
FitProblem propellerFitProblem(const MeasuredTable& table, const PropellerFitSetup& setup);
/// `start` with the fitted values that were determined.
PropellerGeometry propellerFrom(const FitResult& result, const PropellerFitSetup& setup);

}  // namespace rotorbench
