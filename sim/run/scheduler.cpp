#include "sim/run/scheduler.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rotorbench {

namespace {

using Tasks = std::vector<std::unique_ptr<Task>>;

/// The writer of each signal; -1: nobody.
std::array<int, kSignals> writersOf(const Tasks& tasks) {
  std::array<int, kSignals> writers;
  writers.fill(-1);
  for (int i = 0; i < static_cast<int>(tasks.size()); ++i) {
    const Task& task = *tasks[static_cast<std::size_t>(i)];
    for (int s = 0; s < kSignals; ++s) {
      if (!task.uses().writes.has(static_cast<Signal>(s))) continue;
      int& writer = writers[static_cast<std::size_t>(s)];
      if (writer >= 0)
        throw std::logic_error(std::string(nameOf(static_cast<Signal>(s))) + " is written by " +
                               tasks[static_cast<std::size_t>(writer)]->name() + " and by " +
                               task.name());
      writer = i;
    }
  }
  return writers;
}

/// after[i]: the tasks that must have acted before task i.
std::vector<std::vector<int>> predecessorsOf(const Tasks& tasks, SignalSet given) {
  const auto writers = writersOf(tasks);
  std::vector<std::vector<int>> before(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const SignalUse uses = tasks[i]->uses();
    for (int s = 0; s < kSignals; ++s) {
      const auto signal = static_cast<Signal>(s);
      const int writer = writers[static_cast<std::size_t>(s)];
      if (!uses.reads.has(signal) && !uses.readsEarlier.has(signal)) continue;
      if (writer < 0 && !given.has(signal))
        throw std::logic_error(tasks[i]->name() + " reads " + nameOf(signal) +
                               ", which nobody writes");
      if (uses.reads.has(signal) && writer >= 0 && writer != static_cast<int>(i))
        before[i].push_back(writer);
    }
  }
  return before;
}

}  // namespace

Scheduler::Scheduler(Tasks tasks, SignalSet given) {
  std::ranges::sort(tasks, {}, [](const auto& task) { return task->name(); });
  const auto same = std::ranges::adjacent_find(
      tasks, {}, [](const auto& task) -> const std::string& { return task->name(); });
  if (same != tasks.end()) throw std::logic_error("two tasks are named " + (*same)->name());
  const auto before = predecessorsOf(tasks, given);
  std::size_t first = 0;
  std::vector<bool> done(tasks.size(), false);
  for (std::size_t count = 0; count < tasks.size(); ++count) {
    std::size_t next = 0;
    const auto ready = [&](std::size_t i) {
      return !done[i] && std::ranges::all_of(
                             before[i], [&](int k) { return done[static_cast<std::size_t>(k)]; });
    };
    while (next < tasks.size() && !ready(next)) ++next;
    if (next == tasks.size()) {
      std::string circle;
      for (std::size_t i = 0; i < tasks.size(); ++i)
        if (!before[i].empty() && tasks[i] != nullptr && !done[i])
          circle += (circle.empty() ? "" : ", ") + tasks[i]->name();
      throw std::logic_error("each of these reads what another writes later in the same tick: " +
                             circle + "; one must read the signal of an earlier tick and say so");
    }
    done[next] = true;
    const Timing timing = tasks[next]->timing();
    const std::size_t width = tasks[next]->channels().size();
    entries_.push_back({std::move(tasks[next]), timing.period, timing.offset + 1, first});
    first += width;
  }
}

std::vector<Channel> Scheduler::channels() const {
  std::vector<Channel> all;
  for (const Entry& entry : entries_)
    for (Channel& channel : entry.task->channels()) all.push_back(std::move(channel));
  return all;
}

std::vector<const Task*> Scheduler::order() const {
  std::vector<const Task*> tasks;
  for (const Entry& entry : entries_) tasks.push_back(entry.task.get());
  return tasks;
}

}  // namespace rotorbench
