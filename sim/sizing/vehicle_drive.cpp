#include "sim/sizing/vehicle_drive.h"

namespace rotorbench {

SupplyModel supplyOf(const VehicleParameters& vehicle) {
  return vehicle.supply;
}

// A vehicle's motor resistance holds the speed controller's; only the motor limits the current.
EscParameters escOf(const RotorParameters& rotor) {
  return {.resistance = 0, .maxCurrent = rotor.motor.maxCurrent};
}

void setDrive(VehicleParameters& vehicle, RotorParameters& rotor, const SupplyModel& supply,
              const EscParameters& esc, const MotorParameters& motor) {
  rotor.motor = motor;
  rotor.motor.resistance += esc.resistance;
  rotor.motor.maxCurrent = std::min(motor.maxCurrent, esc.maxCurrent);
  const Supply cells(supply);
  vehicle.supply = {cells.openCircuit(cells.charge), cells.resistance + cells.polarisation};
}

}  // namespace rotorbench
