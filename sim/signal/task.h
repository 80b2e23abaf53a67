// The unit of extension of a flight: something that acts at a rate of its own, reads and writes
// signals, and declares what it adds to each recorded row. The scheduler (sim/run/scheduler.h) puts
// tasks in order by what they read and write.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/channel.h"
#include "sim/signal/signals.h"

namespace rotorbench {

/// An instant at which tasks act, and how long until the next, s.
struct ClockTick {
  double time = 0;
  double length = 0;
};

/// In ticks: acts at offset, offset + period, ... Period at least 1, offset not negative.
struct Timing {
  std::int64_t period = 1;
  std::int64_t offset = 0;
};

struct SignalUse {
  SignalSet reads;   ///< as of this tick: written before, in the same tick
  SignalSet writes;  ///< one writer a signal
  /// As of an earlier tick: whoever writes them may act later in the tick. Says so because it is a
  /// delay.
  SignalSet readsEarlier;
};

class Task {
 public:
  /// `name` is unique in a flight and decides between tasks that do not depend on each other.
  Task(std::string name, Timing timing) : name_(std::move(name)), timing_(timing) {}
  virtual ~Task() = default;
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Timing& timing() const { return timing_; }
  [[nodiscard]] virtual SignalUse uses() const = 0;
  /// What act() writes into its part of the row, in this order.
  [[nodiscard]] virtual std::vector<Channel> channels() const { return {}; }
  /// Acts. `row` has room for channels() and keeps what was written until the next time. No heap
  /// and no exception.
  virtual void act(const ClockTick& tick, Board& board, double* row) = 0;

 private:
  std::string name_;
  Timing timing_;
};

/// "rotor2.thrust" for a quantity of rotor 2, numbered from 1.
inline std::string rotorChannel(int rotor, const std::string& name) {
  return "rotor" + std::to_string(rotor) + "." + name;
}

}  // namespace rotorbench
