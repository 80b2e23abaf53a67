#include "sim/vehicle/multirotor_members.h"

namespace rotorbench {

template MultirotorConstants<4> buildMultirotor<4>(const VehicleParameters&,
                                                   const EnvironmentParameters&, bool);
template class Multirotor<4, RotorDrive::Motors>;
template class Multirotor<4, RotorDrive::PrescribedSpeeds>;

}  // namespace rotorbench
