// What can be doubted of an experiment before it runs: one list for the problems panel and the
// command line.
#pragma once

#include <vector>

#include "sim/core/error.h"

namespace rotorbench {

struct Experiment;

/// What needs more than the values by themselves: poles beside the step, delays beside rates, what
/// a hover comes to, and, no mere warning, what the run would be refused for. None for an
/// experiment with errors, which are schema::validate()'s. Quick enough to be asked at every edit.
std::vector<Problem> runWarnings(const Experiment& experiment);

/// All warnings: the schema's own and those above.
std::vector<Problem> preflight(const Experiment& experiment);

}  // namespace rotorbench
