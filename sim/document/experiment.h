// The whole question a user asks, as one plain value: what is saved is what is run. Undo keeps old
// values of it, a recording carries the one it was made from. Kinds of experiment are the
// alternatives of `setup`; each has its own header with its parameters, which whoever reads them
// includes, and its own builder.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/box.h"
#include "sim/core/schema.h"
#include "sim/document/chart_spec.h"

namespace rotorbench {

struct Flight;
extern template class Box<Flight>;
struct MotorBench;
extern template class Box<MotorBench>;
struct PropellerBench;
extern template class Box<PropellerBench>;
struct ThrustStand;
extern template class Box<ThrustStand>;
struct MotorSpeedRun;
extern template class Box<MotorSpeedRun>;
struct SolverComparison;
extern template class Box<SolverComparison>;
struct BirotorMotion;
extern template class Box<BirotorMotion>;

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
  std::variant<Box<Flight>, Box<MotorBench>, Box<PropellerBench>, Box<ThrustStand>,
               Box<MotorSpeedRun>, Box<SolverComparison>, Box<BirotorMotion>>
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
