#include "sim/sizing/vehicle_drive.h"

namespace rotorbench {

SupplyModel supplyOf(const VehicleParameters& vehicle) {
  return vehicle.supply;
}

EscParameters escOf(const RotorParameters& rotor) {
  return {.resistance = rotor.esc.resistance, .maxCurrent = rotor.esc.maxCurrent};
}

void setDrive(VehicleParameters& vehicle, RotorParameters& rotor, const SupplyModel& supply,
              const EscParameters& esc, const MotorParameters& motor) {
  rotor.motor = motor;
  rotor.esc = {.resistance = esc.resistance, .maxCurrent = esc.maxCurrent};
  vehicle.supply = supply;
}

}  // namespace rotorbench
