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
template <class S, class Sink>
inline void Multirotor<N, Drive>::evaluate(const CommandOf<S>& command, const StateOf<S>& y,
                                           StateOf<S>& dydt, Sink&& sink) const {
  using std::sqrt;
  using L = Layout;
  using Vector = Eigen::Matrix<S, 3, 1>;
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

  S supplyCurrent = S(0.0), bus = S(c.supply.voltage);
  if constexpr (Drive == RotorDrive::Motors) {
    for (int i = 0; i < N; ++i) supplyCurrent += command[i] * y[L::kCurrent + i];
    bus -= c.supply.internalResistance * supplyCurrent;
  }

  for (int i = 0; i < N; ++i) {
    const auto& hub = c.hubs[static_cast<std::size_t>(i)];
    const S speed = y[L::kSpeed + i];
    Vector hubVelocity;
    hubVelocity[0] = v[0] + w[1] * hub.arm[2] - w[2] * hub.arm[1];
    hubVelocity[1] = v[1] + w[2] * hub.arm[0] - w[0] * hub.arm[2];
    hubVelocity[2] = v[2] + w[0] * hub.arm[1] - w[1] * hub.arm[0];
    const RotorLoad<S> load = hub.rotor.load(speed, hubVelocity, hub.axis, hub.spin, density);
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      force[k] += load.force[k];
      moment[k] += load.moment[k] + hub.arm[a] * load.force[b] - hub.arm[b] * load.force[a];
    }
    if constexpr (Drive == RotorDrive::Motors) {
      const S current = y[L::kCurrent + i];
      const S voltage = command[i] * bus;
      dydt[L::kSpeed + i] =
          (hub.motor.torqueConstant * current - hub.motor.friction(speed) - load.torque) *
          hub.rotor.inverseInertia;
      dydt[L::kCurrent + i] = hub.motor.currentRate(voltage, current, speed);
      sink(i, load, voltage);
    } else {
      dydt[L::kSpeed + i] = command[i];
      dydt[L::kCurrent + i] = S(0.0);
      sink(i, load, S(0.0));
    }
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
  dydt[L::kCharge] = supplyCurrent;
  sink(w, force, bus, supplyCurrent);
}

}  // namespace rotorbench
