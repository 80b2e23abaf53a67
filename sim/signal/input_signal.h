// Values laid down over time: the inputs of rotors, a timeline of set-points, a throttle.
#pragma once

#include <utility>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

/// Between two instants of a table: the earlier value, or a straight line.
enum class Interpolation { Hold, Linear };

/// The choice as documents offer it.
inline std::vector<schema::Named<Interpolation>> interpolations() {
  return {{Interpolation::Hold, "hold", "Hold", "Each value stays until the next instant."},
          {Interpolation::Linear, "linear", "Linear", "Straight lines between the instants."}};
}

/// A prescribed signal ready to be read in the order of time; no heap use in at(). Value: a number,
/// or a fixed-size vector of numbers that are read together.
template <class Value>
class InputSignal {
 public:
  struct Sample {
    double time;  ///< s
    Value values;
  };
  InputSignal() = default;
  /// `samples` in rising order of time, at least one.
  InputSignal(std::vector<Sample> samples, Interpolation interpolation)
      : samples_(std::move(samples)), interpolation_(interpolation) {}

  /// Values at time t; the first ones before the first instant, the last ones after the last. Fast
  /// for times that rise from call to call.
  Value at(double t) {
    seek(t);
    const Sample& before = samples_[index_];
    if (interpolation_ == Interpolation::Hold || index_ + 1 == samples_.size() || t <= before.time)
      return before.values;
    const Sample& after = samples_[index_ + 1];
    const double share = (t - before.time) / (after.time - before.time);
    return before.values + share * (after.values - before.values);
  }
  [[nodiscard]] Interpolation interpolation() const { return interpolation_; }

 private:
  void seek(double t) {
    if (t < samples_[index_].time) index_ = 0;
    while (index_ + 1 < samples_.size() && samples_[index_ + 1].time <= t) ++index_;
  }

  std::vector<Sample> samples_;
  Interpolation interpolation_ = Interpolation::Hold;
  std::size_t index_ = 0;
};

}  // namespace rotorbench
