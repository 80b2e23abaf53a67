// Sensors without error, all at the centre of mass, read at the very tick (thesis 2014, section
// 3.1). Models of real parts are further alternatives of SensorModel: each has its parameters, its
// task and one line in makeSensors() (sensor_tasks.h).
#pragma once

#include <variant>

#include "sim/core/schema.h"

namespace rotorbench {

struct IdealSensors {
  bool operator==(const IdealSensors&) const = default;
};

using SensorModel = std::variant<IdealSensors>;

template <>
struct Describe<IdealSensors> {
  static void fields(schema::Builder<IdealSensors>& b);
};

}  // namespace rotorbench
