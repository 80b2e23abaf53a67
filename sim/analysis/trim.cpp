#include "sim/analysis/trim.h"

#include <algorithm>
#include <cmath>

#include "sim/numerics/dual.h"
#include "sim/numerics/least_norm.h"

namespace rotorbench {

namespace {

constexpr int kNewtonSteps = 40;
constexpr double kConverged = 1e-12;  // accelerations over g
constexpr double kAccepted = 1e-7;    // where rounding or a table's kinks allow no better
constexpr double kLeastStep = 1e-3;   // of Newton's

/// The equations of steady flight over any scalar. Unknowns: rotor speeds over a scale, roll and
/// pitch.
template <int N>
class Balance {
 public:
  static constexpr int kUnknowns = N + 2;
  using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
  using Residual = Eigen::Matrix<double, 6, 1>;
  using Jacobian = Eigen::Matrix<double, 6, kUnknowns>;

  Balance(const MultirotorConstants<N>& vehicle, double speed, double scale)
      : plant_(stilled(vehicle)), speed_(speed), scale_(scale) {
    for (const RotorHub& hub : vehicle.hubs) arm_ = std::max(arm_, hub.arm.norm());
  }

  [[nodiscard]] Residual at(const Unknowns& x) const { return residual<double>(x); }

  /// The residual's derivatives by the unknowns.
  [[nodiscard]] Jacobian slopes(const Unknowns& x) const {
    Jacobian jacobian;
    Eigen::Matrix<Dual, kUnknowns, 1> seeded = x.template cast<Dual>();
    for (int column = 0; column < kUnknowns; ++column) {
      seeded[column] = Dual(x[column], 1);
      const auto r = residual<Dual>(seeded);
      for (int i = 0; i < 6; ++i) jacobian(i, column) = r[i].slope();
      seeded[column] = x[column];
    }
    return jacobian;
  }

  /// The forces of a solution into `trim`.
  void tell(const Unknowns& x, Trim& trim) const {
    typename Plant::State rate;
    MultirotorForces<N> forces;
    plant_.derivativeAndForces(0, state<double>(x), rate, forces);
    for (int i = 0; i < N; ++i) {
      trim.thrust[i] = forces.thrust[static_cast<std::size_t>(i)];
      trim.torque[i] = forces.torque[static_cast<std::size_t>(i)];
    }
  }

 private:
  using Plant = Multirotor<N, RotorDrive::PrescribedSpeeds>;
  using L = typename Plant::Layout;

  static MultirotorConstants<N> stilled(MultirotorConstants<N> vehicle) {
    vehicle.air.moving = vehicle.air.overHeight = false;
    return vehicle;
  }

  template <class S>
  [[nodiscard]] typename Plant::template StateOf<S> state(
      const Eigen::Matrix<S, kUnknowns, 1>& x) const {
    using std::cos;
    using std::sin;
    typename Plant::template StateOf<S> y;
    y.setConstant(S(0.0));
    const S cr = cos(S(0.5 * x[N])), sr = sin(S(0.5 * x[N]));
    const S cp = cos(S(0.5 * x[N + 1])), sp = sin(S(0.5 * x[N + 1]));
    y[L::kAttitude] = cp * cr;
    y[L::kAttitude + 1] = cp * sr;
    y[L::kAttitude + 2] = sp * cr;
    y[L::kAttitude + 3] = -sp * sr;
    y[L::kVelocity] = S(speed_);
    // The body does not turn: all angular momentum is the rotors'.
    for (int i = 0; i < N; ++i) {
      const S w = scale_ * x[i];
      y[L::kSpeed + i] = w;
      const Eigen::Vector3d& h = plant_.constants().hubs[static_cast<std::size_t>(i)].momentum;
      for (int k = 0; k < 3; ++k) y[L::kMomentum + k] += h[k] * w;
    }
    return y;
  }

  template <class S>
  [[nodiscard]] Eigen::Matrix<S, 6, 1> residual(const Eigen::Matrix<S, kUnknowns, 1>& x) const {
    const auto& c = plant_.constants();
    typename Plant::template CommandOf<S> none;
    none.setConstant(S(0.0));
    typename Plant::template StateOf<S> rate;
    plant_.template derivative<S>(0, none, state<S>(x), rate);
    Eigen::Matrix<S, 6, 1> r;
    for (int k = 0; k < 3; ++k) {
      r[k] = rate[L::kVelocity + k] / c.gravity;
      r[3 + k] = rate[L::kMomentum + k] / (c.mass * c.gravity * arm_);
    }
    return r;
  }

  Plant plant_;
  double speed_, scale_, arm_ = 0;
};

template <int N>
Trim startOf(const typename Multirotor<N>::Command& speeds) {
  Trim start;
  start.count = N;
  start.speeds.template head<N>() = speeds;
  return start;
}

/// Equal speeds that lift the weight, or nothing without lift.
template <int N>
std::optional<Trim> equalSpeeds(const MultirotorConstants<N>& vehicle) {
  const double density = vehicle.air.density(0.0);
  double lift = 0;
  for (const RotorHub& hub : vehicle.hubs) lift += density * hub.rotor.thrust * hub.axis.z();
  if (!(lift > 0)) return std::nullopt;
  using Command = typename Multirotor<N>::Command;
  return startOf<N>(Command::Constant(std::sqrt(vehicle.mass * vehicle.gravity / lift)));
}

}  // namespace

double Trim::tilt() const {
  return std::acos(std::clamp(std::cos(roll) * std::cos(pitch), -1.0, 1.0));
}

template <int N>
std::optional<Trim> trimmedFlight(const MultirotorConstants<N>& vehicle, double speed,
                                  const Trim& near) {
  // Weightless, any attitude balances.
  if (!(vehicle.gravity > 0)) return std::nullopt;
  const double scale = std::max(near.rotors().mean(), 1e-3);
  const Balance<N> balance(vehicle, speed, scale);
  typename Balance<N>::Unknowns x;
  x << near.speeds.template head<N>() / scale, near.roll, near.pitch;
  auto left = balance.at(x);
  bool moved = false;
  for (int k = 0; k < kNewtonSteps && !(left.cwiseAbs().maxCoeff() <= kConverged); ++k) {
    const typename Balance<N>::Unknowns step = leastNormSolution(balance.slopes(x), left);
    double share = 1;
    auto next = balance.at(x - step);
    while (!(next.norm() < left.norm()) && share > kLeastStep) {
      share /= 2;
      next = balance.at(x - share * step);
    }
    if (!(next.norm() < left.norm())) break;
    x -= share * step;
    left = next;
    moved = true;
  }
  const double worst = left.cwiseAbs().maxCoeff();
  if (!(worst <= kAccepted) || !(x.template head<N>().minCoeff() >= 0)) return std::nullopt;
  Trim trim;
  trim.count = N;
  trim.speed = speed;
  trim.roll = x[N];
  trim.pitch = x[N + 1];
  // What balances already keeps its last bit.
  trim.speeds.template head<N>() =
      moved ? typename Multirotor<N>::Command(scale * x.template head<N>())
            : typename Multirotor<N>::Command(near.speeds.template head<N>());
  trim.residual = worst * vehicle.gravity;
  balance.tell(x, trim);
  return trim;
}

template <int N>
std::optional<Trim> trimmedHover(const MultirotorConstants<N>& vehicle) {
  std::optional<Trim> start;
  try {
    start = startOf<N>(Multirotor<N>(vehicle).hoverSpeeds());
  } catch (const InputError&) {
    // Tilted rotors may still hold it at an angle.
    start = equalSpeeds(vehicle);
  }
  return start ? trimmedFlight(vehicle, 0, *start) : std::nullopt;
}

template <int N>
Trim hoverToStartIn(const MultirotorConstants<N>& vehicle) {
  if (const auto trim = trimmedHover(vehicle)) return *trim;
  return startOf<N>(Multirotor<N>(vehicle).hoverSpeeds());
}

template std::optional<Trim> trimmedFlight<4>(const MultirotorConstants<4>&, double, const Trim&);
template std::optional<Trim> trimmedHover<4>(const MultirotorConstants<4>&);
template Trim hoverToStartIn<4>(const MultirotorConstants<4>&);
template std::optional<Trim> trimmedFlight<6>(const MultirotorConstants<6>&, double, const Trim&);
template std::optional<Trim> trimmedHover<6>(const MultirotorConstants<6>&);
template Trim hoverToStartIn<6>(const MultirotorConstants<6>&);
template std::optional<Trim> trimmedFlight<8>(const MultirotorConstants<8>&, double, const Trim&);
template std::optional<Trim> trimmedHover<8>(const MultirotorConstants<8>&);
template Trim hoverToStartIn<8>(const MultirotorConstants<8>&);

}  // namespace rotorbench
