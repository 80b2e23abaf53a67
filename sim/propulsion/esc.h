// An electronic speed controller as an averaged converter: it puts the share `duty` of the supply's voltage on the
// motor and takes the share `duty` of the motor's current from the supply. SI units.
#pragma once

#include "sim/core/schema.h"

namespace rotorbench {

struct EscParameters {
  double resistance = 0.005;   ///< Ohm, of the switches in the motor's path
  double responseTime = 0.01;  ///< s, first-order lag from throttle to duty; 0: none
  double deadTime = 0;         ///< s, from a throttle command until it begins to act
  double maxCurrent = 30;      ///< A, kept by limiting the voltage
  bool reverse = false;        ///< duty in -1..1 instead of 0..1
  bool activeBraking = true;   ///< else no current flows back
  bool operator==(const EscParameters&) const = default;
};

template <>
struct Describe<EscParameters> {
  static void fields(schema::Builder<EscParameters>& b);
};

}  // namespace rotorbench
