// Commands on their way to the speed controllers of an experiment, and the course of a tick in
// which some of them begin to act. Times in s.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "sim/ode/status.h"
#include "sim/signal/command_delay.h"

namespace rotorbench {

/// Part of a tick below which two instants are one: rounding.
inline constexpr double kTickRounding = 1e-6;

/// N commands given together once a tick, each with a dead time of its own.
template <int N>
class DelayedCommands {
 public:
  using Command = Eigen::Matrix<double, N, 1>;

  /// Dead times not negative; `tick` above 0.
  DelayedCommands(const std::array<double, N>& deadTimes, double tick)
      : delayed_(std::ranges::any_of(deadTimes, [](double t) { return t > 0; })),
        slack_(kTickRounding * tick) {
    for (const double deadTime : deadTimes) ways_.emplace_back(deadTime, tick);
  }

  /// From `time` on `asked` is the command. What acts at once is put into `acting`.
  void give(double time, const Command& asked, Command& acting) {
    if (!delayed_) {
      acting = asked;
      return;
    }
    for (int i = 0; i < N; ++i) ways_[static_cast<std::size_t>(i)].give(time, asked[i]);
    take(time, acting);
  }
  /// When the next command acts; infinity if none is on its way.
  [[nodiscard]] double next() const {
    double first = std::numeric_limits<double>::infinity();
    if (delayed_)
      for (const CommandDelay& way : ways_) first = std::min(first, way.next());
    return first;
  }
  /// Puts into `acting` all that acts by `time`.
  void take(double time, Command& acting) {
    for (int i = 0; i < N; ++i) {
      CommandDelay& way = ways_[static_cast<std::size_t>(i)];
      while (way.next() <= time + slack_) acting[i] = way.take();
    }
  }

 private:
  std::vector<CommandDelay> ways_;
  bool delayed_;
  double slack_;
};

/// Brings `y` to `end` by advance(time, y), stopping at each instant between at which a command
/// begins to act: act(time) takes it over. Returns the first status that is not Done.
template <class Advance, class State, int N, class Act>
ode::Status advanceWithCommands(Advance&& advance, State& y, const DelayedCommands<N>& commands,
                                double end, double tick, Act&& act) {
  for (double at = commands.next(); at < end - kTickRounding * tick; at = commands.next()) {
    if (const ode::Status s = advance(at, y); s != ode::Status::Done) return s;
    act(at);
  }
  return advance(end, y);
}

}  // namespace rotorbench
