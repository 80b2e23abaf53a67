#include "sim/control/allocation.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace rotorbench {

namespace {

/// Fills the pseudo-inverse of the first N columns; false if their rank is below four. Of fixed
/// size, so that the numbers of a count do not depend on there being other counts.
template <int N>
bool invert(const Eigen::Matrix<double, 4, kMostRotors>& all,
            Eigen::Matrix<double, kMostRotors, 4>& share) {
  using Effect = Eigen::Matrix<double, 4, N>;
  const Effect effect = all.leftCols<N>();
  // Rows scaled to one, else thrust in N against moments in N m blurs the rank.
  const Eigen::Vector4d scale = effect.rowwise().norm().cwiseMax(1e-300);
  const Effect scaled = scale.cwiseInverse().asDiagonal() * effect;
  Eigen::CompleteOrthogonalDecomposition<Effect> decomposition;
  decomposition.setThreshold(1e-9);
  decomposition.compute(scaled);
  if (decomposition.rank() < 4) return false;
  share.topRows<N>() = decomposition.pseudoInverse() * scale.cwiseInverse().asDiagonal();
  return true;
}

}  // namespace

Allocation::Allocation(const ControlModel& model, const Place& vehicle)
    : rotors_(model.rotors),
      effect_(model.effect),
      share_(Eigen::Matrix<double, kMostRotors, 4>::Zero()) {
  const bool controllable = rotors_ == 4   ? invert<4>(effect_, share_)
                            : rotors_ == 6 ? invert<6>(effect_, share_)
                                           : invert<8>(effect_, share_);
  if (!controllable) {
    throw vehicle.error({{"layout", "the rotors cannot control all of thrust, roll, pitch and yaw",
                          "rotors around the centre with both spins and a drag torque"}});
  }
  for (int i = 0; i < rotors_; ++i) maximum_[i] = model.maxThrust[static_cast<std::size_t>(i)];
}

Wrench Allocation::achievedBy(const PerRotor& thrust) const {
  Wrench sum = effect_.col(0) * thrust[0];
  for (int i = 1; i < rotors_; ++i) sum += effect_.col(i) * thrust[i];
  return sum;
}

Allocation::Result Allocation::allocate(const Wrench& demand) const {
  Result r;
  r.thrust = share_.col(0) * demand[0];
  for (int k = 1; k < 4; ++k) r.thrust += share_.col(k) * demand[k];
  if ((r.thrust.array() >= 0).all() && (r.thrust.array() <= maximum_.array()).all()) {
    r.achieved = demand;
    r.limited = false;
    return r;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // Roll and pitch, made smaller until a common thrust exists that keeps every rotor within its
  // limits.
  PerRotor tilt = share_.col(1) * demand[1] + share_.col(2) * demand[2];
  const PerRotor lift = share_.col(0);
  double part = 1;
  for (int i = 0; i < rotors_; ++i) {
    for (int k = 0; k < rotors_; ++k) {
      // tilt_i + t lift_i >= 0 and tilt_k + t lift_k <= maximum_k leave a t only if this gap is not
      // negative.
      if (lift[i] <= 0 || lift[k] <= 0) continue;
      const double need = tilt[k] / lift[k] - tilt[i] / lift[i];
      const double room = maximum_[k] / lift[k];
      if (need > room) part = std::min(part, room / need);
    }
  }
  tilt *= part;
  double least = 0, most = kInfinity;
  for (int i = 0; i < rotors_; ++i) {
    if (lift[i] <= 0) continue;
    least = std::max(least, -tilt[i] / lift[i]);
    most = std::min(most, (maximum_[i] - tilt[i]) / lift[i]);
  }
  r.thrust = tilt + std::clamp(demand[0], least, std::max(least, most)) * lift;
  // Yaw takes what is left.
  const PerRotor twist = share_.col(3) * demand[3];
  double yaw = 1;
  for (int i = 0; i < rotors_; ++i) {
    const double room = twist[i] > 0 ? maximum_[i] - r.thrust[i] : -r.thrust[i];
    if (twist[i] != 0) yaw = std::min(yaw, std::max(0.0, room / twist[i]));
  }
  r.thrust += yaw * twist;
  r.thrust = r.thrust.cwiseMax(0).cwiseMin(maximum_);
  r.achieved = achievedBy(r.thrust);
  r.limited = true;
  return r;
}

}  // namespace rotorbench
