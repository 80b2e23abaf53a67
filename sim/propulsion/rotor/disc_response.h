// What the loads of rigid blades in an even inflow lack in forward flight: the skew of the inflow,
// and blades that flap. A closed form after the loads, quasi-steady, over any scalar.
//
// Skew: the wake leans back, and the air is driven down more at the rear of the disc than at its
// front, v(r, psi) = v0 (1 - K r/R cos psi), psi from the front, K = (15 pi/32) tan(chi/2), chi the
// wake's angle from the axis. The lift moves to the front: a moment that pitches the hub up, and a
// force to the side.
//   D. M. Pitt, D. A. Peters, "Theoretical prediction of dynamic-inflow derivatives", Vertica 5,
//     1981: 15 pi/64 tan(chi/2) against 1/2 in the first column of L.
// Flapping: blades on a hinge at the centre with a spring k_b answer the first harmonic of the
// moments at their root by tilting the plane of their tips, in balance with the spring and with the
// damping of their own motion in the air, C = 1/4 rho a B Om^2 int c r^3 dr for all of them:
//   K b_c + C b_s = M_pitch,  K b_s - C b_c = M_roll,  K = B k_b/2
// The thrust tilts with the plane, the spring alone brings moments to the hub, and the shaft is
// spared the work the tilted thrust does.
//   J. G. Leishman, Principles of Helicopter Aerodynamics, 2nd ed., sec. 4.5-4.7
// Both are linear: lift slope a of the section at 75 % radius, small angles. The tilt is held below
// kMostTilt, and the momentum inflow is kept finite where the air stands still in the disc. With
// no stiffness given the blades are rigid. SI units; frame of ObliqueLoad.
#pragma once

#include <cmath>
#include <numbers>

#include "sim/core/scalar.h"

namespace rotorbench {

/// What of a propeller it takes.
struct DiscConstants {
  double radius = 0, area = 0;  ///< m, m^2
  double momentumFactor = 1;
  double flapIntegral = 0;  ///< B a int c r^3 dr, m^5
  double swayIntegral = 0;  ///< B a int c r dr, m^3
  bool flapping = false;
  double stiffness = 0;  ///< K, N m/rad
};

/// Loads of rigid blades in an even inflow; what is in the plane, over the in-plane speed, so that
/// none of it is undefined at rest.
template <class S>
struct EvenLoad {
  S thrust, torque;  ///< N, N m
  S drag, roll;      ///< N s/m, N s: along -e1, about e1
};

/// With skew and flapping: of `even`, and to the side (e2) and about -e2.
template <class S>
struct DiscLoad : EvenLoad<S> {
  S side, pitch;  ///< N s/m, N s
};

/// rad: no tilt of the tips' plane reaches it.
inline constexpr double kMostTilt = 0.3;

/// `omega` in rad/s, not negative; axial speed V in m/s; `across` the square of the in-plane speed,
/// m^2/s^2; density in kg/m^3. One of omega, V and `across` is not 0.
template <class S>
DiscLoad<S> discResponse(const DiscConstants& c, const EvenLoad<S>& even, const S& omega,
                         const S& axial, const S& across, const S& density) {
  using std::abs;
  using std::sqrt;
  DiscLoad<S> out{even, S(0.0), S(0.0)};
  const S tip = omega * c.radius;
  // Glauert's v sqrt(P^2 + (V + v)^2) = T/(2 rho A k): from below, halving the step, which meets
  // the windmill's solution in descent and the helicopter's in climb.
  const S square = even.thrust / (2 * c.area * c.momentumFactor * density);  // v^2 in hover
  const double sign = valueOf(square) < 0 ? -1 : 1;
  const S size = sign * square, along = sign * axial;
  constexpr double kStill = 0.01;  // of v^2 in hover: the least square of the speed in the disc
  constexpr double kTiny = 1e-12;
  const S floor = across + kStill * size + kTiny * (tip * tip + axial * axial);
  S v = size / sqrt(S(size + axial * axial + floor));
  for (int i = 0; i < 3; ++i) {
    const S through = along + v;
    v = 0.5 * (v + size / sqrt(S(through * through + floor)));
  }
  const S through = along + v, disc = through * through + kStill * size;
  const S least = kTiny * (tip * tip + axial * axial);
  // K v0 over the in-plane speed.
  const S skew = (15 * std::numbers::pi / 32) * sign * v /
                 (sqrt(S(disc + least)) + sqrt(S(disc + across + least)));
  const S half = 0.25 * density * skew / c.radius;
  out.pitch = half * c.flapIntegral * omega;
  out.side = 0.5 * even.thrust * skew * tip / (tip * tip + across + disc + least) -
             half * c.swayIntegral * sign * through;
  if (!c.flapping) return out;

  const S damping = 0.25 * density * c.flapIntegral * omega * omega;
  const S all = damping * damping + c.stiffness * c.stiffness + kTiny * kTiny;
  S back = (c.stiffness * out.pitch - damping * even.roll) / all;
  S left = (c.stiffness * even.roll + damping * out.pitch) / all;
  const S tilt = across * (back * back + left * left) / (kMostTilt * kMostTilt);
  const S share = 1.0 / sqrt(S(1.0 + tilt));
  back = back * share;
  left = left * share;
  out.roll = c.stiffness * left;
  out.pitch = c.stiffness * back;
  out.drag = even.drag + even.thrust * back;
  out.side = out.side - even.thrust * left;
  out.torque = even.torque - even.thrust * back * across * omega /
                                 (omega * omega + (across + axial * axial) / (c.radius * c.radius));
  return out;
}

}  // namespace rotorbench
