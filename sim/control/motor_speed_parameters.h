// Settings of a motor speed controller (sim/control/motor_speed.h).
#pragma once

#include "sim/control/pid_parameters.h"

namespace rotorbench {

struct MotorSpeedParameters {
  double rate = 1000;  ///< Hz
  PidParameters<PidUse::RotorSpeed> pid{
      .kp = 60,
      .ki = 300,
      .setPointWeight = 1,
      .filterTime = 0.005,
      .trackingTime = 0.2,  // kp/ki: leaves what P asks in vain alone
      .limit = 1e5};
  bool feedForward = true;
  bool operator==(const MotorSpeedParameters&) const = default;
};

template <>
struct Describe<MotorSpeedParameters> {
  static void fields(schema::Builder<MotorSpeedParameters>& b);
};

}  // namespace rotorbench
