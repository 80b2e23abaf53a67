// Where the quantities of a multirotor stand in its state, and what its equations yield besides the
// derivative. SI units; inertial frame x forward, y left, z up; body axes alike, at the actual
// centre of mass.
#pragma once

#include <Eigen/Core>
#include <array>

namespace rotorbench {

/// How rotor speeds come about.
enum class RotorDrive {
  Motors,           ///< command: duty of each motor after any dead time, 0..1, or -1..1 where its
                    // /< speed controller is reversible; rotor speed and current are computed
  PrescribedSpeeds  ///< command: rotor acceleration in rad/s^2; speeds are set with
                    // /< setRotorSpeeds()
};

/// Where each quantity stands in the state. Rotor arrays come first and everything is contiguous,
/// so that the sums of a Runge-Kutta step vectorise; 3 N + 16 is even for the same reason.
template <int N>
struct MultirotorLayout {
  static constexpr int kSpeed = 0;                  ///< rad/s, N
  static constexpr int kCurrent = N;                ///< A, N
  static constexpr int kDuty = 2 * N;               ///< -1..1, N: of the speed controllers
  static constexpr int kAttitude = 3 * N;           ///< w x y z, body to inertial
  static constexpr int kMomentum = 3 * N + 4;       ///< H, body axes, kg m^2/s
  static constexpr int kVelocity = 3 * N + 7;       ///< inertial, m/s
  static constexpr int kPosition = 3 * N + 10;      ///< inertial, m
  static constexpr int kCharge = 3 * N + 13;        ///< A s drawn from the supply
  static constexpr int kPolarisation = 3 * N + 14;  ///< V over the RC pair of the battery
  static constexpr int kEnergy = 3 * N + 15;        ///< J drawn from the supply's terminals
  static constexpr int kStates = 3 * N + 16;
};

/// What the derivative works out on the way, for sensors, charts and recordings.
template <int N>
struct MultirotorForces {
  std::array<double, N> thrust;   ///< N
  std::array<double, N> torque;   ///< N m, aerodynamic, against the rotation
  std::array<double, N> voltage;  ///< V at the motor
  std::array<double, N> duty;     ///< -1..1 that acts: the share of the bus voltage
  double busVoltage;              ///< V of the supply under load
  double supplyCurrent;           ///< A drawn from the supply
  double stateOfCharge;           ///< 0..1; stays where it is for a supply that never empties
  Eigen::Vector3d attitude;       ///< roll, pitch, yaw (Z-Y-X), rad; yaw in (-pi, pi]
  Eigen::Vector3d rates;          ///< body rates, rad/s
  Eigen::Vector3d acceleration;   ///< inertial, m/s^2
  Eigen::Vector3d
      specificForce;     ///< body axes, m/s^2: what an accelerometer at the centre of mass reads
  Eigen::Vector3d wind;  ///< m/s of the air over the ground at the centre of mass, inertial
  double density;        ///< kg/m^3 of the air there
};

/// Powers in W of one instant of all motors and the supply; what goes in equals what is stored and
/// lost.
struct FlightPowers {
  double source;        ///< OCV i, taken from the cells
  double supplyLoss;    ///< R_0 i^2 + v_rc i
  double escLoss;       ///< what the speed controllers take and do not give to the motors
  double copperLoss;    ///< sum of R i^2
  double frictionLoss;  ///< sum of friction(w) w
  double shaft;         ///< sum of Q w: what the air takes
  double avionics;      ///< drawn besides the motors
  double magnetic;      ///< d/dt of the sum of L i^2/2
  double kinetic;       ///< sum of J w w'
  /// source minus everything else; 0 up to rounding.
  [[nodiscard]] double residual() const {
    return source - supplyLoss - escLoss - copperLoss - frictionLoss - shaft - avionics - magnetic -
           kinetic;
  }
};

}  // namespace rotorbench
