// Controller 1 of the thesis (figures 4.2-4.3): PIDs for altitude, roll, pitch and yaw, allocation
// to rotor speeds, motor speed controllers. It holds height and attitude and lets the vehicle drift
// sideways. Altitude: acceleration demand a -> thrust m (g + a)/(cos roll cos pitch). Angles:
// angular acceleration demand alpha -> moment I alpha. SI units; angles in rad, roll+ moves to -y,
// pitch+ to +x.
//
// Default gains place the poles of the double integrator angle'' = u with integral action at one
// real pole -p and a pair (w, zeta): kd = 2 zeta w + p, kp = w^2 + 2 zeta w p, ki = w^2 p; the
// set-point weight ki/(p kp) cancels the real pole, so that a step answers like the pair alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sim/control/allocation.h"
#include "sim/control/control_model.h"
#include "sim/control/motor_speed.h"
#include "sim/control/pid.h"
#include "sim/core/channel.h"
#include "sim/sensing/measurement.h"

namespace rotorbench {

/// Gains by pole placement as above, in rad/s.
template <PidUse Use>
PidParameters<Use> pidForPoles(double pair, double damping, double real, double limit) {
  PidParameters<Use> p;
  // Four digits, as a person would enter them.
  const auto rounded = [](double gain) {
    const double scale = std::pow(10.0, 3 - std::floor(std::log10(gain)));
    return std::round(gain * scale) / scale;
  };
  p.kp = rounded(pair * pair + 2 * damping * pair * real);
  p.ki = rounded(pair * pair * real);
  p.kd = rounded(2 * damping * pair + real);
  p.setPointWeight = rounded(p.ki / (real * p.kp));
  p.limit = limit;
  return p;
}

struct PidFlightParameters {
  double rate = 500;  ///< Hz, of the altitude and attitude loops
  PidParameters<PidUse::Height> altitude = pidForPoles<PidUse::Height>(2, 0.9, 1.5, 6);
  PidParameters<PidUse::Angle> roll = pidForPoles<PidUse::Angle>(7, 0.8, 4, 100);
  PidParameters<PidUse::Angle> pitch = pidForPoles<PidUse::Angle>(7, 0.8, 4, 100);
  PidParameters<PidUse::Angle> yaw = pidForPoles<PidUse::Angle>(2, 0.9, 1.5, 10);
  MotorSpeedParameters motors;
  bool operator==(const PidFlightParameters&) const = default;
};

struct FlightSetPoint {
  double height = 0;  ///< m
  double roll = 0, pitch = 0,
         yaw = 0;  ///< rad; yaw may leave (-pi, pi], steps take the short way round
};

/// Follows an angle given in (-pi, pi] through whole turns.
class AngleUnwrapper {
 public:
  /// The angle nearest to the last one that differs from `angle` by whole turns.
  double operator()(double angle);
  void startAt(double angle) { last_ = angle, started_ = true; }
  [[nodiscard]] bool started() const { return started_; }

 private:
  double last_ = 0;
  bool started_ = false;
};

template <int N>
class PidFlightController {
 public:
  using Duties = Eigen::Matrix<double, N, 1>;

  /// `tick`: s between two calls of update(). Throws InputError if a rate does not fit it.
  PidFlightController(const PidFlightParameters& parameters, const ControlModel<N>& model,
                      double tick);

  /// Motor duties for this tick, -1..1 where a speed controller is reversible, else 0..1. Loops
  /// slower than the tick keep their last outputs.
  const Duties& update(const Measurement<N>& measured, const FlightSetPoint& setPoint);

  [[nodiscard]] const Duties& rotorSpeedSetPoints() const { return speeds_; }
  [[nodiscard]] const Wrench& wrench() const { return wrench_; }
  /// Some rotor thrust is at its limit and part of the demand is dropped.
  [[nodiscard]] bool limited() const { return limited_; }

  /// Calls visit(rotor, name, unit, description, value) for each recorded quantity; rotor 0 is the
  /// vehicle.
  template <class Visit>
  void visitOutputs(Visit&& visit) const {
    visit(0, "control.thrust", "N", "Total thrust demanded", wrench_[0]);
    visit(0, "control.momentX", "N*m", "Roll moment demanded", wrench_[1]);
    visit(0, "control.momentY", "N*m", "Pitch moment demanded", wrench_[2]);
    visit(0, "control.momentZ", "N*m", "Yaw moment demanded", wrench_[3]);
    visit(0, "control.limited", "1", "1 while the rotors cannot meet the demand",
          limited_ ? 1.0 : 0.0);
    for (int i = 0; i < N; ++i) {
      visit(i + 1, "speedSetpoint", "rad/s", "Rotor speed demanded", speeds_[i]);
    }
  }

 private:
  void updateFlight(const Measurement<N>& measured, const FlightSetPoint& setPoint);

  ControlModel<N> model_;
  Allocation<N> allocation_;
  Pid altitude_, roll_, pitch_, yaw_;
  std::vector<MotorSpeedController> motors_;
  AngleUnwrapper measuredYaw_, wantedYaw_;
  int flightTicks_, motorTicks_, flightCount_ = 0, motorCount_ = 0;
  Wrench wrench_ = Wrench::Zero();
  bool limited_ = false;
  Duties speeds_ = Duties::Zero(), duties_ = Duties::Zero();
};

template <>
struct Describe<PidFlightParameters> {
  static void fields(schema::Builder<PidFlightParameters>& b);
};

}  // namespace rotorbench
