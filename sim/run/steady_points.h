// Steady points of a drive over its throttle, solved directly and not waited for: what a thrust
// stand reads once all has settled. Shared by the motor bench and the thrust stand. SI units.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/core/channel.h"
#include "sim/core/recording.h"
#include "sim/propulsion/drive/drive_train.h"

namespace rotorbench {

/// What is read at a steady point; the order is that of steadyChannels().
struct SteadyPoint {
  double throttle, speed, thrust, torque, supplyVoltage, supplyCurrent, motorCurrent,
      electricalPower, shaftPower, efficiency, thrustPerPower;
};

inline constexpr std::size_t kSteadyValues = 11;

/// Names begin with `prefix` and a dot.
std::vector<Channel> steadyChannels(const std::string& prefix);

/// What is read in state y of a drive, steady or not, its throttle being `throttle`.
SteadyPoint readPoint(const DriveTrain& train, double throttle, const DriveTrain::State& y);
/// Solved for a throttle, with the battery at a charge (0..1) and a polarised voltage in V.
SteadyPoint steadyPoint(const DriveTrain& train, double throttle, double charge,
                        double polarisation);
std::array<double, kSteadyValues> rowOf(const SteadyPoint& point);

/// Appends the steady points at equal steps of throttle from 0 to 1, with the battery as full as it
/// is at first.
void recordSteadyPoints(const DriveTrain& train, int points, Recording& recording);

}  // namespace rotorbench
