// How the air moves, as a person enters it. SI units; inertial frame x forward, y left, z up. A
// velocity is that of the air over the ground: wind from ahead has a negative x.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "sim/core/schema.h"

namespace rotorbench {

struct StillAir {
  bool operator==(const StillAir&) const = default;
};

/// The same everywhere and always. Default: a gentle breeze, Beaufort 3.
struct SteadyWind {
  Eigen::Vector3d velocity{5, 0, 0};  ///< m/s
  bool operator==(const SteadyWind&) const = default;
};

/// Wind over flat ground whose speed rises with the logarithm of the height.
struct LogarithmicWind {
  Eigen::Vector2d velocity{5, 0};  ///< m/s, at the reference height
  double referenceHeight = 10;     ///< m
  double roughness = 0.03;         ///< z_0, m
  double ground = 0;               ///< m: z of the ground
  bool operator==(const LogarithmicWind&) const = default;
};

using WindModel = std::variant<StillAir, SteadyWind, LogarithmicWind>;

template <>
struct Describe<StillAir> {
  static void fields(schema::Builder<StillAir>& b);
};
template <>
struct Describe<SteadyWind> {
  static void fields(schema::Builder<SteadyWind>& b);
};
template <>
struct Describe<LogarithmicWind> {
  static void fields(schema::Builder<LogarithmicWind>& b);
};

}  // namespace rotorbench
