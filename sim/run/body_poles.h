// The fastest poles that a vehicle's body has in the air: drag, angular damping, what rotors on
// their arms and spinning ones add; fast where mass or inertia is tiny.
#pragma once

#include "sim/vehicle/multirotor.h"

namespace rotorbench {

struct BodyPole {
  double magnitude = 0;  ///< 1/s; 0 where nothing decays
  bool turning = false;  ///< of the rotation rather than of the translation
};

/// About a level flight at `velocity`, m/s, and body rates, rad/s, at rotor speeds in rad/s, the
/// air still. N is 4, 6 or 8.
template <int N>
BodyPole fastestBodyPole(const MultirotorConstants<N>& vehicle, const Eigen::Vector3d& velocity,
                         const Eigen::Vector3d& rates, const Eigen::Matrix<double, N, 1>& speeds);

}  // namespace rotorbench
