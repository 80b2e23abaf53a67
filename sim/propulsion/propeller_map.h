// A propeller tabulated once, for use where it is asked millions of times. Its loads over 0.5 rho A U^2 depend on the
// direction of the air at 75 % radius and on the Reynolds number rho U R/mu only: so one table holds for every speed,
// from standing still to windmilling, and for all air. With axial speed V, in-plane speed P and U the length of all:
//   chi = atan2(V, 0.75 Om R),  sine = P/U,  U^2 = V^2 + P^2 + (0.75 Om R)^2
// Axial flow (P = 0) is a fine table over chi and the logarithm of the Reynolds number. What in-plane speed adds is a
// second, coarser table over chi, the side angle asin(P/U) and the Reynolds number. It holds the changes of thrust and torque over
// sine^2, and the in-plane force and the hub moments over sine: even and smooth functions, so that forward
// flight sets in smoothly and no direction is needed at rest. Both come from BladeElementRotor; Catmull-Rom cubics, straight
// lines over the Reynolds number in the second. Frame and signs as in blade_element.h. SI, rad.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/propulsion/blade_element.h"

namespace rotorbench {

/// The grid of a map. More points make it more exact and slower to build, not slower to use.
struct PropellerMapSettings {
  int directions = 721;        ///< from straight descent to straight climb, -90 to 90 degrees
  int reynoldsNumbers = 20;    ///< spread evenly over the logarithm
  double leastReynolds = 1e4;  ///< rho U R/mu; below and above the range the nearest end holds
  double mostReynolds = 1e7;
  int sideDirections = 61;  ///< as `directions`, for what in-plane speed adds
  int sideAngles = 13;      ///< from no in-plane speed to nothing else, 0 to 90 degrees
  bool operator==(const PropellerMapSettings&) const = default;
};

/// Thrust along the axis, N, and torque against the rotation, N m.
template <class S = double>
struct ThrustAndTorqueOf {
  S thrust = S(0.0);
  S torque = S(0.0);
};
using ThrustAndTorque = ThrustAndTorqueOf<double>;

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

  [[nodiscard]] double radius() const { return radius_; }

 private:
  static constexpr double kReferenceRadius = 0.75;  // r/R

  /// What in-plane speed adds: dT and dQ per sine^2; H, Y, roll and pitch moments per sine (ObliqueLoad).
  static constexpr std::size_t kSideValues = 6;
  static constexpr std::size_t kSideRows = 4;  ///< Reynolds numbers, over the range of the map
  using SideValues = std::array<double, kSideValues>;

  template <class S>
  static void weigh(const S& t, S (&weight)[4]) {  // Catmull-Rom
    const S s = 1.0 - t;
    weight[0] = -0.5 * t * s * s;
    weight[1] = 1.0 + t * t * (1.5 * t - 2.5);
    weight[2] = 1.0 + s * s * (1.5 * s - 2.5);
    weight[3] = -0.5 * s * t * t;
  }
  /// Interval of a coordinate in units of the grid, 0 to last, and the fraction in it. NaN is taken as 0.
  template <class S>
  static std::size_t place(const S& coordinate, double last, S& fraction) {
    const double inside = std::fmin(std::fmax(valueOf(coordinate), 0), last);
    const double interval = std::fmin(std::floor(inside), last - 1);
    fraction = S(coordinate - interval);
    if (!(valueOf(coordinate) == inside)) fraction = S(inside - interval);
    return static_cast<std::size_t>(interval);
  }

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
    S t, directionWeight[4], reynoldsWeight[4];
    const std::size_t k = place(
        S((atan2(along, across) + std::numbers::pi / 2) * directionsPerAngle_), lastDirection_, t);
    weigh(t, directionWeight);
    const std::size_t i = place(S((logReynolds - leastLogReynolds_) * rowsPerLog_), lastRow_, t);
    weigh(t, reynoldsWeight);
    ThrustAndTorqueOf<S> load;
    for (std::size_t r = 0; r < 4; ++r) {
      const ThrustAndTorque* row = &values_[(i + r) * stride_ + k];
      S thrust = S(0.0), torque = S(0.0);
      for (std::size_t c = 0; c < 4; ++c) {
        thrust += directionWeight[c] * row[c].thrust;
        torque += directionWeight[c] * row[c].torque;
      }
      load.thrust += reynoldsWeight[r] * thrust;
      load.torque += reynoldsWeight[r] * torque;
    }
    const S scale = (sign * 0.5 * area_) * density * square;
    return {S(scale * load.thrust), S(scale * radius_ * load.torque)};
  }

  template <class S>
  void sideValues(const S& direction, const S& sine, const S& logReynolds,
                  S (&values)[kSideValues]) const;
  void tabulateAxial(const BladeElementRotor& rotor, const PropellerMapSettings& settings);
  void tabulateSide(const BladeElementRotor& rotor, const PropellerMapSettings& settings);
  [[nodiscard]] SideValues sideAt(const BladeElementRotor& rotor, double direction,
                                  double sideAngle, double speed) const;
  void extrapolateEdges(std::size_t rows);
  void extrapolateSideEdges();
  [[nodiscard]] std::size_t sideIndex(std::size_t row, std::size_t angle,
                                      std::size_t direction) const {
    return (row * sideAngles_ + angle) * sideDirections_ + direction;
  }

  std::vector<ThrustAndTorque> values_;  // one more point than the grid on every side
  std::size_t stride_ = 0;
  double directionsPerAngle_ = 0, lastDirection_ = 0;
  double leastLogReynolds_ = 0, rowsPerLog_ = 0, lastRow_ = 0;
  std::vector<SideValues>
      side_;  // rows of Reynolds number, side angle, direction; margins in the last two
  std::size_t sideAngles_ = 0, sideDirections_ = 0;  // margins included
  double sideDirectionsPerAngle_ = 0, sideAnglesPerAngle_ = 0, sideRowsPerLog_ = 0;
  double radius_ = 0, area_ = 0;
};

template <class S>
void PropellerMap::sideValues(const S& direction, const S& sine, const S& logReynolds,
                              S (&values)[kSideValues]) const {
  using std::asin;
  S t, directionWeight[4], angleWeight[4], share;
  const std::size_t k = place(S((direction + std::numbers::pi / 2) * sideDirectionsPerAngle_),
                              static_cast<double>(sideDirections_ - 3), t);
  weigh(t, directionWeight);
  const std::size_t j =
      place(S(asin(sine) * sideAnglesPerAngle_), static_cast<double>(sideAngles_ - 3), t);
  weigh(t, angleWeight);
  const std::size_t i = place(S((logReynolds - leastLogReynolds_) * sideRowsPerLog_),
                              static_cast<double>(kSideRows - 1), share);
  for (S& value : values) value = S(0.0);
  for (std::size_t r = 0; r < 2; ++r) {
    const S rowWeight = r == 0 ? S(1.0 - share) : share;
    for (std::size_t a = 0; a < 4; ++a) {
      const SideValues* row = &side_[sideIndex(i + r, j + a, k)];
      const S weight = rowWeight * angleWeight[a];
      for (std::size_t c = 0; c < 4; ++c) {
        const S both = weight * directionWeight[c];
        for (std::size_t q = 0; q < kSideValues; ++q) values[q] += both * row[c][q];
      }
    }
  }
}

template <class S, class Vector, class Axis>
RotorLoad<S, Vector> PropellerMap::load(const S& w, const Vector& v, const Axis& axis, double spin,
                                        const S& density, double viscosity) const {
  using std::abs;
  using std::atan2;
  using std::log;
  using std::sqrt;
  const double sign = valueOf(w) < 0 ? -1 : 1;
  const S axialSpeed = v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
  const ThrustAndTorqueOf<S> still = axialLoad(w, axialSpeed, density, viscosity);
  RotorLoad<S, Vector> l;
  l.thrust = still.thrust;
  l.torque = still.torque;
  Vector inPlane;
  for (int k = 0; k < 3; ++k) inPlane[k] = v[k] - axialSpeed * axis[k];
  const S sideSquare = inPlane[0] * inPlane[0] + inPlane[1] * inPlane[1] + inPlane[2] * inPlane[2];
  const S across = (kReferenceRadius * radius_) * abs(w);
  const S square = sideSquare + axialSpeed * axialSpeed + across * across;
  // Below this the in-plane speed is noise, and its effect too.
  constexpr double kNoise = 1e-18;
  if (!(valueOf(sideSquare) > kNoise * valueOf(square)) || !(valueOf(density) > 0)) {
    for (int k = 0; k < 3; ++k) {
      l.force[k] = l.thrust * axis[k];
      l.moment[k] = -spin * l.torque * axis[k];
    }
    return l;
  }
  const S speed = sqrt(square), sine = sqrt(sideSquare) / speed;
  const S along = sign * axialSpeed;
  S value[kSideValues];
  sideValues(S(atan2(along, across)), sine, S(log(S(density * speed * (radius_ / viscosity)))),
             value);
  const S pressure = 0.5 * area_ * density * square, lever = pressure * radius_;
  l.thrust += sign * pressure * sine * sine * value[0];
  l.torque += sign * lever * sine * sine * value[1];
  // front, e1 and e2 of BladeElementRotor::load(), e1 and e2 here times sine.
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const S e1 = inPlane[k] / speed;
    const S e2 = (spin * sign) * (axis[a] * inPlane[b] - axis[b] * inPlane[a]) / speed;
    l.force[k] = l.thrust * axis[k] + pressure * (value[3] * e2 - value[2] * e1);
    l.moment[k] = spin * (lever * (value[4] * e1 - value[5] * e2) - l.torque * axis[k]);
  }
  return l;
}

template <>
struct Describe<PropellerMapSettings> {
  static void fields(schema::Builder<PropellerMapSettings>& b);
};

}  // namespace rotorbench
