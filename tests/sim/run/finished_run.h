// An experiment run to its end, and what is read off it, for the tests of the stands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment.h"
#include "sim/run/preflight.h"
#include "sim/run/simulation.h"

namespace rotorbench::test {

inline std::unique_ptr<Simulation> finished(const Experiment& experiment) {
  auto simulation = buildSimulation(experiment);
  while (simulation->advance(1000) == SimulationState::Running) {
  }
  if (simulation->state() != SimulationState::Finished) qFatal("the run failed");
  return simulation;
}

/// A figure of the run number `part`.
inline double figure(const Simulation& simulation, const std::string& name, std::size_t part = 0) {
  const MetricTable table = simulation.metrics();
  for (const Metric& m : table.at(part).metrics)
    if (m.name == name) return m.value;
  qFatal("no metric %s", name.c_str());
}

inline const Recording& run(const Simulation& simulation, const std::string& name) {
  for (const RunOutput& r : simulation.runs())
    if (r.name == name) return *r.recording;
  qFatal("no run %s", name.c_str());
}

inline double value(const Recording& r, const std::string& channel, std::size_t row) {
  const auto column = r.find(channel);
  if (!column || row >= r.rows()) qFatal("no value of %s", channel.c_str());
  return r.value(*column, row);
}

inline std::vector<Problem> warningsOf(const Experiment& experiment) {
  return preflight(experiment);
}

}  // namespace rotorbench::test
