// A flight flown by a controller: which, the motor speed controllers below it, and the set-points
// over time.
#pragma once

#include <variant>
#include <vector>

#include "sim/control/motor_speed_parameters.h"
#include "sim/control/pid_flight_parameters.h"
#include "sim/control/state_feedback_parameters.h"
#include "sim/core/schema.h"
#include "sim/document/prescribed_inputs.h"
#include "sim/document/set_points.h"

namespace rotorbench {

/// Every controller that can be chosen, by its settings. Each has its line in the factory,
/// sim/run/controller_factory.cpp.
using ControllerParameters =
    std::variant<PidFlightParameters, StateFeedbackParameters, LqrParameters>;

struct ControlledInputs {
  ControllerParameters controller;
  MotorSpeedParameters motors;
  std::vector<SetPointRow> setPoints{1};
  Interpolation interpolation = Interpolation::Hold;
  HandSetPoints byHand;
  bool operator==(const ControlledInputs&) const = default;
};

template <>
struct Describe<ControlledInputs> {
  static void fields(schema::Builder<ControlledInputs>& b);
};

}  // namespace rotorbench
