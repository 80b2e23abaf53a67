// What every rotor model answers: force and moment on the body. SI units; v: velocity of the hub
// against the air.
#pragma once

#include <Eigen/Core>

namespace rotorbench {

/// Force and moment of a rotor in body axes, the moment about the hub. S is a scalar, or an array
/// with one lane per rotor.
template <class S, class Vector = Eigen::Matrix<S, 3, 1>>
struct RotorLoad {
  Vector force;
  Vector moment;
  S thrust;  ///< N along the axis
  S torque;  ///< N m, aerodynamic, against the rotation
};

inline constexpr double kStandardDensity = 1.225;  ///< kg/m^3, ISO 2533:1975 at sea level
/// Pa s, dynamic, at 20 degrees Celsius by Sutherland's law; it changes by 3 % in 13 kelvin.
inline constexpr double kAirViscosity = 1.81e-5;

}  // namespace rotorbench
