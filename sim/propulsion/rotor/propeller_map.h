// A propeller tabulated once, for use where it is asked millions of times. Its loads over 0.5 rho A
// U^2 depend on the direction of the air at 75 % radius and on the Reynolds number rho U R/mu only:
// so one table holds for every speed, from standing still to windmilling, and for all air. With
// axial speed V, in-plane speed P and U the length of all:
//   chi = atan2(V, 0.75 Om R),  sine = P/U,  U^2 = V^2 + P^2 + (0.75 Om R)^2
// Axial flow (P = 0) is a fine table over chi and the logarithm of the Reynolds number, solved by
// BladeElementRotor itself. Edgewise flow is a second table, over chi, the side angle asin(P/U) and
// the Reynolds number, solved where it needs to be (refined_grid.h) and as fast as its tolerance
// allows (lane_rotor.h): thrust and torque, which are even in the side angle, and in-plane force
// and hub moment over the sine, which are so too. Where there is hardly any in-plane speed the
// finer axial table corrects it: so forward flight sets in smoothly and no direction is needed at
// rest. Both are read by Catmull-Rom cubics. The tables are those of rigid blades in an even
// inflow; skew and flapping follow in closed form (disc_response.h). Frame and signs as in
// blade_element.h. SI, rad.
#pragma once

#include <array>
#include <cmath>
#include <iosfwd>
#include <numbers>
#include <optional>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/numerics/cubic_table.h"
#include "sim/propulsion/rotor/blade_element.h"

namespace rotorbench {

/// The grid of a map. More points make it more exact and slower to build, not slower to use.
struct PropellerMapSettings {
  int directions = 721;        ///< from straight descent to straight climb, -90 to 90 degrees
  int reynoldsNumbers = 20;    ///< spread evenly over the logarithm
  double leastReynolds = 1e4;  ///< rho U R/mu; below and above the range the nearest end holds
  double mostReynolds = 1e7;
  int sideDirections = 31;  ///< coarse grid of edgewise flow, as `directions`
  int sideAngles = 16;      ///< coarse, from no in-plane speed to nothing else, 0 to 90 degrees
  int sideReynoldsNumbers = 19;  ///< as `reynoldsNumbers`
  int sideRefinements = 3;       ///< how often directions and side angles may be halved
  double sideTolerance = 5e-4;   ///< there, as a part of the static thrust; torque: 10 times
  bool operator==(const PropellerMapSettings&) const = default;
};

/// Thrust along the axis, N, and torque against the rotation, N m.
template <class S = double>
struct ThrustAndTorqueOf {
  S thrust = S(0.0);
  S torque = S(0.0);
};
using ThrustAndTorque = ThrustAndTorqueOf<double>;

class LaneRotor;

class PropellerMap {
 public:
  explicit PropellerMap(const BladeElementRotor& rotor, const PropellerMapSettings& settings = {});

  /// Loads at speed omega, rad/s, in an axial stream, m/s; turning backwards by the rule of
  /// BladeElementRotor::axial(). No heap, no exception; finite for all finite speeds.
  [[nodiscard]] ThrustAndTorque axial(double omega, double axialSpeed, const AirState& air) const {
    return axialLoad(omega, axialSpeed, air.density, air.viscosity);
  }

  /// Force and moment about the hub in body axes, as BladeElementRotor::load(), over any scalar.
  template <class S, class Vector, class Axis>
  [[nodiscard]] RotorLoad<S, Vector> load(const S& w, const Vector& v, const Axis& axis,
                                          double spin, const S& density,
                                          double viscosity = kAirViscosity) const;

  /// The tables as bytes of this machine, and a map from them: of the same rotor and settings, or
  /// nothing where they do not fit.
  void write(std::ostream& out) const;
  static std::optional<PropellerMap> read(std::istream& in, const BladeElementRotor& rotor,
                                          const PropellerMapSettings& settings);

  [[nodiscard]] double radius() const { return radius_; }
  /// How many states of edgewise flow were solved to fill the table.
  [[nodiscard]] std::size_t sideSolved() const { return sideSolved_; }

 private:
  PropellerMap() = default;
  /// All but the tables.
  void setScales(const BladeElementRotor& rotor, const PropellerMapSettings& settings);

  static constexpr double kReferenceRadius = 0.75;  // r/R
  static constexpr double kAxialSine =
      0.05;  // of the side angle: about so far the finer axial table corrects the other
  static constexpr double kFaded = 16;  // beyond it exp(-16) of a small correction is left

  template <class S>
  [[nodiscard]] ThrustAndTorqueOf<S> axialLoad(const S& omega, const S& axialSpeed,
                                               const S& density, double viscosity) const {
    using std::abs;
    using std::atan2;
    using std::log;
    const double sign = valueOf(omega) < 0 ? -1 : 1;
    const S along = sign * axialSpeed, across = (kReferenceRadius * radius_) * abs(omega);
    const S square = along * along + across * across;
    if (!(valueOf(square) > 0) || !(valueOf(density) > 0)) return {};
    const S logReynolds = log(S(density * (radius_ / viscosity))) + 0.5 * log(square);
    const ThrustAndTorqueOf<S> c = axialCoefficients(S(atan2(along, across)), logReynolds);
    const S scale = (sign * 0.5 * area_) * density * square;
    return {S(scale * c.thrust), S(scale * radius_ * c.torque)};
  }

  /// Thrust over 0.5 rho A U^2 and torque over that and R, in axial flow.
  template <class S>
  [[nodiscard]] ThrustAndTorqueOf<S> axialCoefficients(const S& direction,
                                                       const S& logReynolds) const {
    S t, directionWeight[4], reynoldsWeight[4];
    const std::size_t k = gridInterval(S((direction + std::numbers::pi / 2) * directionsPerAngle_),
                                       lastDirection_, t);
    catmullRom(t, directionWeight);
    const std::size_t i =
        gridInterval(S((logReynolds - leastLogReynolds_) * rowsPerLog_), lastRow_, t);
    catmullRom(t, reynoldsWeight);
    ThrustAndTorqueOf<S> c;
    for (std::size_t r = 0; r < 4; ++r) {
      const ThrustAndTorque* row = &values_[(i + r) * stride_ + k];
      S thrust = S(0.0), torque = S(0.0);
      for (std::size_t d = 0; d < 4; ++d) {
        thrust += directionWeight[d] * row[d].thrust;
        torque += directionWeight[d] * row[d].torque;
      }
      c.thrust += reynoldsWeight[r] * thrust;
      c.torque += reynoldsWeight[r] * torque;
    }
    return c;
  }

  void tabulateAxial(const BladeElementRotor& rotor, const PropellerMapSettings& settings);
  void tabulateSide(const BladeElementRotor& rotor, const PropellerMapSettings& settings);
  [[nodiscard]] GridValues sideAt(const LaneRotor& rotor, double direction, double sideAngle,
                                  double logReynolds) const;
  [[nodiscard]] GridValues sideTolerance(double share) const;
  void extrapolateEdges(std::size_t rows);

  std::vector<ThrustAndTorque> values_;  // one more point than the grid on every side
  std::size_t stride_ = 0;
  double directionsPerAngle_ = 0, lastDirection_ = 0;
  double leastLogReynolds_ = 0, rowsPerLog_ = 0, lastRow_ = 0;
  CubicTable side_;  // over chi, side angle and Reynolds number
  std::size_t sideSolved_ = 0;
  double radius_ = 0, area_ = 0;
  DiscConstants disc_;
};

template <class S, class Vector, class Axis>
RotorLoad<S, Vector> PropellerMap::load(const S& w, const Vector& v, const Axis& axis, double spin,
                                        const S& density, double viscosity) const {
  using std::abs;
  using std::asin;
  using std::atan2;
  using std::exp;
  using std::log;
  using std::sqrt;
  const double sign = valueOf(w) < 0 ? -1 : 1;
  const S axialSpeed = v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
  RotorLoad<S, Vector> l;
  Vector inPlane;
  for (int k = 0; k < 3; ++k) inPlane[k] = v[k] - axialSpeed * axis[k];
  const S sideSquare = inPlane[0] * inPlane[0] + inPlane[1] * inPlane[1] + inPlane[2] * inPlane[2];
  const S across = (kReferenceRadius * radius_) * abs(w);
  const S square = sideSquare + axialSpeed * axialSpeed + across * across;
  // Below this the in-plane speed is noise, and its effect too.
  constexpr double kNoise = 1e-18;
  if (!(valueOf(sideSquare) > kNoise * valueOf(square)) || !(valueOf(density) > 0)) {
    const ThrustAndTorqueOf<S> still = axialLoad(w, axialSpeed, density, viscosity);
    l.thrust = still.thrust;
    l.torque = still.torque;
    for (int k = 0; k < 3; ++k) {
      l.force[k] = l.thrust * axis[k];
      l.moment[k] = -spin * l.torque * axis[k];
    }
    return l;
  }
  const S speed = sqrt(square), sine = sqrt(sideSquare) / speed;
  const S direction = atan2(S(sign * axialSpeed), across);
  const S logReynolds = log(S(density * speed * (radius_ / viscosity)));
  const S x = direction / std::numbers::pi + 0.5,
          z = (logReynolds - leastLogReynolds_) * (rowsPerLog_ / lastRow_);
  S value[kGridValues];
  side_.at(x, S(asin(sine) * (2 / std::numbers::pi)), z, value);
  const S fading = sine * sine / (kAxialSine * kAxialSine);
  if (valueOf(fading) < kFaded) {
    // Without in-plane speed the finer table of axial flow holds.
    S coarse[kGridValues];
    side_.at(x, S(0.0), z, coarse);
    const S share = exp(S(-fading));
    const ThrustAndTorqueOf<S> still = axialCoefficients(direction, logReynolds);
    value[0] += share * (still.thrust - coarse[0]);
    value[1] += share * (still.torque - coarse[1]);
  }
  const S pressure = 0.5 * area_ * density * square, lever = pressure * radius_;
  // The table has what is in the plane over the sine.
  const EvenLoad<S> even{S(pressure * value[0]), S(lever * value[1]),
                         S(pressure * value[2] / speed), S(lever * value[3] / speed)};
  const auto disc =
      discResponse<S>(disc_, even, S(abs(w)), S(sign * axialSpeed), sideSquare, density);
  return bodyLoad<S, Vector>(disc, inPlane, axis, spin, sign);
}

template <>
struct Describe<PropellerMapSettings> {
  static void fields(schema::Builder<PropellerMapSettings>& b);
};

}  // namespace rotorbench
