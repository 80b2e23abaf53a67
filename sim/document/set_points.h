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

template <>
struct Describe<SetPointRow> {
  static void fields(schema::Builder<SetPointRow>& b);
};

}  // namespace rotorbench
