#include "sim/sizing/drive_point.h"

#include <algorithm>

#include "sim/numerics/scalar_search.h"

namespace rotorbench {

namespace {

constexpr double kThrottleTolerance = 1e-12;

}  // namespace

SupplyModel shareOf(const SupplyModel& supply, int motors) {
  SupplyModel share = supply;
  const double n = motors;
  if (auto* fixed = std::get_if<SupplyParameters>(&share)) {
    fixed->internalResistance *= n;
  } else {
    auto& battery = std::get<BatteryParameters>(share);
    battery.resistance *= n;
    battery.polarisation *= n;
    battery.capacity /= n;
  }
  return share;
}

DrivePoint drivePoint(const DriveTrain& train, double throttle) {
  const DriveTrain::State y = train.steadyState(throttle, train.supply().charge, 0);
  DrivePoint p;
  p.throttle = throttle;
  p.speed = y[DriveTrain::kSpeed];
  p.thrust = train.load().thrustAt(p.speed);
  p.torque = train.load().torque(p.speed);
  p.electrical = train.instant(y);
  p.powers = train.powers(y);
  p.currentLimited = y[DriveTrain::kCurrent] >= train.maxCurrent() * (1 - 1e-12);
  return p;
}

std::optional<DrivePoint> pointWithThrust(const DriveTrain& train, double thrust) {
  const auto surplus = [&](double throttle) {
    const auto y = train.steadyState(throttle, train.supply().charge, 0);
    return train.load().thrustAt(y[DriveTrain::kSpeed]) - thrust;
  };
  const double most = surplus(1);
  if (!(most >= 0)) return std::nullopt;
  return drivePoint(train, findRoot(surplus, 0, -thrust, 1, most, kThrottleTolerance));
}

BestEfficiency bestEfficiency(const MotorConstants& motor, double voltage) {
  const auto efficiency = [&](double current) {
    const double w = (voltage - motor.resistance * current) / motor.torqueConstant;
    const double shaft = (motor.torqueConstant * current - motor.friction(w)) * w;
    return shaft / (voltage * current);
  };
  // It has one maximum between no current and stall.
  const double stall = voltage / motor.resistance;
  const Extremum best = findMaximum(efficiency, 0, stall, 1e-7 * stall);
  return {best.at, std::max(0.0, best.value)};
}

}  // namespace rotorbench
