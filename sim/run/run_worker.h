// One run of an experiment on its own thread. The worker builds the Simulation, drives it in slices
// of a few milliseconds and answers pause, step, stop, changes of the flight and of the pace
// between two slices; whoever shows the run polls status() and reads the recordings' published
// rows. Nothing throws across the thread: what goes wrong is part of the status. No Qt here, so
// that the thread sanitizer sees every lock.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/metrics.h"
#include "sim/document/changes.h"
#include "sim/run/simulation.h"

namespace rotorbench {

enum class RunState { Idle, Building, Running, Paused, Finished, Failed, Stopped };

/// True while a worker still has something to do for the run.
[[nodiscard]] constexpr bool isActive(RunState state) {
  return state == RunState::Building || state == RunState::Running || state == RunState::Paused;
}

/// Simulated seconds per second of wall time; 0 or less means as fast as possible.
struct Pace {
  double factor = 0;
  [[nodiscard]] bool unlimited() const { return !(factor > 0); }
  bool operator==(const Pace&) const = default;
};

/// Everything a window shows of a run, copied in one piece.
struct RunStatus {
  RunState state = RunState::Idle;
  Progress progress;
  std::optional<double> secondsLeft;  ///< wall time; empty while it cannot be told
  double wallSeconds = 0;             ///< spent computing
  std::vector<RunOutput> outputs;     ///< empty until the simulation is built
  std::vector<Problem> problems;      ///< why the simulation could not be built
  std::optional<RunFailure> failure;
  MetricTable metrics;            ///< filled at each pause and at the end
  std::vector<Verdict> verdicts;  ///< likewise
  std::vector<RunEvent> events;   ///< likewise, verdicts among them
  /// All changes of the experiment: laid down, or made while it ran. Never null once it is built.
  std::shared_ptr<const std::vector<Change>> changes;
  std::vector<Problem> refused;  ///< changes that could not be made, and why
};

class RunWorker {
 public:
  using Factory = std::function<std::unique_ptr<Simulation>()>;

  /// Starts at once. `factory` is called on the worker's thread and may throw InputError.
  RunWorker(Factory factory, Pace pace, bool startPaused = false);
  /// Stops the run and waits for the thread: at most one slice or the end of the build.
  ~RunWorker();
  RunWorker(const RunWorker&) = delete;
  RunWorker& operator=(const RunWorker&) = delete;

  void pause();
  void resume();
  /// Advances by `seconds` of simulated time (at least one tick), then pauses.
  void step(double seconds);
  /// Ends the run here; recordings and metrics are kept.
  void stop();
  void setPace(Pace pace);
  /// Changes the flight before its next tick, also while it pauses, or at the change's time if that
  /// is still to come. status() says what came of it.
  void change(Change change);
  /// Returns when the run has ended. From the thread that made the worker.
  void wait();
  [[nodiscard]] RunStatus status() const;

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  std::unique_ptr<Simulation> build();
  void drive(Simulation& simulation);
  std::int64_t nextTicks(Simulation& simulation, std::unique_lock<std::mutex>& lock);
  std::int64_t pacedTicks(double tickSeconds, std::unique_lock<std::mutex>& lock);
  void takeChanges(Simulation& simulation, std::unique_lock<std::mutex>& lock);
  void enterPause(Simulation& simulation, std::unique_lock<std::mutex>& lock);
  void anchor(double fraction);
  void afterSlice(std::int64_t ticks, Clock::duration spent, const Progress& progress);
  void finish(Simulation& simulation);
  void fail(RunFailure failure);

  const Factory factory_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;

  // Orders from outside, under mutex_.
  Pace pace_;
  bool stop_ = false;
  bool paused_ = false;
  bool reanchor_ = true;
  double stepSeconds_ = 0;
  std::vector<Change> orders_;

  // What status() shows, under mutex_.
  RunStatus status_;

  // The driving thread's own clockwork.
  std::int64_t sliceTicks_ = 1;
  std::int64_t stepTicks_ = 0;
  bool stepped_ = false;
  std::int64_t anchorTicks_ = 0;  ///< ticks done since the anchor
  Clock::time_point anchorTime_;
  double anchorFraction_ = 0;

  std::thread thread_;
};

}  // namespace rotorbench
