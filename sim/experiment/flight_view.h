// How a flying multirotor appears in a recording: the channels, declared where they are computed. Inertial frame
// x forward, y left, z up; body axes alike; SI. Quantities of a row belong to its instant, commands are those that
// hold from it on.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "sim/core/channel.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

template <class Plant>
class FlightView {
 public:
  using State = typename Plant::State;
  using Layout = typename Plant::Layout;
  using Forces = MultirotorForces<Plant::kRotors>;
  static constexpr bool kMotors = Plant::kDrive == RotorDrive::Motors;

  /// Without the time.
  static std::vector<Channel> channels() {
    std::vector<Channel> all{
        {"position.x", "m", "Centre of mass, inertial x (forward)"},
        {"position.y", "m", "Centre of mass, inertial y (left)"},
        {"position.z", "m", "Centre of mass, inertial z (up)"},
        {"velocity.x", "m/s", "Velocity of the centre of mass, inertial x"},
        {"velocity.y", "m/s", "Velocity of the centre of mass, inertial y"},
        {"velocity.z", "m/s", "Velocity of the centre of mass, inertial z"},
        {"attitude.w", "1", "Quaternion, body to inertial, scalar part"},
        {"attitude.x", "1", "Quaternion, body to inertial, x"},
        {"attitude.y", "1", "Quaternion, body to inertial, y"},
        {"attitude.z", "1", "Quaternion, body to inertial, z"},
        {"euler.roll", "rad", "Roll of the Z-Y-X angles, positive to the right side down"},
        {"euler.pitch", "rad", "Pitch of the Z-Y-X angles, positive nose down"},
        {"euler.yaw", "rad", "Yaw of the Z-Y-X angles, positive to the left"},
        {"rates.x", "rad/s", "Body rate about x"},
        {"rates.y", "rad/s", "Body rate about y"},
        {"rates.z", "rad/s", "Body rate about z"}};
    for (int i = 1; i <= Plant::kRotors; ++i) addRotor("rotor" + std::to_string(i) + ".", all);
    if constexpr (kMotors) {
      all.push_back({"supply.voltage", "V", "Voltage of the supply under load"});
      all.push_back({"supply.current", "A", "Current drawn from the supply"});
      all.push_back({"supply.power", "W", "Power drawn from the supply"});
    }
    return all;
  }

  static constexpr std::size_t kCount =
      16 + static_cast<std::size_t>(Plant::kRotors) * (kMotors ? 6 : 3) + (kMotors ? 3 : 0);

  static void row(const Plant& plant, const State& y, const Forces& f, double* out) {
    using L = Layout;
    for (int k = 0; k < 3; ++k) *out++ = y[L::kPosition + k];
    for (int k = 0; k < 3; ++k) *out++ = y[L::kVelocity + k];
    const Eigen::Vector4d q = y.template segment<4>(L::kAttitude);
    for (int k = 0; k < 4; ++k) *out++ = q[k];
    const Eigen::Vector3d euler = eulerAngles(q);
    for (int k = 0; k < 3; ++k) *out++ = euler[k];
    for (int k = 0; k < 3; ++k) *out++ = f.rates[k];
    for (int i = 0; i < Plant::kRotors; ++i) {
      const auto n = static_cast<std::size_t>(i);
      *out++ = y[L::kSpeed + i];
      *out++ = f.thrust[n];
      *out++ = f.torque[n];
      if constexpr (kMotors) {
        *out++ = y[L::kCurrent + i];
        *out++ = f.voltage[n];
        *out++ = plant.command()[i];
      }
    }
    if constexpr (kMotors) {
      *out++ = f.busVoltage;
      *out++ = f.supplyCurrent;
      *out++ = f.busVoltage * f.supplyCurrent;
    }
  }

 private:
  static void addRotor(const std::string& prefix, std::vector<Channel>& all) {
    all.push_back({prefix + "speed", "rad/s", "Speed of the rotor in its own sense of rotation"});
    all.push_back({prefix + "thrust", "N", "Thrust along the rotor axis"});
    all.push_back({prefix + "torque", "N*m", "Aerodynamic torque against the rotation"});
    if constexpr (kMotors) {
      all.push_back({prefix + "current", "A", "Current of the motor"});
      all.push_back({prefix + "voltage", "V", "Voltage at the motor"});
      all.push_back({prefix + "duty", "1", "Duty cycle of the speed controller, 0 to 1"});
    }
  }
};

}  // namespace rotorbench
