// Steady working points of a drive: at a throttle, at a thrust, at its best efficiency. All of them
// come from DriveTrain::steadyState(); this only looks for the throttle. SI units.
#pragma once

#include <optional>

#include "sim/propulsion/drive/drive_train.h"

namespace rotorbench {

/// The N-th of a supply that each of N equal motors has for itself: the same voltages at an N-th of
/// the current.
SupplyModel shareOf(const SupplyModel& supply, int motors);

struct DrivePoint {
  double throttle = 0;
  double speed = 0;   ///< rad/s
  double thrust = 0;  ///< N
  double torque = 0;  ///< N m on the shaft
  DriveInstant<double> electrical;
  DrivePowers powers{};
  bool currentLimited = false;
};

/// The steady state at a throttle, with the charge of the supply at the start and no polarisation.
DrivePoint drivePoint(const DriveTrain& train, double throttle);

/// The steady state that has this thrust in N, above 0; empty if full throttle has less.
std::optional<DrivePoint> pointWithThrust(const DriveTrain& train, double thrust);

/// Where a motor held at a voltage in V turns most of its electrical power into shaft power.
struct BestEfficiency {
  double current = 0;     ///< A
  double efficiency = 0;  ///< shaft power over electrical power
};
BestEfficiency bestEfficiency(const MotorConstants& motor, double voltage);

}  // namespace rotorbench
