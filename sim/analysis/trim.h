// Trim: rotor speeds, roll and pitch at which a multirotor flies steadily, yaw 0, found by Newton's
// method on the vehicle's own equations (sim/vehicle/multirotor.h) with their exact Jacobian. With
// more rotors than that takes, the step of least norm is made, so that the speeds stay near those
// the search begins at. SI units; inertial frame x forward, y left, z up.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sim/signal/signals.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

struct Trim {
  int count = 0;                       ///< of the rotors; what lies beyond is nobody's
  double speed = 0;                    ///< m/s, level, along x
  double roll = 0, pitch = 0;          ///< rad
  PerRotor speeds = PerRotor::Zero();  ///< rad/s
  PerRotor thrust = PerRotor::Zero(), torque = PerRotor::Zero();  ///< N, N m
  /// Largest acceleration left, m/s^2, and moment over weight and arm times g.
  double residual = 0;

  [[nodiscard]] auto rotors() const { return speeds.head(count); }
  /// Angle between the vehicle's vertical and the world's, rad.
  [[nodiscard]] double tilt() const;
};

/// Steady flight at a speed in m/s through still air of the density at height 0, from `near` on;
/// empty if there is none. N is 4, 6 or 8.
template <int N>
std::optional<Trim> trimmedFlight(const MultirotorConstants<N>& vehicle, double speed,
                                  const Trim& near);

/// Hover in still air; empty if the rotors cannot hold the vehicle.
template <int N>
std::optional<Trim> trimmedHover(const MultirotorConstants<N>& vehicle);

/// The hover a flight begins in: trimmedHover(), or, where yaw cannot be balanced, the level one
/// that balances all else. Throws InputError if some rotor would have to pull downwards.
template <int N>
Trim hoverToStartIn(const MultirotorConstants<N>& vehicle);

}  // namespace rotorbench
