// A propeller tabulated once, for use where it is asked millions of times. Thrust and torque over
// 0.5 rho A U^2 depend on two numbers only, the direction of the air at 75 % radius, chi = atan2(V, 0.75 Om R),
// and the Reynolds number rho U R/mu with U = hypot(V, 0.75 Om R): so one table holds for every
// speed, from standing still to windmilling, and for all air. Interpolated by Catmull-Rom cubics over chi
// and the logarithm of the Reynolds number. Axial flow; frame and signs as in blade_element.h. SI, rad.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/propulsion/blade_element.h"

namespace rotorbench {

/// The grid of a map. More points make it more exact and slower to build, not slower to use.
struct PropellerMapSettings {
  int directions = 361;        ///< from straight descent to straight climb, -90 to 90 degrees
  int reynoldsNumbers = 20;    ///< spread evenly over the logarithm
  double leastReynolds = 1e4;  ///< rho U R/mu; below and above the range the nearest end holds
  double mostReynolds = 1e7;
  bool operator==(const PropellerMapSettings&) const = default;
};

/// Thrust along the axis, N, and torque against the rotation, N m.
struct ThrustAndTorque {
  double thrust = 0;
  double torque = 0;
};

class PropellerMap {
 public:
  explicit PropellerMap(const BladeElementRotor& rotor, const PropellerMapSettings& settings = {});

  /// Loads at speed omega, rad/s, in an axial stream, m/s; turning backwards by the rule of
  /// BladeElementRotor::axial(). No heap, no exception; finite for all finite speeds.
  [[nodiscard]] ThrustAndTorque axial(double omega, double axialSpeed, const AirState& air) const {
    const double sign = omega < 0 ? -1 : 1;
    const double along = sign * axialSpeed, across = kReferenceRadius * std::abs(omega) * radius_;
    const double square = along * along + across * across;
    if (!(square > 0) || !(air.density > 0)) return {};
    const double reynolds = air.density * std::sqrt(square) * radius_ / air.viscosity;
    const Cell c = cell(std::atan2(along, across), std::log(reynolds));
    ThrustAndTorque load;
    for (std::size_t i = 0; i < 4; ++i) {
      const ThrustAndTorque* row = &values_[c.first + i * stride_];
      double thrust = 0, torque = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        thrust += c.directionWeight[k] * row[k].thrust;
        torque += c.directionWeight[k] * row[k].torque;
      }
      load.thrust += c.reynoldsWeight[i] * thrust;
      load.torque += c.reynoldsWeight[i] * torque;
    }
    const double scale = sign * 0.5 * air.density * area_ * square;
    return {scale * load.thrust, scale * radius_ * load.torque};
  }

  [[nodiscard]] double radius() const { return radius_; }

 private:
  static constexpr double kReferenceRadius = 0.75;  // r/R

  /// Where the four by four points around a state begin, and their weights.
  struct Cell {
    std::size_t first;
    double directionWeight[4], reynoldsWeight[4];
  };

  static void weigh(double t, double (&weight)[4]) {  // Catmull-Rom
    const double s = 1 - t;
    weight[0] = -0.5 * t * s * s;
    weight[1] = 1 + t * t * (1.5 * t - 2.5);
    weight[2] = 1 + s * s * (1.5 * s - 2.5);
    weight[3] = -0.5 * s * t * t;
  }
  /// Interval and fraction of a coordinate in units of the grid.
  static std::size_t place(double coordinate, double last, double (&weight)[4]) {
    const double inside = std::fmin(std::fmax(coordinate, 0), last);
    const double interval = std::fmin(std::floor(inside), last - 1);
    weigh(inside - interval, weight);
    return static_cast<std::size_t>(interval);
  }
  [[nodiscard]] Cell cell(double direction, double logReynolds) const {
    Cell c;
    const std::size_t k = place((direction + std::numbers::pi / 2) * directionsPerAngle_,
                                lastDirection_, c.directionWeight);
    const std::size_t i =
        place((logReynolds - leastLogReynolds_) * rowsPerLog_, lastRow_, c.reynoldsWeight);
    c.first = i * stride_ + k;
    return c;
  }
  void extrapolateEdges(std::size_t rows);

  std::vector<ThrustAndTorque> values_;  // one more point than the grid on every side
  std::size_t stride_ = 0;
  double directionsPerAngle_ = 0, lastDirection_ = 0;
  double leastLogReynolds_ = 0, rowsPerLog_ = 0, lastRow_ = 0;
  double radius_ = 0, area_ = 0;
};

template <>
struct Describe<PropellerMapSettings> {
  static void fields(schema::Builder<PropellerMapSettings>& b);
};

}  // namespace rotorbench
