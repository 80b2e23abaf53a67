// Speed control of one motor (thesis 2014, figures 4.7-4.9): PID on the rotor speed, feed-forward
// of the steady voltage, voltage and current limits. The PID demands a rotor acceleration; inertia
// and torque constant turn it into a voltage, so its gains carry over between motors.
#pragma once

#include <algorithm>
#include <limits>

#include "sim/control/pid.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

struct MotorSpeedParameters {
  double rate = 1000;  ///< Hz
  PidParameters<PidUse::RotorSpeed> pid{
      .kp = 60,
      .ki = 300,
      .setPointWeight = 1,
      .filterTime = 0.005,
      .trackingTime = 0.2,  // kp/ki: leaves what P asks in vain alone
      .limit = 1e5};
  bool feedForward = true;
  bool operator==(const MotorSpeedParameters&) const = default;
};

class MotorSpeedController {
 public:
  /// `motor` with the resistance of its speed controller `esc`, which says how the motor may be
  /// slowed. `limited` false: no limit of voltage, current or demand, as if the drive could do
  /// anything.
  MotorSpeedController(const MotorSpeedParameters& parameters, const MotorConstants& motor,
                       const EscConstants& esc, double rotorInertia, double torqueFactor,
                       bool limited = true)
      : pid_(limited ? parameters.pid : withoutLimit(parameters.pid), 1 / parameters.rate),
        motor_(motor),
        esc_(esc),
        torqueFactor_(torqueFactor),
        voltsPerAcceleration_(rotorInertia * motor.resistance / motor.torqueConstant),
        feedForward_(parameters.feedForward),
        limited_(limited) {}

  /// Terminal voltage in V for a set-point and measured speed in rad/s and the measured bus voltage
  /// in V. Within 0..bus, or -bus..bus where the speed controller is reversible, and, as far as
  /// these allow, the band around K_b w that keeps the current within its limit; not below K_b w
  /// where it does not brake.
  double update(double setPoint, double speed, double bus) {
    const double acceleration = pid_.propose(setPoint, speed);
    double wanted = voltsPerAcceleration_ * acceleration;
    if (feedForward_) {
      wanted += motor_.steadyVoltage(
          setPoint, motor_.steadyCurrent(setPoint, torqueFactor_ * setPoint * setPoint));
    }
    const double back = motor_.torqueConstant * speed, band = motor_.resistance * motor_.maxCurrent;
    const double least = esc_.least * bus;
    const double high = std::clamp(back + band, least, bus);
    const double low = std::clamp(esc_.activeBraking ? back - band : back, least, high);
    const double voltage = limited_ ? std::clamp(wanted, low, high) : wanted;
    pid_.accept(acceleration + (voltage - wanted) / voltsPerAcceleration_);
    return voltage;
  }

  /// Integral part of the demand, rad/s^2.
  [[nodiscard]] double integral() const { return pid_.integral(); }

 private:
  using Parameters = PidParameters<PidUse::RotorSpeed>;
  static Parameters withoutLimit(Parameters pid) {
    pid.limit = std::numeric_limits<double>::infinity();
    return pid;
  }

  Pid pid_;
  MotorConstants motor_;
  EscConstants esc_;
  double torqueFactor_, voltsPerAcceleration_;
  bool feedForward_, limited_;
};

template <>
struct Describe<MotorSpeedParameters> {
  static void fields(schema::Builder<MotorSpeedParameters>& b);
};

}  // namespace rotorbench
