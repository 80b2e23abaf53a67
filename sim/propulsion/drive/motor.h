// A direct-current machine; a brushless motor behind its speed controller is the same averaged
// machine. SI units. Rotor speed is counted positive in the rotor's own sense of rotation, whatever
// its spin.
//   L di/dt = v - R i - K_b w                                  thesis 2014, figure 3.11
//   J dw/dt = K_t i - f w - T_c sign(w) - Q_aero
// K_t = K_b = 60/(2 pi Kv); f and T_c come from the no-load current I0 at the voltage V0.
#pragma once

#include <cmath>

#include "sim/core/schema.h"

namespace rotorbench {

/// A, the largest limit a motor can be given. A speed controller with this one leaves the limit to
/// its motor.
inline constexpr double kMostCurrentLimit = 1e4;

/// As a data sheet gives a motor. A file that describes one must give its speed constant and its
/// resistance, for no value of them is neutral; what else it leaves out has no effect.
struct MotorParameters {
  double speedConstant = 100;  ///< Kv in (rad/s)/V
  double resistance = 0.1;     ///< Ohm, winding and speed controller
  double inductance = 50e-6;   ///< H
  double noLoadCurrent = 0;    ///< A
  double noLoadVoltage = 10;   ///< V
  double viscousShare = 0;     ///< part of the no-load torque that grows with speed, 0..1
  double maxCurrent = kMostCurrentLimit;  ///< A, kept by the motor speed controller
  bool operator==(const MotorParameters&) const = default;
};

/// The motor of the default vehicle and of the default stand, which are the DJI F450 and its E305
/// set.
MotorParameters djiE305();

/// Width in rad/s of the smooth sign(w) of dry friction: small against any flying speed, and wide
/// enough that the friction of a stopping rotor is no stiffer than the rest of the motor.
inline constexpr double kFrictionSpeed = 1.0;

/// The equations of one motor (Real is double) or of several at once (Real is an Eigen::Array of
/// double with one lane per motor).
template <class Real>
struct MotorModel {
  Real torqueConstant{};     ///< K_t = K_b, N m/A = V s/rad
  Real resistance{};         ///< Ohm
  Real inverseInductance{};  ///< 1/H
  Real viscousFriction{};    ///< f, N m s
  Real dryFriction{};        ///< T_c, N m

  /// Friction torque in N m at speed w, against the rotation; smooth through w = 0.
  template <class S>
  [[nodiscard]] S friction(const S& w) const {
    using std::sqrt;
    const S smooth = sqrt(w * w + kFrictionSpeed * kFrictionSpeed);
    return S(w * (viscousFriction + dryFriction / smooth));
  }
  /// di/dt in A/s at terminal voltage v, current i and speed w.
  template <class S>
  [[nodiscard]] S currentRate(const S& v, const S& i, const S& w) const {
    return S((v - resistance * i - torqueConstant * w) * inverseInductance);
  }
  /// Current in A that holds speed w against an aerodynamic torque in N m.
  template <class S>
  [[nodiscard]] S steadyCurrent(const S& w, const S& aerodynamicTorque) const {
    return S((aerodynamicTorque + friction(w)) / torqueConstant);
  }
  /// Terminal voltage in V that carries current i at speed w in the steady state.
  template <class S>
  [[nodiscard]] S steadyVoltage(const S& w, const S& i) const {
    return S(resistance * i + torqueConstant * w);
  }
};

/// One motor.
struct MotorConstants : MotorModel<double> {
  double inductance = 1;  ///< H
  double maxCurrent = 0;  ///< A
};

MotorConstants buildMotor(const MotorParameters& parameters);

/// Largest magnitude of the poles of current and speed, 1/s: [di/dt; dw/dt] = [[-r/L, -K/L], [K/J,
/// -d/J]] with a resistance r in Ohm, a drag d = dQ/dw in N m s and an inertia J in kg m^2.
double fastestPole(const MotorConstants& motor, double resistance, double drag, double inertia);

/// The speed in rad/s a rotor can hold at `voltage` and within the motor's current limit against
/// the drag torque torqueFactor w^2.
double topSpeed(const MotorConstants& motor, double torqueFactor, double voltage);

/// A source of fixed voltage behind an internal resistance, shared by all motors.
struct SupplyParameters {
  double voltage = 11.1;          ///< V, open circuit
  double internalResistance = 0;  ///< Ohm
  bool operator==(const SupplyParameters&) const = default;
};

template <>
struct Describe<MotorParameters> {
  static void fields(schema::Builder<MotorParameters>& b);
};

template <>
struct Describe<SupplyParameters> {
  static void fields(schema::Builder<SupplyParameters>& b);
};

}  // namespace rotorbench
