#include "sim/run/body_poles.h"

#include <Eigen/Eigenvalues>

namespace rotorbench {

namespace {

/// Of velocity in m/s and rates in rad/s: small beside any that matter, large beside rounding.
constexpr double kStep = 1e-3;

template <int N>
class Body {
 public:
  using Motion = Eigen::Matrix<double, 6, 1>;  // velocity and rates
  using Speeds = Eigen::Matrix<double, N, 1>;

  Body(const MultirotorConstants<N>& vehicle, const Speeds& speeds)
      : plant_(stilled(vehicle)), speeds_(speeds) {}

  [[nodiscard]] Motion rateOf(const Motion& motion) const {
    typename Plant::State y = Plant::State::Zero(), rate;
    y[L::kAttitude] = 1;
    Plant::setRotorSpeeds(y, speeds_);
    y.template segment<3>(L::kVelocity) = motion.template head<3>();
    plant_.setBodyRates(y, motion.template tail<3>());
    plant_(0, y, rate);
    Motion result;
    result << rate.template segment<3>(L::kVelocity),
        plant_.constants().inverseInertia * rate.template segment<3>(L::kMomentum);
    return result;
  }

  [[nodiscard]] Eigen::Matrix<double, 6, 6> slopes(const Motion& motion) const {
    Eigen::Matrix<double, 6, 6> jacobian;
    for (int k = 0; k < 6; ++k) {
      const Motion step = kStep * Motion::Unit(k);
      jacobian.col(k) = (rateOf(motion + step) - rateOf(motion - step)) / (2 * kStep);
    }
    return jacobian;
  }

 private:
  using Plant = Multirotor<N, RotorDrive::PrescribedSpeeds>;
  using L = typename Plant::Layout;
  static MultirotorConstants<N> stilled(MultirotorConstants<N> vehicle) {
    vehicle.air.moving = vehicle.air.overHeight = false;
    return vehicle;
  }
  Plant plant_;
  Speeds speeds_;
};

/// Largest magnitude of the eigenvalues that do not grow.
template <class Matrix>
double fastest(const Matrix& jacobian) {
  if (!jacobian.allFinite()) return 0;
  double most = 0;
  for (const auto& pole : jacobian.eigenvalues())
    if (pole.real() <= 1e-9 * std::abs(pole)) most = std::max(most, std::abs(pole));
  return most;
}

}  // namespace

template <int N>
BodyPole fastestBodyPole(const MultirotorConstants<N>& vehicle, const Eigen::Vector3d& velocity,
                         const Eigen::Vector3d& rates, const Eigen::Matrix<double, N, 1>& speeds) {
  typename Body<N>::Motion motion;
  motion << velocity, rates;
  const Eigen::Matrix<double, 6, 6> jacobian = Body<N>(vehicle, speeds).slopes(motion);
  const Eigen::Matrix3d moving = jacobian.topLeftCorner<3, 3>();
  const Eigen::Matrix3d turning = jacobian.bottomRightCorner<3, 3>();
  return {fastest(jacobian), fastest(turning) > fastest(moving)};
}

template BodyPole fastestBodyPole<4>(const MultirotorConstants<4>&, const Eigen::Vector3d&,
                                     const Eigen::Vector3d&, const Eigen::Matrix<double, 4, 1>&);
template BodyPole fastestBodyPole<6>(const MultirotorConstants<6>&, const Eigen::Vector3d&,
                                     const Eigen::Vector3d&, const Eigen::Matrix<double, 6, 1>&);
template BodyPole fastestBodyPole<8>(const MultirotorConstants<8>&, const Eigen::Vector3d&,
                                     const Eigen::Vector3d&, const Eigen::Matrix<double, 8, 1>&);

}  // namespace rotorbench
