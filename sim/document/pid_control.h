// A flight under controller 1: its gains, and the set-points over time.
#pragma once

#include <vector>

#include "sim/control/pid_flight.h"
#include "sim/core/schema.h"
#include "sim/document/prescribed_inputs.h"

namespace rotorbench {

/// Set-points from one instant on.
struct SetPointRow {
  double time = 0;                      ///< s
  double height = 1;                    ///< m
  double roll = 0, pitch = 0, yaw = 0;  ///< rad
  bool operator==(const SetPointRow&) const = default;
};

struct PidControl {
  PidFlightParameters controller;
  std::vector<SetPointRow> setPoints{1};
  Interpolation interpolation = Interpolation::Hold;
  bool operator==(const PidControl&) const = default;
};

template <>
struct Describe<SetPointRow> {
  static void fields(schema::Builder<SetPointRow>& b);
};
template <>
struct Describe<PidControl> {
  static void fields(schema::Builder<PidControl>& b);
};

}  // namespace rotorbench
