// The right-hand side of Multirotor. Include multirotor.h, not this.
#pragma once

#include "sim/vehicle/multirotor.h"

namespace rotorbench {

namespace detail {

/// Rotation matrix of a unit quaternion [w x y z], row by row.
template <class S>
struct Rotation {
  S xx, xy, xz, yx, yy, yz, zx, zy, zz;
  Rotation(const S& w, const S& x, const S& y, const S& z) {
    xx = 1.0 - 2.0 * (y * y + z * z), xy = 2.0 * (x * y - w * z), xz = 2.0 * (x * z + w * y);
    yx = 2.0 * (x * y + w * z), yy = 1.0 - 2.0 * (x * x + z * z), yz = 2.0 * (y * z - w * x);
    zx = 2.0 * (x * z - w * y), zy = 2.0 * (y * z + w * x), zz = 1.0 - 2.0 * (x * x + y * y);
  }
};

/// Keeps the slope of |v| defined at rest; far below any air speed that matters.
inline constexpr double kSmallSpeedSquared = 1e-12;  // m^2/s^2

}  // namespace detail

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] typename Multirotor<N, Drive>::template LoadOf<S>
Multirotor<N, Drive>::mixedLoads(const LanesOf<S>& speed,
                                 const std::array<LanesOf<S>, 3>& hubVelocity,
                                 const S& density) const {
  using Vector = Eigen::Matrix<S, 3, 1>;
  LoadOf<S> all;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    const Vector v(hubVelocity[0][i], hubVelocity[1][i], hubVelocity[2][i]);
    const RotorLoad<S> one =
        hub.rotor.model != nullptr
            ? hub.rotor.model->template load<S>(speed[i], v, hub.axis, hub.spin, density)
            : hub.rotor.template load<S, Vector>(speed[i], v, hub.axis, hub.spin, density);
    for (int k = 0; k < 3; ++k) {
      all.force[static_cast<std::size_t>(k)][i] = one.force[k];
      all.moment[static_cast<std::size_t>(k)][i] = one.moment[k];
    }
    all.thrust[i] = one.thrust;
    all.torque[i] = one.torque;
  }
  return all;
}

template <int N, RotorDrive Drive>
template <class S>
inline typename Multirotor<N, Drive>::template Electrical<S> Multirotor<N, Drive>::electrical(
    const CommandOf<S>& command, const StateOf<S>& y) const {
  using Lanes = LanesOf<S>;
  const auto& lanes = constants_.lanes;
  const Lanes current = y.template segment<N>(Layout::kCurrent).array();
  const Lanes speed = y.template segment<N>(Layout::kSpeed).array();
  const Lanes commanded = command.array(), follows = y.template segment<N>(Layout::kDuty).array();
  const S inner = openCircuit(y) - y[Layout::kPolarisation];
  Electrical<S> at;
  at.duty = lanes.duty.duty(commanded, follows);
  at.supplyCurrent = Lanes(at.duty * current).sum();
  at.bus = inner - constants_.supply.resistance * at.supplyCurrent;
  const Lanes back = lanes.motor.torqueConstant * speed;
  at.voltage = at.duty * at.bus - lanes.escResistance * current;
  const Lanes excess = at.voltage - back;
  if (someLimit(excess)) limitVoltages(current, back, inner, at);
  return at;
}

template <int N, RotorDrive Drive>
template <class S>
inline bool Multirotor<N, Drive>::someLimit(const LanesOf<S>& excess) const {
  const auto& least = constants_.lanes.leastExcess;
  const auto& most = constants_.lanes.mostExcess;
  if constexpr (std::is_same_v<S, double>) {
    return (excess < least || excess > most).any();
  } else {
    for (int i = 0; i < N; ++i) {
      if (valueOf(excess[i]) < least[i] || valueOf(excess[i]) > most[i]) return true;
    }
    return false;
  }
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] void Multirotor<N, Drive>::limitVoltages(const LanesOf<S>& current,
                                                           const LanesOf<S>& back, const S& inner,
                                                           Electrical<S>& at) const {
  using std::max;
  using std::sqrt;
  using Lanes = LanesOf<S>;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    at.voltage[i] =
        hub.esc.voltage(hub.motor, S(at.duty[i]), S(current[i]), S(at.voltage[i]), S(back[i]));
  }
  // The converters keep the power, and the bus follows from the one that is drawn: b (inner -
  // b)/R_0 = P, the upper root being the stable one.
  const S power = Lanes((at.voltage + constants_.lanes.escResistance * current) * current).sum();
  const S root = inner * inner - 4.0 * constants_.supply.resistance * power;
  at.bus = 0.5 * (inner + sqrt(max(root, S(0.0))));
  at.supplyCurrent = power / at.bus;
}

template <int N, RotorDrive Drive>
template <class S, class Sink>
inline void Multirotor<N, Drive>::evaluate(const CommandOf<S>& command, const StateOf<S>& y,
                                           StateOf<S>& dydt, Sink&& sink) const {
  using std::sqrt;
  using L = Layout;
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Lanes = LanesOf<S>;
  const Constants& c = constants_;

  const S qw = y[L::kAttitude], qx = y[L::kAttitude + 1], qy = y[L::kAttitude + 2],
          qz = y[L::kAttitude + 3];
  const detail::Rotation<S> r(qw, qx, qy, qz);
  const S vx = y[L::kVelocity], vy = y[L::kVelocity + 1], vz = y[L::kVelocity + 2];
  const Vector w = bodyRates(y);
  // Velocity of the centre of mass against the air, in body axes.
  Vector v;
  v[0] = r.xx * vx + r.yx * vy + r.zx * vz;
  v[1] = r.xy * vx + r.yy * vy + r.zy * vz;
  v[2] = r.xz * vx + r.yz * vy + r.zz * vz;
  const S density = c.air.density(y[L::kPosition + 2]);

  const S airSpeed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + detail::kSmallSpeedSquared);
  Vector force, moment;
  for (int k = 0; k < 3; ++k) {
    force[k] = -(c.drag.linear + c.drag.quadratic[k] * airSpeed) * v[k];
    moment[k] = -c.drag.angular[k] * w[k];
  }

  const auto& lanes = c.lanes;
  const Lanes speed = y.template segment<N>(L::kSpeed).array();
  std::array<Lanes, 3> hubVelocity;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const auto axis = static_cast<int>(k);
    hubVelocity[k] =
        v[axis] + (w[(axis + 1) % 3] * lanes.arm[b] - w[(axis + 2) % 3] * lanes.arm[a]);
  }
  Lanes thrust, torque;
  const auto add = [&](const LoadOf<S>& load) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const Lanes turning =
          load.moment[k] + (lanes.arm[a] * load.force[b] - lanes.arm[b] * load.force[a]);
      force[static_cast<int>(k)] += load.force[k].sum();
      moment[static_cast<int>(k)] += turning.sum();
    }
    thrust = load.thrust;
    torque = load.torque;
  };
  if (c.lumped) {
    add(lanes.rotor.load(speed, hubVelocity, lanes.axis, lanes.spin, density));
  } else {
    add(mixedLoads<S>(speed, hubVelocity, density));
  }

  const Lanes zero = Lanes::Constant(S(0.0));
  Electrical<S> at{zero, zero, S(c.openCircuit), S(0.0)};
  auto dutyRate = dydt.template segment<N>(L::kDuty).array();
  auto speedRate = dydt.template segment<N>(L::kSpeed).array();
  auto currentRate = dydt.template segment<N>(L::kCurrent).array();
  if constexpr (Drive == RotorDrive::Motors) {
    const Lanes current = y.template segment<N>(L::kCurrent).array();
    const Lanes commanded = command.array(), follows = y.template segment<N>(L::kDuty).array();
    at = electrical<S>(command, y);
    dutyRate = lanes.duty.rate(commanded, follows);
    speedRate = (lanes.motor.torqueConstant * current - lanes.motor.friction(speed) - torque) *
                lanes.inverseInertia;
    currentRate = lanes.motor.currentRate(at.voltage, current, speed);
  } else {
    speedRate = command.array();
    currentRate = zero;
    dutyRate = zero;
  }

  dydt[L::kAttitude] = -0.5 * (qx * w[0] + qy * w[1] + qz * w[2]);
  dydt[L::kAttitude + 1] = 0.5 * (qw * w[0] + qy * w[2] - qz * w[1]);
  dydt[L::kAttitude + 2] = 0.5 * (qw * w[1] + qz * w[0] - qx * w[2]);
  dydt[L::kAttitude + 3] = 0.5 * (qw * w[2] + qx * w[1] - qy * w[0]);
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    dydt[L::kMomentum + k] = moment[k] - (w[a] * y[L::kMomentum + b] - w[b] * y[L::kMomentum + a]);
    force[k] *= c.inverseMass;
    dydt[L::kPosition + k] = y[L::kVelocity + k];
  }
  dydt[L::kVelocity] = r.xx * force[0] + r.xy * force[1] + r.xz * force[2];
  dydt[L::kVelocity + 1] = r.yx * force[0] + r.yy * force[1] + r.yz * force[2];
  dydt[L::kVelocity + 2] = r.zx * force[0] + r.zy * force[1] + r.zz * force[2] - c.gravity;
  dydt[L::kCharge] = at.supplyCurrent;
  dydt[L::kPolarisation] = (c.supply.polarisation * at.supplyCurrent - y[L::kPolarisation]) *
                           c.supply.inversePolarisationTime;
  dydt[L::kEnergy] = at.bus * at.supplyCurrent;
  sink(thrust, torque, at.duty, at.voltage, w, force, at.bus, at.supplyCurrent);
}

}  // namespace rotorbench
