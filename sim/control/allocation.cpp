#include "sim/control/allocation.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

namespace rotorbench {

template <int N>
Allocation<N>::Allocation(const ControlModel<N>& model) : effect_(model.effect) {
  // Rows scaled to one, else thrust in N against moments in N m blurs the rank.
  const Eigen::Vector4d scale = effect_.rowwise().norm().cwiseMax(1e-300);
  const Eigen::Matrix<double, 4, N> scaled = scale.cwiseInverse().asDiagonal() * effect_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 4, N>> decomposition;
  decomposition.setThreshold(1e-9);
  decomposition.compute(scaled);
  if (decomposition.rank() < 4) {
    throw InputError("vehicle",
                     {{"layout", "the rotors cannot control all of thrust, roll, pitch and yaw",
                       "rotors around the centre with both spins and a drag torque"}});
  }
  share_ = decomposition.pseudoInverse() * scale.cwiseInverse().asDiagonal();
  for (int i = 0; i < N; ++i) maximum_[i] = model.maxThrust[static_cast<std::size_t>(i)];
}

template <int N>
typename Allocation<N>::Result Allocation<N>::allocate(const Wrench& demand) const {
  Result r;
  r.thrust = share_ * demand;
  if ((r.thrust.array() >= 0).all() && (r.thrust.array() <= maximum_.array()).all()) {
    r.achieved = demand;
    r.limited = false;
    return r;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // Roll and pitch, made smaller until a common thrust exists that keeps every rotor within its
  // limits.
  Thrusts tilt = share_.template middleCols<2>(1) * demand.template segment<2>(1);
  const Thrusts lift = share_.col(0);
  double part = 1;
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < N; ++k) {
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
  for (int i = 0; i < N; ++i) {
    if (lift[i] <= 0) continue;
    least = std::max(least, -tilt[i] / lift[i]);
    most = std::min(most, (maximum_[i] - tilt[i]) / lift[i]);
  }
  r.thrust = tilt + std::clamp(demand[0], least, std::max(least, most)) * lift;
  // Yaw takes what is left.
  const Thrusts twist = share_.col(3) * demand[3];
  double yaw = 1;
  for (int i = 0; i < N; ++i) {
    const double room = twist[i] > 0 ? maximum_[i] - r.thrust[i] : -r.thrust[i];
    if (twist[i] != 0) yaw = std::min(yaw, std::max(0.0, room / twist[i]));
  }
  r.thrust += yaw * twist;
  r.thrust = r.thrust.cwiseMax(0).cwiseMin(maximum_);
  r.achieved = effect_ * r.thrust;
  r.limited = true;
  return r;
}

template class Allocation<4>;

}  // namespace rotorbench
