// The plants of a flight, one source for each number of rotors: a solver in all its methods takes a
// while to compile.
#pragma once

#include <memory>

#include "sim/run/plant_handle.h"

namespace rotorbench {

/// The plant of a vehicle with N rotors. Throws InputError with paths below the vehicle.
template <int N>
std::unique_ptr<PlantHandle> makeMultirotor(const Flight& flight, RotorDrive drive);

}  // namespace rotorbench
