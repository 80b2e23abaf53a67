// Motor bench and thrust stand: a drive with its throttle laid down over time, and beside the run
// in time the motor's characteristic curves (thesis 2014, figures 3.14-3.18) and the steady points
// over the throttle.
#pragma once

#include <vector>

#include "sim/document/drive_stand.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

struct ThrottleStep {
  double time = 0;      ///< s
  double throttle = 0;  ///< -1..1
  bool operator==(const ThrottleStep&) const = default;
};

struct MotorBench {
  DriveStand stand;
  std::vector<ThrottleStep> throttle{{0, 0}, {0.1, 1}};
  Interpolation interpolation = Interpolation::Hold;
  DriveRunSettings run;
  bool operator==(const MotorBench&) const = default;
};

template <>
struct Describe<ThrottleStep> {
  static void fields(schema::Builder<ThrottleStep>& b);
};
template <>
struct Describe<MotorBench> {
  static void fields(schema::Builder<MotorBench>& b);
};

}  // namespace rotorbench
