// What a controller knows of its vehicle: the plan, without deviations of single arms and motors. A
// plain value; the plant handle (sim/run/plant_handle.h) makes it. SI units, body axes x forward,
// y left, z up.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/signal/signals.h"

namespace rotorbench {

struct ControlModel {
  int rotors = 0;
  double mass = 1, gravity = 9.80665;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d inverseInertia = Eigen::Matrix3d::Identity();
  /// Rotor thrusts (N) to [thrust along z; moments about x, y, z at the centre of mass].
  Eigen::Matrix<double, 4, kMostRotors> effect = Eigen::Matrix<double, 4, kMostRotors>::Zero();
  std::array<double, kMostRotors> thrustFactor{};  ///< N s^2: thrust per speed squared, about hover
  std::array<double, kMostRotors> torqueFactor{};  ///< N m s^2
  std::array<double, kMostRotors> maxThrust{};     ///< N, what motor and supply can hold at rest
  std::array<double, kMostRotors> rotorInertia{};  ///< kg m^2
  std::array<MotorConstants, kMostRotors> motors{};  ///< with their speed controllers' resistance
  std::array<EscConstants, kMostRotors> escs{};      ///< how these may slow their motors
};

}  // namespace rotorbench
