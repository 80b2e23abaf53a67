// Runs the tasks of a flight, each at its own rate, in an order that follows from what they read
// and write: whoever reads a signal acts after its writer. The order does not depend on that in
// which tasks were added.
#pragma once

#include <memory>
#include <vector>

#include "sim/core/channel.h"
#include "sim/signal/task.h"

namespace rotorbench {

class Scheduler {
 public:
  /// Takes the tasks and puts them in order. `given` are signals written by no task: the plant's
  /// own. Throws std::logic_error that names task and signal where a signal has two writers, is
  /// read but written by nobody, or is read before it is written without saying so, and where two
  /// tasks have one name.
  Scheduler(std::vector<std::unique_ptr<Task>> tasks, SignalSet given);

  /// Of all tasks in the order they act in.
  [[nodiscard]] std::vector<Channel> channels() const;
  /// The tasks that are due. `row` has room for channels() and is the same at every call. One
  /// virtual call a task.
  void run(const ClockTick& tick, Board& board, double* row) {
    for (Entry& entry : entries_) {
      if (--entry.wait > 0) continue;
      entry.wait = entry.period;
      entry.task->act(tick, board, row + entry.first);
    }
  }
  [[nodiscard]] std::vector<const Task*> order() const;

 private:
  struct Entry {
    std::unique_ptr<Task> task;
    std::int64_t period, wait;  ///< ticks
    std::size_t first;          ///< of its channels
  };
  std::vector<Entry> entries_;
};

}  // namespace rotorbench
