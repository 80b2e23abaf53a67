// Puts a flight together round a controller: plant, sensors, estimator, timeline, controller, speed
// controllers. The factory of flight_run.cpp uses it for every alternative of Flight::control, and
// a program may use it with a controller of its own.
#pragma once

#include <functional>

#include "sim/document/controlled_inputs.h"
#include "sim/run/builders.h"
#include "sim/run/controller_factory.h"
#include "sim/run/flight_simulation.h"

namespace rotorbench {

using ControllerFactory = std::function<MadeController(const ControlModel&)>;

/// The parts of a flight whose controller `factory` makes for the vehicle as planned; set-points
/// and motor speed controllers are those of `inputs`. Throws InputError with paths from the
/// context's place on.
FlightParts controlledFlight(const Flight& flight, const ControlledInputs& inputs,
                             const BuildContext& context, const ControllerFactory& factory);

}  // namespace rotorbench
