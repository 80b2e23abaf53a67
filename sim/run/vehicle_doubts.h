// What can be doubted of a vehicle by itself: for the problems of an experiment that flies it and
// for its performance sheet.
#pragma once

#include <vector>

#include "sim/core/error.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

/// Warnings with paths below the vehicle, which has no errors: air resistance that is not
/// described.
std::vector<Problem> vehicleDoubts(const VehicleParameters& vehicle);

/// Shaft power of an ideal rotor over that of this one, at rest in the air: above 1 no rotor can
/// be. Thrust in N, shaft power in W, radius in m, air density in kg/m^3; 0 where there is none.
double figureOfMeritAt(double thrust, double shaftPower, double radius, double density);

}  // namespace rotorbench
