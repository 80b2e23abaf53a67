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
#include "sim/control/controller.h"
#include "sim/control/motor_speed.h"
#include "sim/control/pid.h"
#include "sim/core/place.h"

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

class PidFlight final : public Controller {
 public:
  /// `timing` is that of parameters.rate. `vehicle` is where the layout is described.
  PidFlight(const PidFlightParameters& parameters, const ControlModel& model, Timing timing,
            const Place& vehicle = {});

  [[nodiscard]] std::vector<HeldQuantity> held() const override;
  [[nodiscard]] std::vector<Channel> channels() const override;
  void act(const ClockTick& tick, Board& board, double* row) override;

  /// Rotor speeds in rad/s for what is believed and wanted.
  const PerRotor& update(const BodyMotion& body, const SetPoint& setPoint);

  [[nodiscard]] const PerRotor& rotorSpeedSetPoints() const { return speeds_; }
  [[nodiscard]] const Wrench& wrench() const { return wrench_; }
  /// Some rotor thrust is at its limit and part of the demand is dropped.
  [[nodiscard]] bool limited() const { return limited_; }

 private:
  ControlModel model_;
  Allocation allocation_;
  Pid altitude_, roll_, pitch_, yaw_;
  AngleUnwrapper measuredYaw_, wantedYaw_;
  Wrench wrench_ = Wrench::Zero();
  bool limited_ = false;
  PerRotor speeds_ = PerRotor::Zero();
};

template <>
struct Describe<PidFlightParameters> {
  static void fields(schema::Builder<PidFlightParameters>& b);
};

}  // namespace rotorbench
