#include "sim/run/multirotor_handle.h"

namespace rotorbench {

template std::unique_ptr<PlantHandle> makeMultirotor<8>(const Flight&, RotorDrive);

}  // namespace rotorbench
