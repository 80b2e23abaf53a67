// A turning motor in the steady state whose torques are polynomials of its speed: friction a
// straight line, a load by the square. What fits constants to measured points solves.
//   v = R i + K w,   i = i_0 + i_1 w + i_2 w^2
// SI units.
#pragma once

#include <algorithm>
#include <cmath>

namespace rotorbench {

/// The current that carries friction and load, torques over K, at a speed in rad/s, not negative.
struct SteadyCurrent {
  double constant = 0;   ///< i_0, A
  double linear = 0;     ///< i_1, A s/rad
  double quadratic = 0;  ///< i_2, A s^2/rad^2

  [[nodiscard]] double at(double w) const { return constant + (linear + quadratic * w) * w; }
};

/// w in rad/s at a terminal voltage v in V, for a torque constant K in V s/rad and a resistance in
/// Ohm. Negative where v does not carry i_0 at rest.
[[nodiscard]] inline double steadySpeed(const SteadyCurrent& current, double torqueConstant,
                                        double resistance, double v) {
  const double a = resistance * current.quadratic;
  const double b = torqueConstant + resistance * current.linear;
  const double c = resistance * current.constant - v;
  // The stable form: no difference of nearly equal numbers where a is small.
  return -2 * c / (b + std::sqrt(std::max(0.0, b * b - 4 * a * c)));
}

}  // namespace rotorbench
