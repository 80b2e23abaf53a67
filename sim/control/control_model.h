// What a controller knows of its vehicle: the plan, without deviations of single arms and motors.
// SI units, body axes x forward, y left, z up.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/propulsion/esc.h"
#include "sim/propulsion/motor.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

template <int N>
struct ControlModel {
  double mass, gravity;
  Eigen::Matrix3d inertia, inverseInertia;
  /// Rotor thrusts (N) to [thrust along z; moments about x, y, z at the centre of mass].
  Eigen::Matrix<double, 4, N> effect;
  std::array<double, N> thrustFactor;    ///< N s^2: thrust per speed squared, about hover
  std::array<double, N> torqueFactor;    ///< N m s^2
  std::array<double, N> maxThrust;       ///< N, what motor and supply can hold at rest
  std::array<double, N> rotorInertia;    ///< kg m^2
  std::array<MotorConstants, N> motors;  ///< with the resistance of their speed controllers
  std::array<EscConstants, N> escs;      ///< how these may slow their motors
};

/// From a plant built `asPlanned`, at the air density of sea level.
template <int N>
ControlModel<N> controlModel(const MultirotorConstants<N>& planned);

/// The speed in rad/s a rotor can hold at `voltage` and within the motor's current limit against
/// the drag torque torqueFactor w^2.
double topSpeed(const MotorConstants& motor, double torqueFactor, double voltage);

}  // namespace rotorbench
