#include "sim/sizing/vehicle_drive.h"

namespace rotorbench {

SupplyModel supplyOf(const VehicleParameters& vehicle) {
  return vehicle.supply;
}

EscParameters escOf(const RotorParameters& rotor) {
  return rotor.esc;
}

void setDrive(VehicleParameters& vehicle, RotorParameters& rotor, const SupplyModel& supply,
              const EscParameters& esc, const MotorParameters& motor) {
  rotor.motor = motor;
  rotor.esc = esc;
  vehicle.supply = supply;
}

}  // namespace rotorbench
