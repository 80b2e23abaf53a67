// Whether a flight's vehicle can hover, said before it runs.
#pragma once

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/document/flight.h"

namespace rotorbench {

/// Warns, with paths below the flight, if motors, speed controllers and supply cannot hold the
/// vehicle in still air: where a controller is to fly it, and where it starts in a hover. `flight`
/// has no errors.
void warnOfHover(const Flight& flight, std::vector<Problem>& problems);

/// The vehicle with blade elements where it has a map of them: the same to 0.2 %, but ready at
/// once, for whoever only wants to look at it.
VehicleParameters withoutMaps(VehicleParameters vehicle);

}  // namespace rotorbench
