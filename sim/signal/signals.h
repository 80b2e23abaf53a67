// What passes between the tasks of a flight within a tick: plain numbers, no plant. SI units;
// inertial frame x forward, y left, z up, body axes alike.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace rotorbench {

/// Signals have room for eight rotors and carry their number; the lanes beyond it are nobody's.
inline constexpr int kMostRotors = 8;
using PerRotor = Eigen::Matrix<double, kMostRotors, 1>;

struct BodyMotion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, inertial
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, inertial
  /// Roll, pitch, yaw (Z-Y-X), rad; yaw in (-pi, pi].
  Eigen::Vector3d attitude = Eigen::Vector3d::Zero();
  Eigen::Vector3d rates = Eigen::Vector3d::Zero();  ///< body rates, rad/s
};

/// What the motors' electronics know.
struct DriveReadings {
  PerRotor speed = PerRotor::Zero();    ///< rad/s
  PerRotor current = PerRotor::Zero();  ///< A
  double busVoltage = 0;                ///< V of the supply under load
};

/// The plant as it is at the beginning of a tick.
struct Truth {
  BodyMotion body;
  Eigen::Vector3d specificForce = Eigen::Vector3d::Zero();  ///< body axes, m/s^2
  DriveReadings drives;
  double openCircuit = 0;  ///< V of the supply
  double tiltCosine = 1;   ///< of the angle between the body's z axis and the vertical
};

/// What sensors make of it.
struct Measurement {
  BodyMotion body;
  Eigen::Vector3d specificForce = Eigen::Vector3d::Zero();
  DriveReadings drives;
};

/// What an estimator believes: the controllers see this.
struct Estimate {
  BodyMotion body;
};

struct SetPoint {
  double height = 0;  ///< m
  /// rad; yaw may leave (-pi, pi], steps take the short way round.
  double roll = 0, pitch = 0, yaw = 0;
};

/// Rotor speeds a flight controller asks of the speed controllers, rad/s.
struct RotorDemand {
  PerRotor speed = PerRotor::Zero();
};

/// What the plant is told. With motors: duties, 0..1, or -1..1 where a speed controller is
/// reversible. With prescribed speeds: rad/s, and rad/s^2 until the next tick.
struct RotorCommand {
  PerRotor value = PerRotor::Zero();
  PerRotor rate = PerRotor::Zero();
};

/// All signals of one flight, held from tick to tick.
struct Board {
  Board() = default;
  /// For a vehicle of so many rotors. A build with assertions fills the lanes beyond them with NaN,
  /// which nobody may notice.
  explicit Board(int count);

  int rotors = 0;
  Truth truth;
  Measurement measurement;
  Estimate estimate;
  SetPoint setPoint;
  RotorDemand demand;
  RotorCommand command;
};

enum class Signal { Truth, Measurement, Estimate, SetPoint, RotorDemand, RotorCommand };
inline constexpr int kSignals = 6;
/// As messages name them: "Measurement".
const char* nameOf(Signal signal);

/// A set of signals.
class SignalSet {
 public:
  constexpr SignalSet() = default;
  constexpr SignalSet(Signal signal) : bits_(1U << static_cast<unsigned>(signal)) {}
  constexpr SignalSet operator|(SignalSet other) const { return SignalSet(bits_ | other.bits_); }
  [[nodiscard]] constexpr bool has(Signal s) const {
    return (bits_ >> static_cast<unsigned>(s) & 1U) != 0;
  }

 private:
  constexpr explicit SignalSet(unsigned bits) : bits_(bits) {}
  unsigned bits_ = 0;
};
constexpr SignalSet operator|(Signal a, Signal b) {
  return SignalSet(a) | SignalSet(b);
}

}  // namespace rotorbench
