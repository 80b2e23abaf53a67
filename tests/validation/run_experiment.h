// Running shipped experiments in tests.
#pragma once

#include <string>

#include "sim/core/metrics.h"
#include "sim/document/experiment_file.h"
#include "sim/run/simulation.h"

namespace rotorbench::test {

inline Experiment shipped(const std::string& name) {
  return loadExperiment(std::string(EXPERIMENTS_DIR "/") + name + ".json");
}

/// Runs to the end, `slice` ticks at a time.
inline std::unique_ptr<Simulation> runToEnd(const Experiment& experiment,
                                            std::int64_t slice = 1000) {
  auto simulation = buildSimulation(experiment, EXPERIMENTS_DIR);
  while (simulation->advance(slice) == SimulationState::Running) {
  }
  return simulation;
}

/// A figure of a run; NaN if there is none.
inline double figure(const MetricTable& table, const std::string& run, const std::string& name) {
  for (const auto& row : table) {
    if (row.run != run) continue;
    for (const auto& metric : row.metrics) {
      if (metric.name == name) return metric.value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace rotorbench::test
