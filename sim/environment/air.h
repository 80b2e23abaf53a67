// Air as the derivative sees it: nothing but numbers, over any scalar. SI units; inertial frame x
// forward, y left, z up.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "sim/core/scalar.h"
#include "sim/environment/standard_atmosphere.h"

namespace rotorbench {

/// The air at one place and time.
template <class S>
struct AirAt {
  Eigen::Matrix<S, 3, 1> velocity;  ///< m/s over the ground, inertial
  S density;                        ///< kg/m^3
};

struct AirConstants {
  /// Density: `uniform`, or the standard atmosphere's.
  double uniform = 1.225;  ///< kg/m^3
  bool standard = false;
  double elevation = 0;  ///< m: of z = 0 above mean sea level
  double warmer = 0;     ///< K

  /// Wind: `wind` everywhere, or, over height, times ln(h/z_0)/ln(h_r/z_0).
  bool moving = false;
  bool overHeight = false;
  std::array<double, 3> wind{};  ///< m/s, at the reference height
  double ground = 0;             ///< m: z of the ground
  double inverseRoughness = 1;   ///< 1/m
  double inverseLogarithm = 1;   ///< 1/ln(h_r/z_0)

  /// One velocity and one density wherever the vehicle's rotors are.
  [[nodiscard]] bool sameAtAllRotors() const { return !standard && !overHeight; }

  /// Density in kg/m^3 at height z.
  template <class S>
  [[nodiscard]] S density(const S& z) const {
    if (!standard) return S(uniform);
    return standardDensity<S>(z + elevation, warmer);
  }
  /// Velocity in m/s at height z. No model depends on the time yet, or on the place beside.
  template <class S>
  [[nodiscard]] Eigen::Matrix<S, 3, 1> velocity(double /*time*/, const S& z) const {
    using std::log;
    S share(1.0);
    if (overHeight) {
      const S ratio = (z - ground) * inverseRoughness;
      share = valueOf(ratio) > 1 ? S(log(ratio) * inverseLogarithm) : S(0.0);
    }
    return {share * wind[0], share * wind[1], share * wind[2]};
  }
  template <class S>
  [[nodiscard]] AirAt<S> at(double time, const S& z) const {
    return {velocity(time, z), density(z)};
  }
};

}  // namespace rotorbench
