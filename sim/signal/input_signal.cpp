#include "sim/signal/input_signal.h"

#include <utility>

namespace rotorbench {

InputSignal::InputSignal(std::vector<Sample> samples, Interpolation interpolation)
    : samples_(std::move(samples)), interpolation_(interpolation) {}

void InputSignal::seek(double t) {
  if (t < samples_[index_].time) index_ = 0;
  while (index_ + 1 < samples_.size() && samples_[index_ + 1].time <= t) ++index_;
}

Eigen::Vector4d InputSignal::at(double t) {
  seek(t);
  const Sample& before = samples_[index_];
  if (interpolation_ == Interpolation::Hold || index_ + 1 == samples_.size() || t <= before.time) {
    return before.values;
  }
  const Sample& after = samples_[index_ + 1];
  const double share = (t - before.time) / (after.time - before.time);
  return before.values + share * (after.values - before.values);
}

}  // namespace rotorbench
