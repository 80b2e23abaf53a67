// The whole question a user asks, as one plain value: what is saved is what is run. Undo keeps old
// values of it, a recording carries the one it was made from. Kinds of experiment are the
// alternatives of `setup`; each has its own header with its parameters and its own builder.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/schema.h"
#include "sim/document/birotor_motion.h"
#include "sim/document/chart_spec.h"
#include "sim/document/flight.h"
#include "sim/document/motor_bench.h"
#include "sim/document/motor_speed_run.h"
#include "sim/document/propeller_bench.h"
#include "sim/document/solver_comparison.h"
#include "sim/document/thrust_stand.h"

namespace rotorbench {

/// What is kept of a run and how much memory it may take.
struct OutputSettings {
  double recordInterval = 0.001;  ///< s, rounded to whole ticks of the experiment
  double memoryLimit = 2e9;       ///< bytes for all recordings of one run of the experiment
  bool thinWhenFull = true;       ///< else the run stops with a message
  std::vector<ChartSpec> charts;  ///< panes shown when the experiment is opened
  bool operator==(const OutputSettings&) const = default;
};

struct Experiment {
  std::string title = "New experiment";
  std::string summary;  ///< one line, shown on the gallery card
  std::string notes;    ///< as long as the user likes
  std::variant<Flight, MotorBench, PropellerBench, ThrustStand, MotorSpeedRun, SolverComparison,
               BirotorMotion>
      setup;
  OutputSettings outputs;
  std::uint64_t seed = 1;
  bool operator==(const Experiment&) const = default;
};

template <>
struct Describe<OutputSettings> {
  static void fields(schema::Builder<OutputSettings>& b);
};

template <>
struct Describe<Experiment> {
  static void fields(schema::Builder<Experiment>& b);
};

}  // namespace rotorbench
