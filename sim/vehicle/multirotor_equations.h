// The right-hand side of Multirotor. Include multirotor.h, not this.
#pragma once

#include "sim/vehicle/multirotor.h"

namespace rotorbench {

// The parts of the right-hand side are one function to the compiler, so that what one works out
// stays in registers for the next.

namespace detail {

/// Keeps the slope of |v| defined at rest; far below any air speed that matters.
inline constexpr double kSmallSpeedSquared = 1e-12;  // m^2/s^2

}  // namespace detail

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] typename Multirotor<N, Drive>::template LoadOf<S>
Multirotor<N, Drive>::mixedLoads(const LanesOf<S>& speed,
                                 const std::array<LanesOf<S>, 3>& hubVelocity,
                                 const LanesOf<S>& density) const {
  using Vector = Eigen::Matrix<S, 3, 1>;
  LoadOf<S> all;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    const Vector v(hubVelocity[0][i], hubVelocity[1][i], hubVelocity[2][i]);
    const RotorLoad<S> one =
        hub.rotor.model != nullptr
            ? hub.rotor.model->template load<S>(speed[i], v, hub.axis, hub.spin, density[i])
            : hub.rotor.template load<S, Vector>(speed[i], v, hub.axis, hub.spin, density[i]);
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
  if (valueOf(at.bus) < 0) [[unlikely]]
    collapse(inner, at);
  // What the motors leave of the supply is all that the avionics can draw from: a constant power,
  // or where there is less the most there is.
  if (constants_.avionicsPower > 0 && valueOf(at.bus) > 0) {
    const S left = at.bus, avionics(constants_.avionicsPower);
    const double r = constants_.supply.resistance;
    at.bus = busVoltage<S>(left, avionics, r);
    const bool all = busReserve(valueOf(left), constants_.avionicsPower, r) >= 0;
    at.supplyCurrent = at.supplyCurrent + (all ? S(avionics / at.bus) : S((left - at.bus) / r));
  }
  const Lanes back = lanes.motor.torqueConstant * speed;
  at.voltage = at.duty * at.bus - lanes.escResistance * current;
  if (constants_.lossy) [[unlikely]] {
    addLosses(current, back, inner, at);
    return at;
  }
  const Lanes excess = at.voltage - back;
  if (someLimit(excess)) limitVoltages(current, back, inner, at);
  return at;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] void Multirotor<N, Drive>::collapse(const S& inner, Electrical<S>& at) const {
  const BusPoint<S> none = emptyBus(inner, constants_.supply.resistance);
  at.bus = none.voltage;
  at.supplyCurrent = none.current;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] void Multirotor<N, Drive>::weakBus(const LanesOf<S>& current,
                                                     const LanesOf<S>& back, const S& inner,
                                                     Electrical<S>& at) const {
  const LanesOf<S> asked = at.duty;
  const auto drawn = [&](const S& bus) {
    S sum(0.0);
    for (int i = 0; i < N; ++i) {
      const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
      at.duty[i] = hub.esc.shareOf(hub.motor, S(asked[i]), S(current[i]), S(back[i]), bus);
      sum += at.duty[i] * current[i];
    }
    return sum;
  };
  const BusPoint<S> point = loadedBus<S>(inner, constants_.supply.resistance, drawn);
  at.bus = point.voltage;
  at.supplyCurrent = point.current;
  at.voltage = at.duty * at.bus - constants_.lanes.escResistance * current;
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

/// As DriveTrain does it for one motor, at the duties and the bus of converters without losses.
template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] void Multirotor<N, Drive>::addLosses(const LanesOf<S>& current,
                                                       const LanesOf<S>& back, const S& inner,
                                                       Electrical<S>& at) const {
  using std::max;
  const double r = constants_.supply.resistance;
  const S lossless = max(S(at.bus), S(0.5 * inner));
  std::array<Conversion<S>, N> all;
  S drawn = S(constants_.avionicsPower / lossless), perVoltage = S(0.0);
  for (int i = 0; i < N; ++i) {
    auto& one = all[static_cast<std::size_t>(i)];
    const EscConstants& esc = constants_.hubs[static_cast<std::size_t>(i)].esc;
    one = conversion(esc, S(at.duty[i]), S(current[i]), S(back[i]), lossless);
    drawn += one.duty * current[i] + one.chopped;
    perVoltage += one.perVoltage;
  }
  const S bus = S((inner - r * drawn) / (1.0 + r * perVoltage));
  S power = S(constants_.avionicsPower);
  for (int i = 0; i < N; ++i) {
    const auto& one = all[static_cast<std::size_t>(i)];
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    const S path = S(hub.esc.resistance + hub.esc.leadResistance * one.duty * one.duty);
    at.voltage[i] = hub.esc.voltage(hub.motor, S(at.duty[i]), S(current[i]),
                                    S(one.duty * bus - path * current[i]), S(back[i]));
    power += converterPower(S(at.voltage[i]), hub.esc.resistance, S(current[i])) +
             conversionLoss(hub.esc, one, S(current[i]), bus);
  }
  if (!isStrongBus(valueOf(bus), valueOf(inner), valueOf(power), r)) [[unlikely]]
    return weakBus<S>(current, back, inner, at);
  at.bus = busVoltage<S>(inner, power, r);
  at.supplyCurrent = power / at.bus;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] void Multirotor<N, Drive>::limitVoltages(const LanesOf<S>& current,
                                                           const LanesOf<S>& back, const S& inner,
                                                           Electrical<S>& at) const {
  using Lanes = LanesOf<S>;
  for (int i = 0; i < N; ++i) {
    const auto& hub = constants_.hubs[static_cast<std::size_t>(i)];
    at.voltage[i] =
        hub.esc.voltage(hub.motor, S(at.duty[i]), S(current[i]), S(at.voltage[i]), S(back[i]));
  }
  const S power = converterPower<Lanes>(at.voltage, constants_.lanes.escResistance, current).sum() +
                  S(constants_.avionicsPower);
  const double resistance = constants_.supply.resistance;
  if (!isStrongBus(valueOf(at.bus), valueOf(inner), valueOf(power), resistance)) [[unlikely]]
    return weakBus<S>(current, back, inner, at);
  at.bus = busVoltage<S>(inner, power, resistance);
  at.supplyCurrent = power / at.bus;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::always_inline]] inline typename Multirotor<N, Drive>::template Flow<S>
Multirotor<N, Drive>::flow(double t, const StateOf<S>& y) const {
  using L = Layout;
  const AirConstants& air = constants_.air;
  const S qw = y[L::kAttitude], qx = y[L::kAttitude + 1], qy = y[L::kAttitude + 2],
          qz = y[L::kAttitude + 3];
  Flow<S> at{detail::Rotation<S>(qw, qx, qy, qz), bodyRates(y), {}, {}};
  at.air.velocity.setConstant(S(0.0));
  S vx = y[L::kVelocity], vy = y[L::kVelocity + 1], vz = y[L::kVelocity + 2];
  const S z = y[L::kPosition + 2];
  at.air.density = air.density(z);
  if (air.moving) {
    at.air.velocity = air.velocity(t, z);
    vx -= at.air.velocity[0];
    vy -= at.air.velocity[1];
    vz -= at.air.velocity[2];
  }
  at.motion = at.rotation.intoBody(vx, vy, vz);
  return at;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::always_inline]] inline void Multirotor<N, Drive>::beginWithDrag(const Flow<S>& at,
                                                                       Sum<S>& sum) const {
  using std::sqrt;
  const auto& v = at.motion;
  const BodyDrag& drag = constants_.drag;
  const S airSpeed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + detail::kSmallSpeedSquared);
  const S thick = S(at.air.density / kStandardDensity);
  for (int k = 0; k < 3; ++k) {
    sum.force[k] = -(drag.linear + drag.quadratic[k] * airSpeed) * thick * v[k];
    sum.moment[k] = -drag.angular[k] * thick * at.rates[k];
  }
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::noinline]] typename Multirotor<N, Drive>::template LanesOf<S>
Multirotor<N, Drive>::airAtHubs(double t, const StateOf<S>& y, const Flow<S>& at,
                                std::array<LanesOf<S>, 3>& hubVelocity) const {
  const auto& arm = constants_.lanes.arm;
  const auto& r = at.rotation;
  LanesOf<S> density;
  for (int i = 0; i < N; ++i) {
    const S z = y[Layout::kPosition + 2] + r.zx * arm[0][i] + r.zy * arm[1][i] + r.zz * arm[2][i];
    const AirAt<S> here = constants_.air.at(t, z);
    density[i] = here.density;
    if (!constants_.air.overHeight) continue;
    const Eigen::Matrix<S, 3, 1> more = r.intoBody(S(here.velocity[0] - at.air.velocity[0]),
                                                   S(here.velocity[1] - at.air.velocity[1]),
                                                   S(here.velocity[2] - at.air.velocity[2]));
    for (std::size_t k = 0; k < 3; ++k) hubVelocity[k][i] -= more[static_cast<int>(k)];
  }
  return density;
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::always_inline]] inline void Multirotor<N, Drive>::addRotors(double t, const StateOf<S>& y,
                                                                   const Flow<S>& at, Sum<S>& sum,
                                                                   LanesOf<S>& thrust,
                                                                   LanesOf<S>& torque) const {
  using Lanes = LanesOf<S>;
  const auto& lanes = constants_.lanes;
  const auto& v = at.motion;
  const auto& w = at.rates;
  const Lanes speed = y.template segment<N>(Layout::kSpeed).array();
  std::array<Lanes, 3> hubVelocity;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const auto axis = static_cast<int>(k);
    hubVelocity[k] =
        v[axis] + (w[(axis + 1) % 3] * lanes.arm[b] - w[(axis + 2) % 3] * lanes.arm[a]);
  }
  const auto add = [&](const LoadOf<S>& load) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const Lanes turning =
          load.moment[k] + (lanes.arm[a] * load.force[b] - lanes.arm[b] * load.force[a]);
      sum.force[static_cast<int>(k)] += load.force[k].sum();
      sum.moment[static_cast<int>(k)] += turning.sum();
    }
    thrust = load.thrust;
    torque = load.torque;
  };
  const bool same = constants_.air.sameAtAllRotors();
  if (constants_.lumped && same) {
    add(lanes.rotor.load(speed, hubVelocity, lanes.axis, lanes.spin, at.air.density));
    return;
  }
  const Lanes density =
      same ? Lanes(Lanes::Constant(at.air.density)) : airAtHubs<S>(t, y, at, hubVelocity);
  if (constants_.lumped) {
    add(lanes.rotor.load(speed, hubVelocity, lanes.axis, lanes.spin, density));
  } else {
    add(mixedLoads<S>(speed, hubVelocity, density));
  }
}

template <int N, RotorDrive Drive>
template <class S>
[[gnu::always_inline]] inline void Multirotor<N, Drive>::motionRates(const StateOf<S>& y,
                                                                     const Flow<S>& at, Sum<S>& sum,
                                                                     StateOf<S>& dydt) const {
  using L = Layout;
  const auto& w = at.rates;
  const auto& r = at.rotation;
  auto& force = sum.force;
  const S qw = y[L::kAttitude], qx = y[L::kAttitude + 1], qy = y[L::kAttitude + 2],
          qz = y[L::kAttitude + 3];
  dydt[L::kAttitude] = -0.5 * (qx * w[0] + qy * w[1] + qz * w[2]);
  dydt[L::kAttitude + 1] = 0.5 * (qw * w[0] + qy * w[2] - qz * w[1]);
  dydt[L::kAttitude + 2] = 0.5 * (qw * w[1] + qz * w[0] - qx * w[2]);
  dydt[L::kAttitude + 3] = 0.5 * (qw * w[2] + qx * w[1] - qy * w[0]);
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    dydt[L::kMomentum + k] =
        sum.moment[k] - (w[a] * y[L::kMomentum + b] - w[b] * y[L::kMomentum + a]);
    force[k] *= constants_.inverseMass;
    dydt[L::kPosition + k] = y[L::kVelocity + k];
  }
  dydt[L::kVelocity] = r.xx * force[0] + r.xy * force[1] + r.xz * force[2];
  dydt[L::kVelocity + 1] = r.yx * force[0] + r.yy * force[1] + r.yz * force[2];
  dydt[L::kVelocity + 2] = r.zx * force[0] + r.zy * force[1] + r.zz * force[2] - constants_.gravity;
}

template <int N, RotorDrive Drive>
template <class S, class Sink>
inline void Multirotor<N, Drive>::evaluate(double t, const CommandOf<S>& command,
                                           const StateOf<S>& y, StateOf<S>& dydt,
                                           Sink&& sink) const {
  using L = Layout;
  using Lanes = LanesOf<S>;
  const Constants& c = constants_;
  const auto& lanes = c.lanes;

  const Flow<S> at = flow<S>(t, y);
  Sum<S> sum;
  beginWithDrag(at, sum);
  Lanes thrust, torque;
  addRotors(t, y, at, sum, thrust, torque);

  const Lanes zero = Lanes::Constant(S(0.0));
  Electrical<S> power{zero, zero, S(c.openCircuit), S(0.0)};
  auto dutyRate = dydt.template segment<N>(L::kDuty).array();
  auto speedRate = dydt.template segment<N>(L::kSpeed).array();
  auto currentRate = dydt.template segment<N>(L::kCurrent).array();
  if constexpr (Drive == RotorDrive::Motors) {
    const Lanes speed = y.template segment<N>(L::kSpeed).array();
    const Lanes current = y.template segment<N>(L::kCurrent).array();
    const Lanes commanded = command.array(), follows = y.template segment<N>(L::kDuty).array();
    power = electrical<S>(command, y);
    dutyRate = lanes.duty.rate(commanded, follows);
    speedRate = (lanes.motor.torqueConstant * current - lanes.motor.friction(speed) - torque) *
                lanes.inverseInertia;
    currentRate = lanes.motor.currentRate(power.voltage, current, speed);
  } else {
    speedRate = command.array();
    currentRate = zero;
    dutyRate = zero;
  }

  motionRates(y, at, sum, dydt);
  dydt[L::kCharge] = power.supplyCurrent;
  dydt[L::kPolarisation] = (c.supply.polarisation * power.supplyCurrent - y[L::kPolarisation]) *
                           c.supply.inversePolarisationTime;
  dydt[L::kEnergy] = power.bus * power.supplyCurrent;
  sink(thrust, torque, power, at, sum.force);
}

}  // namespace rotorbench
