// Supply and speed controllers of a vehicle as this room needs them.
#pragma once

#include "sim/propulsion/battery.h"
#include "sim/propulsion/esc.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

SupplyModel supplyOf(const VehicleParameters& vehicle);
EscParameters escOf(const RotorParameters& rotor);

/// Puts the electrical side of a drive into a rotor and its vehicle.
void setDrive(VehicleParameters& vehicle, RotorParameters& rotor, const SupplyModel& supply,
              const EscParameters& esc, const MotorParameters& motor);

}  // namespace rotorbench
