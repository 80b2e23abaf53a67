// The charts of an experiment that names none: what a person looks at first, by the kind of the
// experiment.
#pragma once

#include <vector>

#include "sim/document/chart_spec.h"

namespace rotorbench {

struct Experiment;

/// Every pattern names channels that an experiment of this kind has as it is newly made.
std::vector<ChartSpec> defaultCharts(const Experiment& experiment);

/// Those the experiment names, or those of its kind where it names none.
std::vector<ChartSpec> chartsOf(const Experiment& experiment);

}  // namespace rotorbench
