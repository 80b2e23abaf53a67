// Gains of one axis that is a double integrator of an acceleration, behind a hold of one period
// and, if there is one, a first-order lag of the thrust:
//   q'' = a, T a' = u - a,  x = (q, q', a)
//   u = N (r - o) - K (x - o) + I,  I(k+1) = I(k) + g (r - q)
// o is where the axis began. The design is that of the sampled model (sim/design).
#pragma once

#include <Eigen/Core>
#include <complex>

namespace rotorbench {

struct AxisGains {
  double position = 0, rate = 0, acceleration = 0;  ///< K: 1/s^2, 1/s, 1
  double reference = 0;                             ///< N, 1/s^2
  double integral = 0;                              ///< g per update, 1/s^2
  double bleeding = 0;  ///< of what could not be carried out, taken from I in an update
};

/// What the gains of an axis are made for: the period of the controller and the lag of the thrust,
/// s; the lag may be 0.
struct AxisModel {
  double period = 0.002, lag = 0;
};

/// The poles, 1/s: a pair of frequency w and damping zeta, with an integral a real one at -p, with
/// a lag another at -1/lag. N lets the set-point leave the integral's pole alone.
AxisGains placedGains(const AxisModel& model, double frequency, double damping, double integral,
                      bool withIntegral);

/// The least sum of (error/e)^2 + (rate/v)^2 + (integral/s)^2 + (demand/u)^2, the arguments in this
/// order; without an integral its term is none.
AxisGains optimalGains(const AxisModel& model, double error, double rate, double integral,
                       double demand, bool withIntegral);

/// Poles of the closed loop, 1/s, from its sampled ones: as many as states.
Eigen::VectorXcd closedLoopPoles(const AxisModel& model, const AxisGains& gains);

}  // namespace rotorbench
