// Force and moment at the hub of a rotor that is known by its thrust, its torque and by what air
// from the side does in proportion to it:
//   F = T axis - h v_xy,   M = -s Q axis - f (v x axis)
//   J. Svacha, K. Mohta, V. Kumar, ICUAS 2017 (in-plane drag and flapping)
// v: velocity of the hub against the air, v_xy its part across the axis, s = +1 counter-clockwise
// from above. SI units, body axes. Any scalar, or an array with one lane per rotor.
#pragma once

#include "sim/propulsion/rotor/rotor_load.h"

namespace rotorbench {

/// The hub's velocity against the air, taken apart.
template <class S>
struct HubStream {
  S axial;          ///< m/s along the axis
  S acrossSquared;  ///< m^2/s^2
};

// These two run in every derivative of a flight.
template <class S, class Vector, class Axis>
[[gnu::always_inline, nodiscard]] inline HubStream<S> hubStream(const Vector& v, const Axis& axis) {
  const S axial = v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
  return {axial, S(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - axial * axial)};
}

/// `axial` of hubStream(); thrust in N, torque in N m; `drag` h in N s/m, `flapping` f in N s, both
/// of the velocity.
template <class S, class Vector, class Axis, class Spin>
[[gnu::always_inline, nodiscard]] inline RotorLoad<S, Vector> hubLoad(
    const Vector& v, const Axis& axis, const Spin& spin, const S& axial, const S& thrust,
    const S& torque, const S& drag, const S& flapping) {
  RotorLoad<S, Vector> l;
  l.thrust = thrust;
  l.torque = torque;
  // In-plane velocity is v - axial * axis; its axial part is put back into the thrust here.
  const S along = thrust + drag * axial;
  const S twist = -spin * torque;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    l.force[k] = along * axis[k] - drag * v[k];
    l.moment[k] = twist * axis[k] - flapping * (v[a] * axis[b] - v[b] * axis[a]);
  }
  return l;
}

}  // namespace rotorbench
