// What can be doubted of a drive before it runs, on a stand and in a vehicle.
#pragma once

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/document/drive_stand.h"

namespace rotorbench {

/// Warns of delays of a speed controller, described at `path`, that are long beside the period of a
/// controller with `rate` in Hz.
void warnOfDelays(const EscParameters& esc, const std::string& path, double rate,
                  std::vector<Problem>& problems);

/// Finds a controller's rate in Hz, described at `path`, that no whole number of ticks makes: the
/// run is refused for it.
void checkRate(double rate, double tick, const std::string& path, std::vector<Problem>& problems);

/// Warns, naming pole, method and largest stable step, where a fixed step cannot be stable. The
/// experiment holds its settings as "run". The stand has no errors.
void warnOfUnstableStep(const DriveStand& stand, const ode::SolverSettings& solver, double tick,
                        std::vector<Problem>& problems);

}  // namespace rotorbench
