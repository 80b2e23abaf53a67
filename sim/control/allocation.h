// Shares a demanded thrust and moments among the rotors. Linear in the rotor thrusts; the share of
// each axis is a column of the pseudo-inverse of the 4 x N effectiveness matrix, so count and
// geometry are free. Where rotors are at their limits: roll and pitch come first, then thrust, then
// yaw (Brescianini, D'Andrea, "Tilt-prioritized quadrocopter attitude control", IEEE TCST 2018).
#pragma once

#include <Eigen/Core>

#include "sim/control/control_model.h"
#include "sim/core/place.h"

namespace rotorbench {

/// Thrust along body z in N, moments about body x, y, z in N m.
using Wrench = Eigen::Vector4d;

class Allocation {
 public:
  /// Throws InputError, naming the layout below `vehicle`, if the rotors cannot produce thrust and
  /// the three moments independently.
  explicit Allocation(const ControlModel& model, const Place& vehicle = {});

  struct Result {
    PerRotor thrust = PerRotor::Zero();  ///< N per rotor, within 0..maximum
    Wrench achieved;                     ///< what these thrusts produce
    bool limited;                        ///< some demand was cut
  };
  [[nodiscard]] Result allocate(const Wrench& demand) const;

 private:
  [[nodiscard]] Wrench achievedBy(const PerRotor& thrust) const;

  int rotors_;
  Eigen::Matrix<double, 4, kMostRotors> effect_;
  Eigen::Matrix<double, kMostRotors, 4> share_;  ///< pseudo-inverse of effect_
  PerRotor maximum_ = PerRotor::Zero();
};

}  // namespace rotorbench
