// Metrics as people and programs read them: an aligned table, or one JSON object.
#pragma once

#include <string>

#include "sim/core/run_summary.h"

namespace rotorbench {

/// One row per metric and one column per run where there are few runs, each number with its unit.
/// UTF-8, '\n'.
std::string metricsText(const MetricTable& table);

/// {"experiment": title, "metrics": [{"run": …, NAME: number, …}], "units": {NAME: unit},
/// "verdicts": [{"time": s, "name": …, "what": …}], "events": [{"time": s, "end": s, "name": …,
/// "what": …}], "warnings": [{"path": …, "what": …, "allowed": …}]}; a figure that does not exist
/// is null. Numbers have the shortest digits that read back equal.
std::string metricsJson(const std::string& experimentTitle, const RunSummary& summary);

}  // namespace rotorbench
