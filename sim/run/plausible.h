// Numbers beyond every vehicle: a solver whose step is too long for the equations can leave finite
// ones behind, and a flight of those is none. The bounds lie far outside what flies. SI units.
#pragma once

#include <cmath>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

/// The largest magnitude of a component of the state that is taken for a flight's.
template <class Layout>
constexpr double mostPlausible(int component) {
  if (component < Layout::kCurrent) return 1e5;   // rad/s
  if (component < Layout::kDuty) return 1e5;      // A
  if (component < Layout::kAttitude) return 1.5;  // of a full one
  if (component < Layout::kMomentum) return 2;    // of a unit quaternion
  if (component < Layout::kVelocity) return 1e9;  // kg m^2/s
  if (component < Layout::kPosition) return 1e4;  // m/s
  return component < Layout::kCharge ? 1e8 : HUGE_VAL;
}

/// Why the state at `time`, s, is no flight's, if it is none.
template <class Plant>
std::optional<RunFailure> implausible(double time, const typename Plant::State& y) {
  using Layout = typename Plant::Layout;
  for (int i = 0; i < Layout::kStates; ++i) {
    const double most = mostPlausible<Layout>(i);
    if (std::abs(y[i]) <= most) continue;
    const std::string name = Plant::componentName(i);
    return RunFailure{time, name,
                      "The state " + name + " is " + shortNumber(y[i], 3) + " at t = " +
                          shortNumber(time, 6) + " s, beyond the " + shortNumber(most, 3) +
                          " of any vehicle. A smaller step or an embedded method may help."};
  }
  return {};
}

}  // namespace rotorbench
