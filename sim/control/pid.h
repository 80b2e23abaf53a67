// A discrete PID controller: proportional part with set-point weight, derivative of the measurement
// through a first-order filter, integral with back-calculation against wind-up.
//   K. J. Astrom, R. M. Murray, Feedback Systems, ch. 10; Astrom, Hagglund, PID Controllers, 1995,
//     ch. 3.
// The output is an acceleration demand, so that gains carry over from vehicle to vehicle: the
// caller multiplies by mass or inertia.
#pragma once

#include <algorithm>

#include "sim/core/place.h"
#include "sim/core/schema.h"

namespace rotorbench {

/// What a PID acts on: decides units and nothing else.
enum class PidUse { Height, Angle, RotorSpeed };

template <PidUse Use>
struct PidParameters {
  double kp = 0;              ///< 1/s^2 (rotor speed: 1/s)
  double ki = 0;              ///< 1/s^3 (rotor speed: 1/s^2)
  double kd = 0;              ///< 1/s (rotor speed: 1)
  double setPointWeight = 1;  ///< b, 0..1: part of the set-point the proportional term sees
  double filterTime = 0.01;   ///< T_f of the derivative, s
  double trackingTime = 0.5;  ///< T_t of the back-calculation, s
  double limit = 10;          ///< largest demand, m/s^2 or rad/s^2
  bool operator==(const PidParameters&) const = default;
};

class Pid {
 public:
  template <PidUse Use>
  Pid(const PidParameters<Use>& p, double interval)
      : kp_(p.kp),
        ki_(p.ki * interval),
        weight_(p.setPointWeight),
        filter_(p.filterTime / (p.filterTime + interval)),
        slope_(p.kd / (p.filterTime + interval)),
        tracking_(std::min(1.0, interval / p.trackingTime)),
        limit_(p.limit) {}

  /// The demand for this instant, within the limit; follow with accept(). The first call starts
  /// from rest: a set-point equal to the first measurement asks for nothing.
  double propose(double setPoint, double measurement) {
    if (!started_) {
      started_ = true;
      origin_ = previous_ = measurement;
    }
    derivative_ = filter_ * derivative_ - slope_ * (measurement - previous_);
    previous_ = measurement;
    error_ = setPoint - measurement;
    const double proportional = kp_ * (weight_ * (setPoint - origin_) - (measurement - origin_));
    raw_ = proportional + integral_ + derivative_;
    return std::clamp(raw_, -limit_, limit_);
  }

  /// Ends the instant with the demand that could be carried out; what is missing bleeds the
  /// integral.
  void accept(double carriedOut) {
    if (ki_ != 0) integral_ += ki_ * error_ + tracking_ * (carriedOut - raw_);
  }

  [[nodiscard]] double integral() const { return integral_; }

 private:
  double kp_, ki_, weight_, filter_, slope_, tracking_, limit_;
  double integral_ = 0, derivative_ = 0, previous_ = 0, origin_ = 0, error_ = 0, raw_ = 0;
  bool started_ = false;
};

/// Ticks between two updates at `rate` Hz, which is described at `place`. Throws InputError unless
/// it is a whole number of at least one.
int ticksBetween(double rate, double tick, const Place& place);

template <>
struct Describe<PidParameters<PidUse::Height>> {
  static void fields(schema::Builder<PidParameters<PidUse::Height>>& b);
};
template <>
struct Describe<PidParameters<PidUse::Angle>> {
  static void fields(schema::Builder<PidParameters<PidUse::Angle>>& b);
};
template <>
struct Describe<PidParameters<PidUse::RotorSpeed>> {
  static void fields(schema::Builder<PidParameters<PidUse::RotorSpeed>>& b);
};

}  // namespace rotorbench
