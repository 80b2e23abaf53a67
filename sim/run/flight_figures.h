// Key figures of a flight, read from its recording.
#pragma once

#include <vector>

#include "sim/control/controller.h"
#include "sim/core/error.h"
#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/document/set_points.h"
#include "sim/propulsion/drive/battery.h"

namespace rotorbench {

/// Of each held quantity the worst of all its steps: overshoot, settling time, error at rest.
void addStepFigures(const Recording& recording, const std::vector<HeldQuantity>& held,
                    const std::vector<SetPointRow>& timeline, std::vector<Metric>& metrics);
/// Figures of any flight: peaks, energy and what is left of it, where it ended.
void addFlightFigures(const Recording& recording, const Supply& supply,
                      std::vector<Metric>& metrics);
/// How a flight ends whose battery is below its cut-off, V.
RunFailure emptyBattery(double time, double voltage, double cutOff);

}  // namespace rotorbench
