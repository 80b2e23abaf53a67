// Speed control of motors (thesis 2014, figures 4.7-4.9): PID on the rotor speed, feed-forward of
// the steady voltage, voltage and current limits. The PID demands a rotor acceleration; inertia and
// torque constant turn it into a voltage, so its gains carry over between motors.
#pragma once

#include <array>
#include <limits>

#include "sim/control/motor_speed_parameters.h"
#include "sim/control/pid.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

/// What one controller knows of its motor.
struct ControlledMotor {
  MotorConstants motor;     ///< with the resistance of its speed controller
  EscConstants esc;         ///< says how the motor may be slowed
  double inertia = 0;       ///< kg m^2, of the rotor
  double torqueFactor = 0;  ///< N m s^2
};

/// One controller (Real is double) or one for each of several motors (an Eigen::Array).
template <class Real>
class BasicMotorSpeedController {
 public:
  /// `limited` false: no limit of voltage, current or demand, as if the drive could do anything.
  BasicMotorSpeedController(const MotorSpeedParameters& p, const ControlledMotor& m,
                            bool limited = true)
      : pid_(gainsOf(p, limited)), feedForward_(p.feedForward), limited_(limited) {
    take(m, [](Real& to) -> double& { return to; });
  }
  /// Motor i is lane i.
  template <std::size_t N>
  BasicMotorSpeedController(const MotorSpeedParameters& p, const std::array<ControlledMotor, N>& m)
      : pid_(alike<N>(gainsOf(p, true))), feedForward_(p.feedForward), limited_(true) {
    for (std::size_t i = 0; i < N; ++i)
      take(m[i], [i](Real& to) -> double& { return to[static_cast<int>(i)]; });
  }

  /// Terminal voltage in V for a set-point and measured speed in rad/s and the measured bus voltage
  /// in V. Within 0..bus, or -bus..bus where the speed controller is reversible, and, as far as
  /// these allow, the band around K_b w that keeps the current within its limit; not below K_b w
  /// where it does not brake.
  Real update(const Real& setPoint, const Real& speed, double bus) {
    const Real acceleration = pid_.propose(setPoint, speed);
    Real wanted = voltsPerAcceleration_ * acceleration;
    if (feedForward_) wanted += steadyVoltage(setPoint);
    Real voltage = wanted;
    if (limited_) {
      const Real back = motor_.torqueConstant * speed;
      const Real least = least_ * bus, most = allLanes<Real>(bus);
      const Real high = clamped(Real(back + drive_), least, most);
      const Real low = clamped(Real(back - brake_), least, high);
      voltage = clamped(wanted, low, high);
    }
    pid_.accept(acceleration + (voltage - wanted) / voltsPerAcceleration_);
    return voltage;
  }

  /// Other gains in the course of a flight, as BasicPid::retune(); for several motors, the same for
  /// all. Rate and feed-forward stay.
  void retune(const MotorSpeedParameters& p) {
    const PidGains<double> one = gainsOf(p, limited_);
    if constexpr (std::is_same_v<Real, double>) {
      pid_.retune(one);
    } else {
      pid_.retune(alike<static_cast<std::size_t>(Real::RowsAtCompileTime)>(one));
    }
  }

  /// Integral part of the demand, rad/s^2.
  [[nodiscard]] const Real& integral() const { return pid_.integral(); }

 private:
  static PidGains<double> gainsOf(const MotorSpeedParameters& p, bool limited) {
    PidGains<double> g = pidGains(p.pid, 1 / p.rate);
    if (!limited) g.limit = std::numeric_limits<double>::infinity();
    return g;
  }
  template <std::size_t N>
  static PidGains<Real> alike(const PidGains<double>& one) {
    std::array<PidGains<double>, N> all;
    all.fill(one);
    return besides<static_cast<int>(N)>(all);
  }
  template <class Lane>
  void take(const ControlledMotor& m, const Lane& lane) {
    lane(motor_.torqueConstant) = m.motor.torqueConstant;
    lane(motor_.resistance) = m.motor.resistance;
    lane(motor_.viscousFriction) = m.motor.viscousFriction;
    lane(motor_.dryFriction) = m.motor.dryFriction;
    lane(torqueFactor_) = m.torqueFactor;
    lane(voltsPerAcceleration_) = m.inertia * m.motor.resistance / m.motor.torqueConstant;
    lane(drive_) = m.motor.resistance * m.motor.maxCurrent;
    lane(brake_) = m.esc.activeBraking ? lane(drive_) : 0;
    lane(least_) = m.esc.least;
  }

  /// V that the set-point needs; it often stays for several updates.
  const Real& steadyVoltage(const Real& setPoint) {
    if (differ(setPoint, steadySpeed_)) {
      steadySpeed_ = setPoint;
      const Real torque = torqueFactor_ * setPoint * setPoint;
      steadyVoltage_ = motor_.steadyVoltage(setPoint, motor_.steadyCurrent(setPoint, torque));
    }
    return steadyVoltage_;
  }

  BasicPid<Real> pid_;
  MotorModel<Real> motor_;
  Real torqueFactor_{}, voltsPerAcceleration_{};
  Real drive_{}, brake_{};  ///< V from the back-EMF at the largest current
  Real least_{};            ///< duty
  bool feedForward_, limited_;
  Real steadySpeed_ = allLanes<Real>(std::numeric_limits<double>::quiet_NaN()), steadyVoltage_{};
};

using MotorSpeedController = BasicMotorSpeedController<double>;

}  // namespace rotorbench
