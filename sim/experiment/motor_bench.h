// Motor bench and thrust stand: a drive with its throttle laid down over time, and beside the run
// in time the motor's characteristic curves (thesis 2014, figures 3.14-3.18) and the steady points
// over the throttle.
#pragma once

#include <memory>
#include <vector>

#include "sim/experiment/drive_stand.h"
#include "sim/experiment/prescribed_inputs.h"
#include "sim/experiment/simulation.h"

namespace rotorbench {

struct OutputSettings;

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

/// Throws InputError where the solver does not fit.
std::unique_ptr<Simulation> buildMotorBench(const MotorBench& bench, const OutputSettings& outputs);

template <>
struct Describe<ThrottleStep> {
  static void fields(schema::Builder<ThrottleStep>& b);
};
template <>
struct Describe<MotorBench> {
  static void fields(schema::Builder<MotorBench>& b);
};

}  // namespace rotorbench
