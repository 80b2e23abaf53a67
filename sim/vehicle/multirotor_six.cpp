#include "sim/vehicle/multirotor_members.h"

namespace rotorbench {

template MultirotorConstants<6> buildMultirotor<6>(const VehicleParameters&,
                                                   const EnvironmentParameters&, bool);
template class Multirotor<6, RotorDrive::Motors>;
template class Multirotor<6, RotorDrive::PrescribedSpeeds>;

}  // namespace rotorbench
