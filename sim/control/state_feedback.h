// Controller 2 of the thesis (figures 4.4-4.6) and its linear-quadratic sister: height, roll, pitch
// and yaw by state feedback. Position and rate of each axis are measured; where the design has a
// lag of the thrust, the acceleration is that of the same model, driven by what the rotors could
// carry out. Gains: axis_design.h. Axes, units and signs: flight_axes.h.
#pragma once

#include <vector>

#include "sim/control/axis_design.h"
#include "sim/control/flight_axes.h"
#include "sim/control/state_feedback_parameters.h"

namespace rotorbench {

class StateFeedback final : public Controller {
 public:
  /// `timing` is that of the parameters' rate. Throws InputError where the gains cannot be placed.
  StateFeedback(const StateFeedbackParameters& parameters, const ControlModel& model, Timing timing,
                const Place& vehicle = {});
  StateFeedback(const LqrParameters& parameters, const ControlModel& model, Timing timing,
                const Place& vehicle = {});

  [[nodiscard]] std::vector<HeldQuantity> held() const override { return FlightAxes::held(); }
  [[nodiscard]] std::vector<Channel> channels() const override { return axes_.channels(); }
  void act(const ClockTick& tick, Board& board, double* row) override;

  /// Other gains in the course of a flight: what they change of the demand the integral takes up,
  /// where there is one. The rate stays.
  void retune(const StateFeedbackParameters& parameters);
  void retune(const LqrParameters& parameters);

  /// Rotor speeds in rad/s for what is believed and wanted.
  const PerRotor& update(const BodyMotion& body, const SetPoint& setPoint);

  /// Height, roll, pitch, yaw.
  struct Gains {
    Lanes<4> position, rate, acceleration, reference, integral, bleeding;
    Lanes<4> limit;      ///< infinite where there is none
    Lanes<4> following;  ///< part of a demand that the thrust has not reached after an update
  };
  [[nodiscard]] const Gains& gains() const { return gains_; }
  [[nodiscard]] const Wrench& wrench() const { return axes_.wrench(); }
  [[nodiscard]] bool limited() const { return axes_.limited(); }

 private:
  void take(const Gains& gains);

  FlightAxes axes_;
  Gains gains_;
  Lanes<4> integral_ = Lanes<4>::Zero(), acceleration_ = Lanes<4>::Zero();
  Lanes<4> origin_ = Lanes<4>::Zero();
  FlightAxes::Seen seen_{};  ///< last
  bool started_ = false;
};

}  // namespace rotorbench
