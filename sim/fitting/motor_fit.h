// Motor constants from the log of a stand by the equations of the averaged machine in its steady
// state. SI units.
//   winding    d V = R i + K w,   i = I/d                        (d: duty, V and I: supply, R with
//              speed controller)
//   shaft      K i = friction(w) + Q                             friction from I0 and its viscous
//              share (motor.h)
// Where the duty of a row is known, speed and supply current are predicted from it; where it is
// not, the supply current from the measured speed by the power V I = R i^2 + K w i, which needs no
// duty. Rows that accelerate are not steady: logs with steps should be cut to their plateaus. Rows
// in which a current limit holds the motor back do not follow these equations, for the duty is less
// than the throttle; they can be left out.
#pragma once

#include <string>
#include <vector>

#include "sim/fitting/least_squares.h"
#include "sim/logs/measured_table.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

/// Where the torque of the load comes from.
enum class ShaftTorque {
  Measured,    ///< the torque column
  FromThrust,  ///< thrust times torquePerThrust
  Propeller,   ///< k_m w^2; k_m can be fitted too
  None,        ///< nothing on the shaft
};

/// What the throttle says about the duty.
enum class DutyFrom {
  Automatic,  ///< Throttle, unless the log shows that it cannot be (duty_source.h)
  Throttle,   ///< duty = throttle
  /// 1 at full throttle, else unknown: for speed controllers with a curve of their own
  FullThrottle,
  Unknown,
};

/// Throttle from which the speed controller is taken to be fully on.
inline constexpr double kFullThrottle = 0.999;

struct MotorFitSetup {
  MotorParameters start;
  double escResistance = 0;  ///< Ohm, part of R that is not the motor's
  ShaftTorque torque = ShaftTorque::Propeller;
  double torqueCoefficient = 1e-7;        ///< k_m, N m s^2: start, or value where it is not fitted
  bool torqueCoefficientIsGuess = false;  ///< nobody gave k_m
  double torquePerThrust = 0;             ///< m, for FromThrust
  DutyFrom duty = DutyFrom::Throttle;
  bool fitSpeedConstant = true, fitResistance = true, fitNoLoadCurrent = true;
  bool fitViscousShare = false;
  bool fitTorqueCoefficient = true;  ///< for ShaftTorque::Propeller
  double currentLimit = 0;           ///< A, of the motor current; 0: no rows are left out for it
  double nearLimit = 0.9;            ///< part of the limit from which a row is left out
};

/// How many rows of a turning motor the fit uses, and how many the current limit took away.
struct MotorFitRows {
  std::size_t used = 0, limited = 0;
};

/// A row is at the limit by its motor current, where that was measured; else by the supply current
/// over the duty, or over 1 where the duty is not known, which is the least the motor current can
/// be. Beyond the limit that quotient falls, so that then all rows of as much throttle or more
/// count as limited. Precondition: nothing is missing.
MotorFitRows motorFitRows(const MeasuredTable& table, const MotorFitSetup& asked);

/// One sentence where the duty is decided automatically and the throttle cannot be it; else empty.
std::string motorDutyText(const MeasuredTable& table, const MotorFitSetup& asked);

/// What the table lacks for this fit, one sentence each; empty if it can be done.
std::vector<std::string> missingForMotorFit(const MeasuredTable& table, const MotorFitSetup& asked);

/// Throws InputError with those sentences.
FitProblem motorFitProblem(const MeasuredTable& table, const MotorFitSetup& asked);

struct FittedMotor {
  MotorParameters motor;         ///< `start` with the fitted values that were determined
  double torqueCoefficient = 0;  ///< N m s^2
};
FittedMotor motorFrom(const FitResult& result, const MotorFitSetup& setup);

}  // namespace rotorbench
