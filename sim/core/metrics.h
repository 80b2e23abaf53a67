// Key figures of a run: named numbers with units, one row per run of an experiment.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rotorbench {

/// One figure. Names are snake_case ("max_error_norm", "roll_overshoot"); a value may be NaN where
/// a figure does not exist for that run (printed as "-" or null).
struct Metric {
  std::string name;
  std::string unit;  ///< SI symbol, "1" for plain numbers
  std::string description;
  double value = 0;
};

struct MetricRow {
  std::string run;
  std::vector<Metric> metrics;
};

using MetricTable = std::vector<MetricRow>;

}  // namespace rotorbench
