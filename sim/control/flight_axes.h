// What the controllers of height and attitude share: they see four axes, height, roll, pitch and
// yaw, each a double integrator of an acceleration they demand, and what they demand is carried out
// by the rotors as far as these can. Height: acceleration a -> thrust m (g + a)/(cos roll cos
// pitch). Angles: angular acceleration alpha -> moment I alpha. SI units; angles in rad, roll+
// moves to -y, pitch+ to +x.
#pragma once

#include <vector>

#include "sim/control/allocation.h"
#include "sim/control/control_model.h"
#include "sim/control/controller.h"
#include "sim/control/lanes.h"
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

class FlightAxes {
 public:
  using Axes = Lanes<4>;  ///< height (m), roll, pitch, yaw (rad)

  /// `vehicle` is where the layout is described. Throws InputError as Allocation does.
  FlightAxes(const ControlModel& model, const Place& vehicle);

  [[nodiscard]] static std::vector<HeldQuantity> held();
  [[nodiscard]] std::vector<Channel> channels() const;
  void row(double* out) const;

  struct Seen {
    Axes wanted, measured;
    Axes rates;   ///< m/s and body rates, rad/s
    double lift;  ///< cosine of the tilt, held above that of 60 degrees
  };
  Seen see(const BodyMotion& body, const SetPoint& setPoint);

  /// Rotor speeds for these accelerations, m/s^2 and rad/s^2; `demand` becomes what the rotors can
  /// give of it.
  void carryOut(double lift, Axes& demand);

  [[nodiscard]] const PerRotor& speeds() const { return speeds_; }  ///< rad/s
  [[nodiscard]] const Wrench& wrench() const { return wrench_; }
  /// Some rotor thrust is at its limit and part of the demand is dropped.
  [[nodiscard]] bool limited() const { return limited_; }

 private:
  ControlModel model_;
  Allocation allocation_;
  AngleUnwrapper measuredYaw_, wantedYaw_;
  Wrench wrench_ = Wrench::Zero();
  bool limited_ = false;
  PerRotor speeds_ = PerRotor::Zero();
};

}  // namespace rotorbench
