// The sensors of a flight as a task.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/sensing/ideal_sensors.h"
#include "sim/signal/task.h"

namespace rotorbench {

/// The task of a model: reads Truth, writes Measurement. Its random streams derive from `seed` and
/// its name.
std::unique_ptr<Task> makeSensors(const SensorModel& model, std::uint64_t seed);

}  // namespace rotorbench
