// Steady level flight of a quadrotor: rotor speeds, roll and pitch at which neither force nor
// moment is left, found by Newton's method on the vehicle's own equations
// (sim/vehicle/multirotor.h), and the electrical side of it. SI units; flight along x of the
// inertial frame, yaw 0.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/propulsion/drive/drive_train.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

struct Trim {
  double speed = 0;                                       ///< m/s, level
  Eigen::Vector4d rotors;                                 ///< rad/s
  double roll = 0, pitch = 0;                             ///< rad
  std::array<double, kVehicleRotors> thrust{}, torque{};  ///< N, N m
  double residual =
      0;  ///< largest acceleration left, m/s^2, and moment over weight and arm times g
  /// Angle between the vehicle's vertical and the world's, rad.
  [[nodiscard]] double tilt() const;
};

/// What the motors need for a trim, whatever the supply.
struct DriveDemand {
  Eigen::Vector4d current;  ///< A
  Eigen::Vector4d voltage;  ///< V before the speed controller's resistance
  double motorPower = 0;    ///< W at the motors' terminals
  double shaftPower = 0;    ///< W
  double power = 0;         ///< W drawn from the supply
};

/// All rotors at full throttle at rest.
struct FullThrottle {
  double thrust = 0;  ///< N, along the vehicle's vertical
  double busVoltage = 0, openCircuit = 0, current = 0, power = 0;
  Eigen::Vector4d speeds = Eigen::Vector4d::Zero(), currents = Eigen::Vector4d::Zero();
  bool currentLimited = false;  ///< some motor
};

class SteadyFlight {
 public:
  /// Throws InputError as buildMultirotor().
  SteadyFlight(const VehicleParameters& vehicle, const EnvironmentParameters& environment);

  /// The same vehicle with another mass at its centre of mass, or in air of another density.
  [[nodiscard]] SteadyFlight withMass(double mass) const;
  [[nodiscard]] SteadyFlight withDensity(double density) const;

  /// Flight at a speed in m/s, from `near` on; empty if there is none.
  [[nodiscard]] std::optional<Trim> trim(double speed, const Trim& near) const;
  /// Hover in still air; empty if the rotors cannot hold the vehicle.
  [[nodiscard]] std::optional<Trim> hover() const;

  [[nodiscard]] DriveDemand demand(const Trim& trim) const;
  [[nodiscard]] FullThrottle fullThrottle() const;

  [[nodiscard]] const Supply& supply() const { return supply_; }
  /// The lower limit of motor and speed controller, A.
  [[nodiscard]] double currentLimit(int rotor) const {
    return currentLimits_[static_cast<std::size_t>(rotor)];
  }
  [[nodiscard]] double mass() const { return constants_.mass; }
  [[nodiscard]] double weight() const { return constants_.mass * constants_.gravity; }
  [[nodiscard]] double density() const { return constants_.air.density(0.0); }
  [[nodiscard]] double radius(int rotor) const { return radii_[static_cast<std::size_t>(rotor)]; }

 private:
  using Vehicle = Multirotor<kVehicleRotors, RotorDrive::PrescribedSpeeds>;
  using Unknowns = Eigen::Matrix<double, 6, 1>;  // rotor speeds over the hover's, roll, pitch

  struct Evaluated {
    Unknowns residual;
    MultirotorForces<kVehicleRotors> forces;
  };
  [[nodiscard]] Evaluated evaluate(const Unknowns& x, double speed) const;
  [[nodiscard]] ShaftLoad staticLoad(std::size_t rotor, double topSpeed) const;

  MultirotorConstants<kVehicleRotors> constants_;
  Supply supply_;
  std::array<EscParameters, kVehicleRotors> escs_;
  std::array<MotorParameters, kVehicleRotors> motors_;
  std::array<double, kVehicleRotors> currentLimits_{}, radii_{};
  double scale_ = 1;  ///< rad/s: of rotor speeds
  double arm_ = 1;    ///< m: of moments
};

}  // namespace rotorbench
