// What a multirotor run records: one list gives names, units, descriptions and values. SI units,
// inertial frame x forward, y left, z up, body axes alike.
#pragma once

#include "sim/vehicle/multirotor.h"

namespace rotorbench {

/// Calls visit(rotor, name, unit, description, value) for each quantity; rotor 0 is the vehicle,
/// others are numbered from 1. `forces` must belong to the state `y`. The air's quantities are
/// there where the air is not the same everywhere.
template <class Plant, class Visit>
void visitMultirotorOutputs(const AirConstants& air, const typename Plant::State& y,
                            const MultirotorForces<Plant::kRotors>& forces, Visit&& visit) {
  using L = typename Plant::Layout;
  constexpr bool kMotors = Plant::kDrive == RotorDrive::Motors;
  visit(0, "position.x", "m", "Position of the centre of mass, forward", y[L::kPosition]);
  visit(0, "position.y", "m", "Position of the centre of mass, left", y[L::kPosition + 1]);
  visit(0, "position.z", "m", "Height of the centre of mass", y[L::kPosition + 2]);
  visit(0, "velocity.x", "m/s", "Inertial velocity, forward", y[L::kVelocity]);
  visit(0, "velocity.y", "m/s", "Inertial velocity, left", y[L::kVelocity + 1]);
  visit(0, "velocity.z", "m/s", "Climb speed", y[L::kVelocity + 2]);
  visit(0, "acceleration.x", "m/s^2", "Inertial acceleration, forward", forces.acceleration[0]);
  visit(0, "acceleration.y", "m/s^2", "Inertial acceleration, left", forces.acceleration[1]);
  visit(0, "acceleration.z", "m/s^2", "Inertial acceleration, up", forces.acceleration[2]);
  visit(0, "attitude.roll", "rad", "Roll angle, positive to the right", forces.attitude[0]);
  visit(0, "attitude.pitch", "rad", "Pitch angle, positive nose down", forces.attitude[1]);
  visit(0, "attitude.yaw", "rad", "Yaw angle, positive to the left", forces.attitude[2]);
  visit(0, "attitude.w", "1", "Attitude quaternion, scalar part", y[L::kAttitude]);
  visit(0, "attitude.x", "1", "Attitude quaternion, x", y[L::kAttitude + 1]);
  visit(0, "attitude.y", "1", "Attitude quaternion, y", y[L::kAttitude + 2]);
  visit(0, "attitude.z", "1", "Attitude quaternion, z", y[L::kAttitude + 3]);
  visit(0, "rates.x", "rad/s", "Body rate about the forward axis", forces.rates[0]);
  visit(0, "rates.y", "rad/s", "Body rate about the left axis", forces.rates[1]);
  visit(0, "rates.z", "rad/s", "Body rate about the upward axis", forces.rates[2]);
  if (air.moving) {
    visit(0, "wind.x", "m/s", "Velocity of the air at the centre of mass, forward", forces.wind[0]);
    visit(0, "wind.y", "m/s", "Velocity of the air at the centre of mass, left", forces.wind[1]);
    visit(0, "wind.z", "m/s", "Velocity of the air at the centre of mass, up", forces.wind[2]);
  }
  if (air.standard)
    visit(0, "air.density", "kg/m^3", "Density of the air at the centre of mass", forces.density);
  if constexpr (kMotors) {
    visit(0, "supply.voltage", "V", "Supply voltage under load", forces.busVoltage);
    visit(0, "supply.current", "A", "Current drawn from the supply", forces.supplyCurrent);
    visit(0, "supply.power", "W", "Power drawn from the supply",
          forces.busVoltage * forces.supplyCurrent);
    visit(0, "supply.charge", "C", "Charge drawn from the supply", y[L::kCharge]);
    visit(0, "supply.energy", "J", "Energy drawn from the supply", y[L::kEnergy]);
    visit(0, "supply.stateOfCharge", "1", "State of charge of the battery; 1 for a fixed supply",
          forces.stateOfCharge);
  }
  for (int i = 0; i < Plant::kRotors; ++i) {
    const auto k = static_cast<std::size_t>(i);
    visit(i + 1, "speed", "rad/s", "Rotor speed", y[L::kSpeed + i]);
    visit(i + 1, "thrust", "N", "Thrust along the rotor axis", forces.thrust[k]);
    visit(i + 1, "torque", "N*m", "Aerodynamic torque against the rotation", forces.torque[k]);
    if constexpr (kMotors) {
      const double current = y[L::kCurrent + i];
      visit(i + 1, "duty", "1", "Share of the supply's voltage put on the motor", forces.duty[k]);
      visit(i + 1, "current", "A", "Motor current", current);
      visit(i + 1, "voltage", "V", "Motor voltage", forces.voltage[k]);
      visit(i + 1, "power", "W", "Electrical power of the motor", forces.voltage[k] * current);
    }
  }
}

}  // namespace rotorbench
