// An electronic speed controller as an averaged converter: it puts the share `duty` of the supply's
// voltage on the motor and takes the share `duty` of the motor's current from the supply. SI units;
// speed and current positive in the rotor's own sense.
//   lag        dd/dt = (u - d)/T, or d = u without a response time
//   converter  v = d V - R_esc i,   V i_bus = v i + R_esc i^2,   |v - K w| <= R i_max
// Without active braking the other halves of its bridges are diodes. The current then flows only
// the way the duty drives it, s = sign(d), s i >= 0: the terminals are never below the back-EMF, s
// v >= s K w, so that a current dies away with L/R and leaves the motor alone, and never below a
// shorted bridge, s v >= -R_esc s i, so that no power returns to the supply, even where a rotor
// turns against its duty and no limit can hold its current.
// What a real one loses beside that, and how its diodes change the voltage at little current:
// conversion.h.
//   R. W. Erickson, D. Maksimovic, Fundamentals of Power Electronics, chapter 3
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/scalar.h"
#include "sim/core/schema.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

/// What is not known of one is ideal: neither losses nor lag nor limit.
struct EscParameters {
  double resistance = 0;                  ///< Ohm, of the switches in the motor's path
  double responseTime = 0;                ///< s, first-order lag from throttle to duty; 0: none
  double deadTime = 0;                    ///< s, from a throttle command until it begins to act
  double maxCurrent = kMostCurrentLimit;  ///< A, kept by limiting the voltage
  bool reverse = false;                   ///< duty in -1..1 instead of 0..1
  bool activeBraking = true;              ///< else no current flows back
  double throttleStart = 0;               ///< throttle below which the duty is 0
  double throttleFull = 1;                ///< throttle from which on the duty is 1
  double pwmFrequency = 0;                ///< Hz, of the switches; 0: the current has no ripple
  double switchingLoss = 0;   ///< of V i, lost where the voltage is chopped; see conversion.h
  double leadResistance = 0;  ///< Ohm, of the leads between supply and converter
  bool operator==(const EscParameters&) const = default;
};

/// How a command becomes the duty, for one speed controller (Real is double) or several at once
/// (Real is an Eigen::Array of double with one lane each). `u` is the command after any dead time,
/// `d` the state that follows it.
template <class Real>
struct DutyModel {
  Real inverseResponse{};  ///< 1/s; 0 without a lag
  Real direct{};           ///< 1 without a lag, else 0
  Real least{};            ///< of commands; -1 where reversible, else 0. The most is 1

  /// The duty that acts: exactly the command where there is no lag.
  template <class S>
  [[nodiscard]] S duty(const S& u, const S& d) const {
    return S(direct * u + (1.0 - direct) * d);
  }
  /// Its rate in 1/s; 0 without a lag.
  template <class S>
  [[nodiscard]] S rate(const S& u, const S& d) const {
    return S((u - d) * inverseResponse);
  }
};

/// One speed controller with its motor's limit.
struct EscConstants : DutyModel<double> {
  double most = 1;        ///< of commands
  double resistance = 0;  ///< Ohm
  double maxCurrent = 0;  ///< A, the lower limit of motor and speed controller
  bool activeBraking = true;
  double throttleStart = 0, throttleFull = 1;
  double switchingLoss = 0;
  double leadResistance = 0;  ///< Ohm
  double ripple = 0;          ///< A/V: 1/(L f); 0 where the current has no ripple
  double pathResistance = 0;  ///< Ohm, of winding and switches

  [[nodiscard]] double allowed(double command) const { return std::clamp(command, least, most); }
  /// Something of conversion.h acts.
  [[nodiscard]] bool lossy() const { return switchingLoss > 0 || leadResistance > 0 || ripple > 0; }
  /// What a speed controller makes of a throttle, by the straight line between the two ends it was
  /// calibrated to; and the throttle that gives a duty. Both odd.
  [[nodiscard]] double dutyOf(double throttle) const {
    if (throttleStart == 0 && throttleFull == 1) return throttle;
    const double part = (std::abs(throttle) - throttleStart) / (throttleFull - throttleStart);
    return std::copysign(std::clamp(part, 0.0, 1.0), throttle);
  }
  [[nodiscard]] double throttleOf(double duty) const {
    if (duty == 0 || (throttleStart == 0 && throttleFull == 1)) return duty;
    return std::copysign(throttleStart + std::abs(duty) * (throttleFull - throttleStart), duty);
  }

  /// Terminal voltage in V of a motor with back-EMF `back` in V: `free` = d V - R_esc i as far as
  /// the limit of the current and the way it may flow let it. Any scalar.
  template <class S>
  [[nodiscard]] S voltage(const MotorConstants& motor, const S& duty, const S& current,
                          const S& free, const S& back) const {
    using std::max;
    using std::min;
    const double band = motor.resistance * maxCurrent;
    if (activeBraking) return S(min(S(max(free, S(back - band))), S(back + band)));
    const double way = wayOf(duty);
    const S bottom = max(S(way * back), S(-way * resistance * current));
    return S(way * max(S(min(S(way * free), S(way * back + band))), bottom));
  }
  /// The share of a bus of `bus` V above 0 that this takes: the duty, or what of it the limits
  /// leave; at most all of the bus.
  template <class S>
  [[nodiscard]] S shareOf(const MotorConstants& motor, const S& duty, const S& current,
                          const S& back, const S& bus) const {
    using std::max;
    using std::min;
    const S drop = S(resistance * current);
    const S asked = S(voltage(motor, duty, current, S(duty * bus - drop), back) + drop);
    return S(min(S(max(S(asked / bus), S(least))), S(most)));
  }
  /// voltage() for a winding without inductance: the current in A that flows at once, of the one
  /// that would without limits.
  template <class S>
  [[nodiscard]] S quasiStaticCurrent(const MotorConstants& motor, const S& duty, const S& free,
                                     const S& back) const {
    using std::max;
    using std::min;
    if (activeBraking) return S(min(S(max(free, S(-maxCurrent))), S(maxCurrent)));
    const double way = wayOf(duty);
    const S bottom = max(S(0), S(-way * back / (motor.resistance + resistance)));
    return S(way * max(S(min(S(way * free), S(maxCurrent))), bottom));
  }
  /// Without active braking a current against the duty, which the last step or a reversal left, is
  /// none.
  void settle(double duty, double& current) const {
    if (!activeBraking && wayOf(duty) * current < 0) current = 0;
  }

 private:
  template <class S>
  static double wayOf(const S& duty) {
    return valueOf(duty) < 0 ? -1 : 1;
  }
};

/// `motor` gives the other limit of the current.
EscConstants buildEsc(const EscParameters& parameters, const MotorConstants& motor);

template <>
struct Describe<EscParameters> {
  static void fields(schema::Builder<EscParameters>& b);
};

}  // namespace rotorbench
