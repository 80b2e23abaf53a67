// Gains of a PID controller (sim/control/pid.h).
#pragma once

#include "sim/core/schema.h"

namespace rotorbench {

/// What a PID acts on: decides units and nothing else.
enum class PidUse { Height, Angle, RotorSpeed };

template <PidUse Use>
struct PidParameters {
  double kp = 0;              ///< 1/s^2 (rotor speed: 1/s)
  double ki = 0;              ///< 1/s^3 (rotor speed: 1/s^2)
  double kd = 0;              ///< 1/s (rotor speed: 1)
  double setPointWeight = 1;  ///< b, 0..1: part of the set-point the proportional term sees
  double filterTime = 0.01;   ///< T_f of the derivative, s
  double trackingTime = 0.5;  ///< T_t of the back-calculation, s
  double limit = 10;          ///< largest demand, m/s^2 or rad/s^2
  bool operator==(const PidParameters&) const = default;
};

template <>
struct Describe<PidParameters<PidUse::Height>> {
  static void fields(schema::Builder<PidParameters<PidUse::Height>>& b);
};
template <>
struct Describe<PidParameters<PidUse::Angle>> {
  static void fields(schema::Builder<PidParameters<PidUse::Angle>>& b);
};
template <>
struct Describe<PidParameters<PidUse::RotorSpeed>> {
  static void fields(schema::Builder<PidParameters<PidUse::RotorSpeed>>& b);
};

}  // namespace rotorbench
