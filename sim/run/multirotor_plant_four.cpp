#include "sim/run/multirotor_handle.h"

namespace rotorbench {

template std::unique_ptr<PlantHandle> makeMultirotor<4>(const Flight&, RotorDrive);

}  // namespace rotorbench
