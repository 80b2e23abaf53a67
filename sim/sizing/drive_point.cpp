#include "sim/sizing/drive_point.h"

#include <algorithm>
#include <cmath>

#include "sim/numerics/bracketed_root.h"

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
  return drivePoint(train, bracketedRoot(surplus, 0, -thrust, 1, most, kThrottleTolerance));
}

BestEfficiency bestEfficiency(const MotorConstants& motor, double voltage) {
  const auto efficiency = [&](double current) {
    const double w = (voltage - motor.resistance * current) / motor.torqueConstant;
    const double shaft = (motor.torqueConstant * current - motor.friction(w)) * w;
    return shaft / (voltage * current);
  };
  // Efficiency has one maximum between no current and stall: golden sections.
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = 0, high = voltage / motor.resistance;
  for (int k = 0; k < 120; ++k) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (efficiency(a) < efficiency(b) ? low : high) = efficiency(a) < efficiency(b) ? a : b;
  }
  const double best = 0.5 * (low + high);
  return {best, std::max(0.0, efficiency(best))};
}

}  // namespace rotorbench
