// Motor speed control: a drive whose throttle a speed controller sets, answering set-point steps.
// Experiment 5 of the 2014 thesis (figures 4.7-4.9): angular speed, current and control signal.
#pragma once

#include <vector>

#include "sim/control/motor_speed.h"
#include "sim/document/drive_stand.h"

namespace rotorbench {

struct SpeedStep {
  double time = 0;   ///< s
  double speed = 0;  ///< rad/s
  bool operator==(const SpeedStep&) const = default;
};

struct MotorSpeedRun {
  DriveStand stand;
  MotorSpeedParameters controller;
  std::vector<SpeedStep> setPoints{{0, 0}, {0.1, 500}, {1, 300}};
  bool compareUnsaturated = false;  ///< a second run without limits of voltage and current
  DriveRunSettings run;
  bool operator==(const MotorSpeedRun&) const = default;
};

template <>
struct Describe<SpeedStep> {
  static void fields(schema::Builder<SpeedStep>& b);
};
template <>
struct Describe<MotorSpeedRun> {
  static void fields(schema::Builder<MotorSpeedRun>& b);
};

}  // namespace rotorbench
