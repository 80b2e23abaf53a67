// Controller 1 of the thesis (figures 4.2-4.3): PIDs for altitude, roll, pitch and yaw, allocation
// to rotor speeds, motor speed controllers. It holds height and attitude and lets the vehicle drift
// sideways. Altitude: acceleration demand a -> thrust m (g + a)/(cos roll cos pitch). Angles:
// angular acceleration demand alpha -> moment I alpha. SI units; angles in rad, roll+ moves to -y,
// pitch+ to +x.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "sim/control/allocation.h"
#include "sim/control/control_model.h"
#include "sim/control/controller.h"
#include "sim/control/pid.h"
#include "sim/control/pid_flight_parameters.h"
#include "sim/core/place.h"

namespace rotorbench {

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

  /// Other gains in the course of a flight, as BasicPid::retune(); the rate stays.
  void retune(const PidFlightParameters& parameters);

  /// Rotor speeds in rad/s for what is believed and wanted.
  const PerRotor& update(const BodyMotion& body, const SetPoint& setPoint);

  [[nodiscard]] const PerRotor& rotorSpeedSetPoints() const { return speeds_; }
  [[nodiscard]] const Wrench& wrench() const { return wrench_; }
  /// Some rotor thrust is at its limit and part of the demand is dropped.
  [[nodiscard]] bool limited() const { return limited_; }

 private:
  ControlModel model_;
  Allocation allocation_;
  BasicPid<Lanes<4>> pid_;  ///< altitude, roll, pitch, yaw
  AngleUnwrapper measuredYaw_, wantedYaw_;
  Wrench wrench_ = Wrench::Zero();
  bool limited_ = false;
  PerRotor speeds_ = PerRotor::Zero();
};

}  // namespace rotorbench
