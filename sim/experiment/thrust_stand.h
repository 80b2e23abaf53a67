// Thrust stand: supply, speed controller, motor and propeller, driven through a procedure as on a
// real stand. At the instants where an operator would read the gauges, what was reached is set
// beside the steady point solved directly for the same throttle and state of the battery. Recorded
// in SI units.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "sim/experiment/drive_stand.h"
#include "sim/experiment/motor_bench.h"
#include "sim/experiment/prescribed_inputs.h"
#include "sim/experiment/simulation.h"

namespace rotorbench {

struct OutputSettings;

struct ThrottleLevel {
  double throttle = 0;  ///< 0..1
  bool operator==(const ThrottleLevel&) const = default;
};

/// One level after the other, each held equally long; read at the end of each.
struct ThrottleLevels {
  std::vector<ThrottleLevel> levels{{0.2}, {0.4}, {0.6}, {0.8}, {1.0}};
  double holdTime = 1;  ///< s
  bool operator==(const ThrottleLevels&) const = default;
};

/// A straight ramp, read at equal intervals.
struct ThrottleSweep {
  double from = 0, to = 1;
  double duration = 20;  ///< s
  int readings = 20;
  bool operator==(const ThrottleSweep&) const = default;
};

/// Any timeline; read where a row ends.
struct ThrottleRows {
  std::vector<ThrottleStep> rows{{0, 0}, {0.5, 0.5}, {1.5, 1}};
  Interpolation interpolation = Interpolation::Hold;
  double duration = 2.5;  ///< s
  bool operator==(const ThrottleRows&) const = default;
};

using ThrottleProcedure = std::variant<ThrottleLevels, ThrottleSweep, ThrottleRows>;

struct StandRunSettings {
  ode::SolverSettings solver{.method = ode::Method::Rk4, .step = 1e-4};
  double tick = 1e-3;  ///< s, the throttle is held for this long
  bool operator==(const StandRunSettings&) const = default;
};

struct ThrustStand {
  DriveStand stand;
  ThrottleProcedure procedure;
  StandRunSettings run;
  bool operator==(const ThrustStand&) const = default;
};

/// The procedure as a signal of throttle, with the instants in s at which the gauges are read,
/// rising.
struct ThrottlePlan {
  InputSignal signal;
  std::vector<double> readings;
};
/// For a procedure without faults.
ThrottlePlan planOf(const ThrottleProcedure& procedure);

/// How long a procedure takes, s.
double durationOf(const ThrottleProcedure& procedure);

/// Throws InputError where the solver does not fit.
std::unique_ptr<Simulation> buildThrustStand(const ThrustStand& stand,
                                             const OutputSettings& outputs);

template <>
struct Describe<ThrottleLevel> {
  static void fields(schema::Builder<ThrottleLevel>& b);
};
template <>
struct Describe<ThrottleLevels> {
  static void fields(schema::Builder<ThrottleLevels>& b);
};
template <>
struct Describe<ThrottleSweep> {
  static void fields(schema::Builder<ThrottleSweep>& b);
};
template <>
struct Describe<ThrottleRows> {
  static void fields(schema::Builder<ThrottleRows>& b);
};
template <>
struct Describe<StandRunSettings> {
  static void fields(schema::Builder<StandRunSettings>& b);
};
template <>
struct Describe<ThrustStand> {
  static void fields(schema::Builder<ThrustStand>& b);
};

}  // namespace rotorbench
