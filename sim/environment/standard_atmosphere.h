// The standard atmosphere of ISO 2533:1975 (below 32 km the same as the U.S. Standard Atmosphere
// 1976): temperature, pressure and density over altitude. SI units; altitudes are geometric, in m
// above mean sea level.
#pragma once

#include <cmath>

#include "sim/core/scalar.h"

namespace rotorbench {

namespace isa {
inline constexpr double kTemperature = 288.15;        ///< K at sea level
inline constexpr double kPressure = 101325;           ///< Pa at sea level
inline constexpr double kGasConstant = 287.05287;     ///< J/(kg K) of dry air
inline constexpr double kGravity = 9.80665;           ///< m/s^2
inline constexpr double kLapse = 0.0065;              ///< K/m in the troposphere
inline constexpr double kTropopause = 11000;          ///< m, geopotential
inline constexpr double kEarthRadius = 6356766;       ///< m, of geopotential altitude
inline constexpr double kLow = -5000, kHigh = 20000;  ///< m: the formulas hold between these
}  // namespace isa

/// Density in kg/m^3 of air that is `warmer` K warmer than the standard at the same pressure.
/// Beyond isa::kLow and isa::kHigh that of the nearer of the two. Any scalar.
template <class S>
[[nodiscard]] S standardDensity(const S& altitude, double warmer = 0) {
  using std::exp;
  using std::pow;
  S z = altitude;
  if (valueOf(z) < isa::kLow) z = S(isa::kLow);
  if (valueOf(z) > isa::kHigh) z = S(isa::kHigh);
  const S h = isa::kEarthRadius * z / (isa::kEarthRadius + z);
  constexpr double kPower = isa::kGravity / (isa::kGasConstant * isa::kLapse);
  if (valueOf(h) <= isa::kTropopause) {
    const S temperature = isa::kTemperature - isa::kLapse * h;
    const S pressure = isa::kPressure * pow(S(temperature / isa::kTemperature), kPower);
    return pressure / (isa::kGasConstant * (temperature + warmer));
  }
  const double cold = isa::kTemperature - isa::kLapse * isa::kTropopause;
  const double top = isa::kPressure * std::pow(cold / isa::kTemperature, kPower);
  const double scale = isa::kGasConstant * cold / isa::kGravity;
  return top * exp(S((isa::kTropopause - h) / scale)) / (isa::kGasConstant * (cold + warmer));
}

/// Density in kg/m^3 at the tropopause.
[[nodiscard]] inline double standardTropopause() {
  constexpr double kGeometric =
      isa::kEarthRadius * isa::kTropopause / (isa::kEarthRadius - isa::kTropopause);
  return standardDensity(kGeometric);
}

/// Altitude in m, up to the tropopause, at which standard air has a density in kg/m^3.
[[nodiscard]] inline double standardAltitude(double density) {
  constexpr double kPower = isa::kGravity / (isa::kGasConstant * isa::kLapse) - 1;
  const double sea = isa::kPressure / (isa::kGasConstant * isa::kTemperature);
  const double h = isa::kTemperature / isa::kLapse * (1 - std::pow(density / sea, 1 / kPower));
  return isa::kEarthRadius * h / (isa::kEarthRadius - h);
}

}  // namespace rotorbench
