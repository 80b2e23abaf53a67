// Thrust stand: supply, speed controller, motor and propeller, driven through a procedure as on a
// real stand. At the instants where an operator would read the gauges, what was reached is set
// beside the steady point solved directly for the same throttle and state of the battery. Recorded
// in SI units.
#pragma once

#include <variant>
#include <vector>

#include "sim/document/drive_stand.h"
#include "sim/document/motor_bench.h"

namespace rotorbench {

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

/// How long a procedure takes, s.
double durationOf(const ThrottleProcedure& procedure);

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
