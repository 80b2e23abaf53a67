// A flight: a vehicle in its surroundings, flown by a controller or by inputs laid down in advance.
#pragma once

#include <variant>
#include <vector>

#include "sim/core/box.h"
#include "sim/core/schema.h"
#include "sim/document/changes.h"
#include "sim/document/prescribed_inputs.h"
#include "sim/environment/environment.h"
#include "sim/ode/solver_settings.h"
#include "sim/sensing/ideal_sensors.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

struct ControlledInputs;
extern template class Box<ControlledInputs>;

struct Flight {
  VehicleParameters vehicle;
  std::variant<Box<ControlledInputs>, SpeedInputs, VoltageInputs> control;
  SensorModel sensors;
  EnvironmentParameters environment;
  FlightStart start;
  ode::SolverSettings solver{.method = ode::Method::ExponentialRk4, .step = 1e-3};
  double tick = 1e-3;    ///< s, period of the fastest task
  double duration = 30;  ///< s
  bool endsAtGround = false;
  std::vector<Change> changes;  ///< during the flight, in the order of their times
  bool operator==(const Flight&) const = default;
};

template <>
struct Describe<Flight> {
  static void fields(schema::Builder<Flight>& b);
};

}  // namespace rotorbench
