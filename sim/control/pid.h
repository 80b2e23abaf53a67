// A discrete PID controller: proportional part with set-point weight, derivative of the measurement
// through a first-order filter, integral with back-calculation against wind-up.
//   K. J. Astrom, R. M. Murray, Feedback Systems, ch. 10; Astrom, Hagglund, PID Controllers, 1995,
//     ch. 3.
// The output is an acceleration demand, so that gains carry over from vehicle to vehicle: the
// caller multiplies by mass or inertia.
#pragma once

#include <algorithm>
#include <array>

#include "sim/control/lanes.h"
#include "sim/control/pid_parameters.h"
#include "sim/core/place.h"

namespace rotorbench {

/// What the settings amount to at one interval between updates.
template <class Real>
struct PidGains {
  Real kp{}, ki{}, weight{}, filter{}, slope{}, tracking{}, limit{};
};

template <PidUse Use>
PidGains<double> pidGains(const PidParameters<Use>& p, double interval) {
  PidGains<double> g;
  g.kp = p.kp;
  g.ki = p.ki * interval;
  g.weight = p.setPointWeight;
  g.filter = p.filterTime / (p.filterTime + interval);
  g.slope = p.kd / (p.filterTime + interval);
  // Without an integral there is nothing to bleed.
  g.tracking = g.ki != 0 ? std::min(1.0, interval / p.trackingTime) : 0;
  g.limit = p.limit;
  return g;
}

/// The gains of several controllers, one lane each.
template <int N>
PidGains<Lanes<N>> besides(const std::array<PidGains<double>, N>& each) {
  PidGains<Lanes<N>> g;
  for (int i = 0; i < N; ++i) {
    const PidGains<double>& one = each[static_cast<std::size_t>(i)];
    g.kp[i] = one.kp, g.ki[i] = one.ki, g.weight[i] = one.weight, g.filter[i] = one.filter;
    g.slope[i] = one.slope, g.tracking[i] = one.tracking, g.limit[i] = one.limit;
  }
  return g;
}

template <class Real>
class BasicPid {
 public:
  explicit BasicPid(const PidGains<Real>& gains) : g_(gains) {}
  template <PidUse Use>
  BasicPid(const PidParameters<Use>& p, double interval) : g_(pidGains(p, interval)) {}

  /// The demand for this instant, within the limit; follow with accept(). The first call starts
  /// from rest: a set-point equal to the first measurement asks for nothing.
  Real propose(const Real& setPoint, const Real& measurement) {
    if (!started_) {
      started_ = true;
      origin_ = previous_ = measurement;
    }
    derivative_ = g_.filter * derivative_ - g_.slope * (measurement - previous_);
    previous_ = measurement;
    error_ = setPoint - measurement;
    raw_ = g_.kp * (g_.weight * (setPoint - origin_) - (measurement - origin_)) + integral_ +
           derivative_;
    return clamped(raw_, Real(-g_.limit), g_.limit);
  }

  /// Ends the instant with the demand that could be carried out; what is missing bleeds the
  /// integral.
  void accept(const Real& carriedOut) {
    integral_ += g_.ki * error_ + g_.tracking * (carriedOut - raw_);
  }

  /// Other gains from the next instant on, without a bump (Astrom, Hagglund, section 3.5): the
  /// integral takes up what the proportional part changes by at what was last seen, the derivative
  /// goes over within its filter time. Where the new gains have no integral, nothing can take the
  /// difference up, and the new proportional part acts at once.
  void retune(const PidGains<Real>& gains) {
    if (started_) {
      const Real difference = proportional(g_) - proportional(gains);
      integral_ += whereNot0(gains.ki, difference);
    }
    g_ = gains;
  }

  [[nodiscard]] const Real& integral() const { return integral_; }

 private:
  /// The part that these gains give to what was last seen.
  [[nodiscard]] Real proportional(const PidGains<Real>& g) const {
    const Real setPoint = error_ + previous_;
    return g.kp * (g.weight * (setPoint - origin_) - (previous_ - origin_));
  }

  PidGains<Real> g_;
  Real integral_ = allLanes<Real>(0), derivative_ = allLanes<Real>(0);
  Real previous_{}, origin_{}, error_{}, raw_{};
  bool started_ = false;
};

using Pid = BasicPid<double>;

/// Ticks between two updates at `rate` Hz, which is described at `place`. Throws InputError unless
/// it is a whole number of at least one.
int ticksBetween(double rate, double tick, const Place& place);

}  // namespace rotorbench
