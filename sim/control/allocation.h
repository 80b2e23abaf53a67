// Shares a demanded thrust and moments among the rotors. Linear in the rotor thrusts; the share of
// each axis is a column of the pseudo-inverse of the 4 x N effectiveness matrix, so N and the
// geometry are free. Where rotors are at their limits: roll and pitch come first, then thrust, then
// yaw (Brescianini, D'Andrea, "Tilt-prioritized quadrocopter attitude control", IEEE TCST 2018).
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/control/control_model.h"

namespace rotorbench {

/// Thrust along body z in N, moments about body x, y, z in N m.
using Wrench = Eigen::Vector4d;

template <int N>
class Allocation {
 public:
  using Thrusts = Eigen::Matrix<double, N, 1>;

  /// Throws InputError if the rotors cannot produce thrust and the three moments independently.
  explicit Allocation(const ControlModel<N>& model);

  struct Result {
    Thrusts thrust;   ///< N per rotor, within 0..maximum
    Wrench achieved;  ///< what these thrusts produce
    bool limited;     ///< some demand was cut
  };
  [[nodiscard]] Result allocate(const Wrench& demand) const;

 private:
  Eigen::Matrix<double, 4, N> effect_;
  Eigen::Matrix<double, N, 4> share_;  ///< pseudo-inverse of effect_
  Thrusts maximum_;
};

}  // namespace rotorbench
