#include "sim/vehicle/multirotor_members.h"

namespace rotorbench {

template MultirotorConstants<8> buildMultirotor<8>(const VehicleParameters&,
                                                   const EnvironmentParameters&, bool);
template class Multirotor<8, RotorDrive::Motors>;
template class Multirotor<8, RotorDrive::PrescribedSpeeds>;

}  // namespace rotorbench
