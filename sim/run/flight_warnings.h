// What can be doubted of a flight before it runs.
#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/document/flight.h"

namespace rotorbench {

/// Step and poles, delays and rates, hover: warnings with paths below the flight, which has no
/// errors.
std::vector<Problem> flightWarnings(const Flight& flight);

}  // namespace rotorbench
