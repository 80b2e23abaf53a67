// What surrounds the vehicle: gravity, the density of the air and its wind. SI units; inertial
// frame x forward, y left, z up. Density and wind are variants of models; each has a parameter
// struct, and the run evaluates AirConstants.
#pragma once

#include <variant>

#include "sim/core/schema.h"
#include "sim/environment/air.h"
#include "sim/environment/wind.h"

namespace rotorbench {

/// Air of one density everywhere.
struct UniformAir {
  double density = 1.225;  ///< kg/m^3
  bool operator==(const UniformAir&) const = default;
};

/// Air that gets thinner with height, as the standard atmosphere.
struct StandardAir {
  double elevation = 0;  ///< m: of z = 0 above mean sea level
  double warmer = 0;     ///< K above the standard at every height
  bool operator==(const StandardAir&) const = default;
};

using AirModel = std::variant<UniformAir, StandardAir>;

struct EnvironmentParameters {
  double gravity = 9.80665;  ///< m/s^2, acts along -z of the inertial frame
  AirModel air;
  WindModel wind;
  bool operator==(const EnvironmentParameters&) const = default;
};

/// The constants of the chosen models.
AirConstants buildAir(const EnvironmentParameters& environment);

template <>
struct Describe<UniformAir> {
  static void fields(schema::Builder<UniformAir>& b);
};
template <>
struct Describe<StandardAir> {
  static void fields(schema::Builder<StandardAir>& b);
};

template <>
struct Describe<EnvironmentParameters> {
  static void fields(schema::Builder<EnvironmentParameters>& b);
};

}  // namespace rotorbench
