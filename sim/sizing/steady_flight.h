// Steady level flight of a multirotor (sim/analysis/trim.h) in still air, and the electrical side
// of it. SI units; flight along x of the inertial frame, yaw 0.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "sim/analysis/trim.h"
#include "sim/propulsion/drive/drive_train.h"
#include "sim/vehicle/multirotor.h"

namespace rotorbench {

/// What the motors need for a trim, whatever the supply.
struct DriveDemand {
  Eigen::VectorXd current;  ///< A, of each rotor
  Eigen::VectorXd voltage;  ///< V before the speed controller's resistance
  double motorPower = 0;    ///< W at the motors' terminals
  double shaftPower = 0;    ///< W
  double power = 0;         ///< W drawn from the supply
};

/// All rotors at full throttle at rest.
struct FullThrottle {
  double thrust = 0;  ///< N, along the vehicle's vertical
  double busVoltage = 0, openCircuit = 0, current = 0, power = 0;
  Eigen::VectorXd speeds, currents;  ///< rad/s and A, of each rotor
  bool currentLimited = false;       ///< some motor
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
  [[nodiscard]] int rotors() const { return static_cast<int>(rotors_.size()); }
  /// The lower limit of motor and speed controller, A.
  [[nodiscard]] double currentLimit(int rotor) const { return at(rotor).currentLimit; }
  [[nodiscard]] double radius(int rotor) const { return at(rotor).radius; }
  [[nodiscard]] double mass() const;
  [[nodiscard]] double weight() const;
  [[nodiscard]] double density() const;
  /// W, drawn besides the motors.
  [[nodiscard]] double avionicsPower() const;

 private:
  struct Rotor {
    RotorHub hub;
    MotorParameters motor;
    EscParameters esc;
    double currentLimit, radius;  // A, m
    /// Thrust and torque at rest over the speed, up to a speed in rad/s.
    [[nodiscard]] ShaftLoad staticLoad(double topSpeed, double density) const;
  };
  using Constants =
      std::variant<MultirotorConstants<4>, MultirotorConstants<6>, MultirotorConstants<8>>;

  [[nodiscard]] const Rotor& at(int rotor) const {
    return rotors_[static_cast<std::size_t>(rotor)];
  }

  Constants constants_;
  Supply supply_;
  std::vector<Rotor> rotors_;
};

}  // namespace rotorbench
