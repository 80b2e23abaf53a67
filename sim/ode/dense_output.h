// The solution between the two ends of a step, as a polynomial in theta = (t - start) / step.
// RK5(4)7M brings its free fourth-order interpolant (Hairer, Norsett, Wanner I, section II.6, in
// the nested form of CONTD5); all other methods use the cubic Hermite polynomial through both ends,
// which is the same form with c[4] = 0.
#pragma once

#include <array>

namespace rotorbench::ode {

template <class State>
struct DenseOutput {
  double start = 0;  ///< s
  double step = 0;   ///< s
  std::array<State, 5> c;

  /// The state at time t in s, meant for start <= t <= start + step.
  [[nodiscard]] State at(double t) const {
    const double theta = (t - start) / step;
    const double rest = 1.0 - theta;
    return c[0] + theta * (c[1] + rest * (c[2] + theta * (c[3] + rest * c[4])));
  }

  /// Cubic Hermite polynomial through (y0, f0) at t0 and (y1, f1) at t0 + h.
  void setHermite(double t0, double h, const State& y0, const State& f0, const State& y1,
                  const State& f1) {
    start = t0;
    step = h;
    c[0] = y0;
    c[1] = y1 - y0;
    c[2] = h * f0 - c[1];
    c[3] = c[1] - h * f1 - c[2];
    c[4].setZero();
  }
};

}  // namespace rotorbench::ode
