// Set-points over time, as a person enters them.
#pragma once

#include "sim/core/schema.h"

namespace rotorbench {

/// Set-points from one instant on.
struct SetPointRow {
  double time = 0;                      ///< s
  double height = 1;                    ///< m
  double roll = 0, pitch = 0, yaw = 0;  ///< rad
  bool operator==(const SetPointRow&) const = default;
};

/// Set-points taken from the timeline, one by one: while its `…ByHand` is on, a set-point is the
/// value beside it.
struct HandSetPoints {
  bool heightByHand = false, rollByHand = false, pitchByHand = false, yawByHand = false;
  double height = 1;                    ///< m
  double roll = 0, pitch = 0, yaw = 0;  ///< rad
  bool operator==(const HandSetPoints&) const = default;
};

template <>
struct Describe<HandSetPoints> {
  static void fields(schema::Builder<HandSetPoints>& b);
};

template <>
struct Describe<SetPointRow> {
  static void fields(schema::Builder<SetPointRow>& b);
};

}  // namespace rotorbench
