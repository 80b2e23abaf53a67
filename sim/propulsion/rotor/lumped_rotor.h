// A rotor: propeller with the spinning part of its motor, as the lumped model of
//   J. Svacha, K. Mohta, V. Kumar, "Improving quadrotor trajectory tracking by compensating for
//   aerodynamic effects", ICUAS 2017, in the form used by RotorPy (Folk, Paulos, Kumar 2023):
//   thrust         T = k_eta w^2 + k_h |v_xy|^2 - k_z w v_z    along the rotor axis
//   in-plane drag  H = -k_d w v_xy
//   drag torque    Q = k_m w^2, on the body about the axis: -s Q (s = +1 counter-clockwise from
//   above)
//   flapping       M = -k_flap w (v x axis)
// v: velocity of the hub against the air, v_z along the axis. SI; all forces scale with air
// density. The form gives translational lift without a price. Here a rotor that has some pays with
// its torque for what an ideal one would take more than at rest: T v_i - T_0 v_0, where that is
// above 0, T_0 the thrust without lift, v_i^2 (v_i^2 + |v_xy|^2) = (T/2 rho A)^2 by H. Glauert's
// momentum theory of edgewise flow. In slow flight v_i falls faster than T grows, and the form
// stays what it is.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "sim/core/scalar.h"
#include "sim/core/schema.h"
#include "sim/propulsion/rotor/hub_load.h"

namespace rotorbench {

/// What moving air does to the rotor, at the air density its alternative names.
struct RotorInflow {
  double drag = 0;    ///< k_d, N s^2/m/rad: in-plane force per speed and in-plane air speed
  double inflow = 0;  ///< k_z, N s^2/m/rad: loss of thrust per speed and axial air speed
  double translationalLift = 0;  ///< k_h, N s^2/m^2: thrust per in-plane air speed squared
  double flapping = 0;           ///< k_flap, N s^2/rad: hub moment per speed and in-plane air speed
  bool operator==(const RotorInflow&) const = default;
};

/// Coefficients as identified on a vehicle. Until others are given thrust and torque are those of
/// PropellerCoefficients, so that the default vehicle stays itself in either form; what moving air
/// does is none until it is given, for no rotor has the figures of another.
struct RotorCoefficients {
  double thrust = 1.327e-5;  ///< k_eta, N s^2/rad^2
  double torque = 2.621e-7;  ///< k_m, N m s^2/rad^2
  RotorInflow inflow{};
  double referenceDensity = 1.225;  ///< kg/m^3 at which all of them hold
  double diameter = 0;              ///< m, for drawing and advance ratios; 0: not known
  bool operator==(const RotorCoefficients&) const = default;
};

/// A propeller by its static coefficients: T = CT rho n^2 D^4, P = CP rho n^3 D^5, so
/// Q = CP rho n^2 D^5/(2 pi), n in 1/s. Defaults: what JSBSim's F450, the default vehicle, flies as
/// its 9450, a table of the APC 9 x 4.5 E in truth. A file that describes a propeller gives all
/// three.
struct PropellerCoefficients {
  double thrustCoefficient = 0.1288;  ///< CT at rest
  double powerCoefficient = 0.0666;   ///< CP at rest
  double diameter = 0.24003;          ///< m
  RotorInflow inflow{};               ///< at 1.225 kg/m^3
  bool operator==(const PropellerCoefficients&) const = default;
};

/// N m that a rotor at w rad/s takes more for a thrust of `along` N in an in-plane stream, m^2/s^2,
/// than at rest for what of it is no translational lift. `lift`: k_h over the density; `discs` 2 A
/// in m^2.
template <class S>
[[nodiscard]] S priceOfLift(const S& w, const S& along, const S& acrossSquared, const S& density,
                            double lift, double discs) {
  using std::abs;
  using std::sqrt;
  if (!(lift > 0) || !(valueOf(acrossSquared) > 0) || !(valueOf(density) > 0)) return S(0.0);
  const S load = S(along / (density * discs));
  if (valueOf(load) == 0) return S(0.0);
  const S half = S(0.5 * acrossSquared);
  // v_i^2, without the difference of two large numbers.
  const S square = S(load * load), induced = S(square / (half + sqrt(S(half * half + square))));
  S more = S(abs(along) * sqrt(induced));
  const S plain = S(abs(S(along - lift * (density * acrossSquared))));
  if (valueOf(plain) > 0) more -= plain * sqrt(S(plain / (density * discs)));
  if (!(valueOf(more) > 0)) return S(0.0);
  constexpr double kSlow = 1;  // rad/s: keeps the torque finite where the rotor stops
  return S(more * w / (w * w + kSlow));
}

/// The lumped model per unit of air density, for one rotor (Real is double) or for several at once
/// (Real is an Eigen::Array of double with one lane per rotor).
template <class Real>
struct RotorModel {
  Real thrust{}, torque{}, drag{}, inflow{}, lift{}, flapping{};
  Real discs{};          ///< m^2: 2 A, of the disc
  bool lifting = false;  ///< some lift is not 0

  /// Speed w in rad/s (negative: turning backwards, thrust and torque change sign), hub velocity
  /// against the air and axis in body axes, spin +-1, density in kg/m^3.
  template <class S, class Vector, class Axis, class Density>
  [[nodiscard]] RotorLoad<S, Vector> load(const S& w, const Vector& v, const Axis& axis,
                                          const Real& spin, const Density& density) const {
    using std::abs;
    const S magnitude = abs(w);
    const HubStream<S> stream = hubStream<S>(v, axis);
    const S drive = density * magnitude;
    const S square = drive * w;
    const S along =
        thrust * square + lift * (density * stream.acrossSquared) - inflow * (drive * stream.axial);
    S against = S(torque * square);
    if (lifting) [[unlikely]] {
      // Copies: what the others' path computes stays in registers.
      const S turning = w, lifts = along, across = stream.acrossSquared, free = against;
      against = pricedTorque<S>(turning, lifts, across, density, free);
    }
    return hubLoad<S>(v, axis, spin, stream.axial, along, against, S(drag * drive),
                      S(flapping * drive));
  }

 private:
  template <class S, class Density>
  [[gnu::noinline]] S pricedTorque(const S& w, const S& along, const S& acrossSquared,
                                   const Density& density, const S& free) const {
    if constexpr (std::is_same_v<Real, double>) {
      return S(free + priceOfLift<S>(w, along, acrossSquared, S(density), lift, discs));
    } else {
      S against = free;
      using Scalar = typename S::Scalar;
      for (int i = 0; i < Real::SizeAtCompileTime; ++i) {
        Scalar here;
        if constexpr (std::is_base_of_v<Eigen::EigenBase<Density>, Density>) {
          here = Scalar(density[i]);
        } else {
          here = Scalar(density);
        }
        against[i] +=
            priceOfLift<Scalar>(w[i], along[i], acrossSquared[i], here, lift[i], discs[i]);
      }
      return against;
    }
  }
};

/// The diameter in m, or where it is not known that of a propeller with CT = 0.1 at rest.
double diameterOf(const RotorCoefficients& c);

/// The model of a rotor given by its coefficients, with its in-plane terms.
RotorModel<double> lumpedModel(const RotorCoefficients& c);
RotorModel<double> lumpedModel(const PropellerCoefficients& c);

/// Thrust and torque of a propeller per air density and speed squared (rad/s), from its
/// coefficients CT and CP.
struct SquareFactors {
  double thrust;  ///< m^4: T = thrust rho w^2
  double torque;  ///< m^5
};
SquareFactors squareFactors(double thrustCoefficient, double powerCoefficient, double diameter);

template <>
struct Describe<RotorInflow> {
  static void fields(schema::Builder<RotorInflow>& b);
};
template <>
struct Describe<RotorCoefficients> {
  static void fields(schema::Builder<RotorCoefficients>& b);
};
template <>
struct Describe<PropellerCoefficients> {
  static void fields(schema::Builder<PropellerCoefficients>& b);
};
}  // namespace rotorbench
