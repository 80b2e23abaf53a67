// What the throttle of a log says about the duty of its speed controller. A motor in its steady
// state on one load has
//   d V = R i(w) + K w,   i rising with w,
// so that the voltage d V it is given rises with its speed and with nothing else: by at least the
// same part, and by at most the square of it, where the load goes with the square of the speed and
// the resistance takes all of the voltage. Rows of one speed and very different throttle can have
// no duty that is the throttle.
#pragma once

#include <string>
#include <vector>

#include "sim/fitting/motor_fit.h"

namespace rotorbench {

/// A steady state of a motor that turns: all three above 0, speed in rad/s, voltage of the supply
/// in V.
struct DutyRow {
  double throttle = 0, speed = 0, voltage = 0;
};

/// The throttle where it can be the duty; else 1 at full throttle, if the log gets there; else
/// unknown.
DutyFrom dutySourceOf(const std::vector<DutyRow>& rows);

/// One sentence where the throttle of the log cannot be the duty, with what is taken instead; else
/// empty.
std::string dutySourceText(const std::vector<DutyRow>& rows);

}  // namespace rotorbench
