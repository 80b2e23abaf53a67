// A transport delay: a command acts a fixed time after it was given, exactly and not rounded to the
// step of whoever gives it. Times in s, the value in whatever unit the command has.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace rotorbench {

class CommandDelay {
 public:
  /// `delay` not negative; commands are given at least `interval` (above 0) apart, but for
  /// rounding.
  CommandDelay(double delay, double interval)
      : delay_(delay), waiting_(static_cast<std::size_t>(std::ceil(delay / interval)) + 2) {}

  /// From `time` on the command is `value`. Times must not fall. No heap use.
  void give(double time, double value) {
    if (value == last_) return;
    last_ = value;
    if (count_ == waiting_.size()) --count_;  // never with commands as far apart as promised
    waiting_[(first_ + count_++) % waiting_.size()] = {time + delay_, value};
  }
  /// When the next command acts; infinity if none is on its way.
  [[nodiscard]] double next() const {
    return count_ > 0 ? waiting_[first_].time : std::numeric_limits<double>::infinity();
  }
  /// The command that acts at next(), which must be finite.
  double take() {
    const double value = waiting_[first_].value;
    first_ = (first_ + 1) % waiting_.size();
    --count_;
    return value;
  }

 private:
  struct Command {
    double time, value;
  };
  double delay_;
  double last_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<Command> waiting_;  // a ring
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace rotorbench
