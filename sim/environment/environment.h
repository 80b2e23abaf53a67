// What surrounds the vehicle: gravity and air. SI units; altitude is z of the inertial frame (up),
// m. Air is a variant of models; each has a parameter struct, and the run evaluates AirConstants.
#pragma once

#include <variant>

#include "sim/core/schema.h"

namespace rotorbench {

/// Air of one density everywhere.
struct UniformAir {
  double density = 1.225;  ///< kg/m^3
  bool operator==(const UniformAir&) const = default;
};

using AirModel = std::variant<UniformAir>;

struct EnvironmentParameters {
  double gravity = 9.80665;  ///< m/s^2, acts along -z of the inertial frame
  AirModel air;
  bool operator==(const EnvironmentParameters&) const = default;
};

/// Air as the derivative sees it: nothing but numbers, over any scalar.
struct AirConstants {
  double seaLevelDensity = 1.225;  ///< kg/m^3

  /// Density in kg/m^3 at an altitude in m.
  template <class S>
  [[nodiscard]] S density(const S& /*altitude*/) const {
    return S(seaLevelDensity);
  }
};

/// The constants of the chosen air model.
AirConstants buildAir(const AirModel& model);

template <>
struct Describe<UniformAir> {
  static void fields(schema::Builder<UniformAir>& b);
};

template <>
struct Describe<EnvironmentParameters> {
  static void fields(schema::Builder<EnvironmentParameters>& b);
};

}  // namespace rotorbench
