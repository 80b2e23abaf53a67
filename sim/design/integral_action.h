// A plant with an integrator behind each output, so that a state feedback designed for the whole
// holds the outputs at their set-points against constant disturbances.
#pragma once

#include <optional>

#include "sim/design/linear_system.h"

namespace rotorbench {

/// The plant with the states q, one for each output y (its set-point left out): q' = -y, or sampled
/// with `period` (s) q(k+1) = q(k) - period y(k). States x, then q; the outputs stay. A controller
/// adds the set-point r, q' = r - y, and u = -K [x; q]. Source: Franklin, Powell and Workman,
/// "Digital Control of Dynamic Systems" (1998), section 8.5. Throws an InputError where integrators
/// cannot be held: more outputs than inputs, or a zero of the plant at rest (s = 0, z = 1).
LinearSystem withIntegrators(const LinearSystem& plant, std::optional<double> period = {});

/// Gain of such a plant in its two parts: u = -state x - integral q.
struct IntegralGain {
  Eigen::MatrixXd state;     ///< m x n
  Eigen::MatrixXd integral;  ///< m x p
};
IntegralGain splitGain(const Eigen::MatrixXd& gain, Eigen::Index plantStates);

}  // namespace rotorbench
