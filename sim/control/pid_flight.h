// Controller 1 of the thesis (figures 4.2-4.3): PIDs for altitude, roll, pitch and yaw, allocation
// to rotor speeds, motor speed controllers. It holds height and attitude and lets the vehicle drift
// sideways. Axes, units and signs: flight_axes.h.
#pragma once

#include <vector>

#include "sim/control/flight_axes.h"
#include "sim/control/pid.h"
#include "sim/control/pid_flight_parameters.h"

namespace rotorbench {

class PidFlight final : public Controller {
 public:
  /// `timing` is that of parameters.rate. `vehicle` is where the layout is described.
  PidFlight(const PidFlightParameters& parameters, const ControlModel& model, Timing timing,
            const Place& vehicle = {});

  [[nodiscard]] std::vector<HeldQuantity> held() const override { return FlightAxes::held(); }
  [[nodiscard]] std::vector<Channel> channels() const override { return axes_.channels(); }
  void act(const ClockTick& tick, Board& board, double* row) override;

  /// Other gains in the course of a flight, as BasicPid::retune(); the rate stays.
  void retune(const PidFlightParameters& parameters);

  /// Rotor speeds in rad/s for what is believed and wanted.
  const PerRotor& update(const BodyMotion& body, const SetPoint& setPoint);

  [[nodiscard]] const PerRotor& rotorSpeedSetPoints() const { return axes_.speeds(); }
  [[nodiscard]] const Wrench& wrench() const { return axes_.wrench(); }
  /// Some rotor thrust is at its limit and part of the demand is dropped.
  [[nodiscard]] bool limited() const { return axes_.limited(); }

 private:
  FlightAxes axes_;
  BasicPid<Lanes<4>> pid_;  ///< altitude, roll, pitch, yaw
};

}  // namespace rotorbench
