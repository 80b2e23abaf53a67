// What the controllers are told, each tick. SI units; inertial frame x forward, y left, z up, body
// axes alike. IdealSensors reads the true state; models of real parts are further alternatives of
// SensorModel and yield the same Measurement.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "sim/core/schema.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

template <int N>
struct Measurement {
  Eigen::Vector3d position;                  ///< m, inertial
  Eigen::Vector3d velocity;                  ///< m/s, inertial
  Eigen::Vector3d attitude;                  ///< roll, pitch, yaw, rad; yaw in (-pi, pi]
  Eigen::Vector3d rates;                     ///< body rates, rad/s
  Eigen::Vector3d specificForce;             ///< body axes, m/s^2
  Eigen::Matrix<double, N, 1> rotorSpeed;    ///< rad/s
  Eigen::Matrix<double, N, 1> motorCurrent;  ///< A
  double busVoltage;                         ///< V
};

/// Sensors without error, all at the centre of mass, read at the very tick (thesis 2014, section
/// 3.1).
struct IdealSensors {
  bool operator==(const IdealSensors&) const = default;

  /// `forces` must belong to `y`.
  template <int N>
  [[nodiscard]] Measurement<N> measure(
      const Eigen::Matrix<double, MultirotorLayout<N>::kStates, 1>& y,
      const MultirotorForces<N>& forces) const {
    using L = MultirotorLayout<N>;
    return {y.template segment<3>(L::kPosition),
            y.template segment<3>(L::kVelocity),
            forces.attitude,
            forces.rates,
            forces.specificForce,
            y.template segment<N>(L::kSpeed),
            y.template segment<N>(L::kCurrent),
            forces.busVoltage};
  }
};

using SensorModel = std::variant<IdealSensors>;

template <>
struct Describe<IdealSensors> {
  static void fields(schema::Builder<IdealSensors>& b) {
    b.title("ideal", "Ideal sensors", "The controllers see the true motion without noise or delay.",
            "Thesis 2014, section 3.1");
  }
};

}  // namespace rotorbench
