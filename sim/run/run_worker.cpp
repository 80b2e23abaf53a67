#include "sim/run/run_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace rotorbench {

namespace {

using namespace std::chrono_literals;

// A slice aims at half of the 10 ms within which an order must be obeyed.
constexpr auto kSliceGoal = 5ms;
constexpr std::int64_t kLongestSlice = std::int64_t{1} << 30;
// Paced runs advance in batches of about this length: smooth to the eye, cheap to wake for.
constexpr double kPacedBatch = 0.004;
// A run that cannot keep its pace by more than this starts counting afresh instead of racing after
// it.
constexpr double kLargestLag = 0.25;

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

RunWorker::RunWorker(Factory factory, Pace pace, bool startPaused)
    : factory_(std::move(factory)), pace_(pace), paused_(startPaused) {
  status_.state = RunState::Building;
  thread_ = std::thread([this] { run(); });
}

RunWorker::~RunWorker() {
  stop();
  wait();
}

void RunWorker::wait() {
  if (thread_.joinable()) thread_.join();
}

void RunWorker::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  wake_.notify_all();
}

void RunWorker::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  reanchor_ = true;
  wake_.notify_all();
}

void RunWorker::step(double seconds) {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  stepSeconds_ += seconds;
  wake_.notify_all();
}

void RunWorker::stop() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
  wake_.notify_all();
}

void RunWorker::setPace(Pace pace) {
  const std::lock_guard lock(mutex_);
  pace_ = pace;
  reanchor_ = true;
  wake_.notify_all();
}

void RunWorker::change(Change change) {
  const std::lock_guard lock(mutex_);
  orders_.push_back(std::move(change));
  wake_.notify_all();
}

RunStatus RunWorker::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void RunWorker::run() {
  // Last line of defence: whatever a model throws against its contract ends as a failed run.
  try {
    const std::unique_ptr<Simulation> simulation = build();
    if (simulation) drive(*simulation);
  } catch (const std::bad_alloc&) {
    fail({status().progress.time, "memory", "The computer ran out of memory."});
  } catch (const std::exception& error) {
    fail({status().progress.time, "", error.what()});
  }
}

std::unique_ptr<Simulation> RunWorker::build() {
  try {
    std::unique_ptr<Simulation> simulation = factory_();
    const std::lock_guard lock(mutex_);
    status_.outputs = simulation->runs();
    status_.progress = simulation->progress();
    status_.changes = std::make_shared<const std::vector<Change>>(simulation->changes());
    status_.state = RunState::Running;
    return simulation;
  } catch (const InputError& error) {
    const std::lock_guard lock(mutex_);
    status_.problems = error.problems();
    status_.failure =
        RunFailure{0, error.source(), "The experiment has values that cannot be run."};
    status_.state = RunState::Failed;
    return nullptr;
  }
}

void RunWorker::drive(Simulation& simulation) {
  while (simulation.state() == SimulationState::Running) {
    std::int64_t ticks = 0;
    {
      std::unique_lock lock(mutex_);
      ticks = nextTicks(simulation, lock);
      if (stop_) break;
    }
    if (ticks == 0) continue;
    const auto begin = Clock::now();
    simulation.advance(ticks);
    afterSlice(ticks, Clock::now() - begin, simulation.progress());
  }
  finish(simulation);
}

// How many ticks to compute now; 0 after a wait that an order or a deadline ended.
std::int64_t RunWorker::nextTicks(Simulation& simulation, std::unique_lock<std::mutex>& lock) {
  if (stop_) return 0;
  if (!orders_.empty()) takeChanges(simulation, lock);
  const double tick = simulation.tickSeconds();
  if (stepSeconds_ > 0) {
    stepTicks_ += std::max<std::int64_t>(1, std::llround(stepSeconds_ / tick));
    stepSeconds_ = 0;
  }
  if (paused_) {
    if (stepTicks_ > 0) return std::min(stepTicks_, sliceTicks_);
    enterPause(simulation, lock);
    return 0;
  }
  stepTicks_ = 0;
  if (status_.state == RunState::Paused) status_.state = RunState::Running;
  if (reanchor_) anchor(status_.progress.fraction);
  return pace_.unlimited() ? sliceTicks_ : pacedTicks(tick, lock);
}

// Deadlines are absolute (anchor + ticks * tick / pace), so waits that end late do not add up.
std::int64_t RunWorker::pacedTicks(double tickSeconds, std::unique_lock<std::mutex>& lock) {
  const double elapsed = seconds(Clock::now() - anchorTime_);
  const double due = elapsed * pace_.factor / tickSeconds;
  const auto ready = static_cast<std::int64_t>(due) - anchorTicks_;
  if (ready <= 0) {
    const double next = static_cast<double>(anchorTicks_ + 1) * tickSeconds / pace_.factor;
    const double wait = std::max(next, elapsed + kPacedBatch);
    wake_.wait_until(lock, anchorTime_ + std::chrono::duration_cast<Clock::duration>(
                                             std::chrono::duration<double>(wait)));
    return 0;
  }
  const std::int64_t ticks = std::min(ready, sliceTicks_);
  if (static_cast<double>(ready) * tickSeconds / pace_.factor > kLargestLag) reanchor_ = true;
  return ticks;
}

void RunWorker::takeChanges(Simulation& simulation, std::unique_lock<std::mutex>& lock) {
  const std::vector<Change> orders = std::exchange(orders_, {});
  lock.unlock();
  std::vector<Problem> refused;
  for (const Change& order : orders)
    if (auto problem = simulation.change(order)) refused.push_back(std::move(*problem));
  auto changes = std::make_shared<const std::vector<Change>>(simulation.changes());
  lock.lock();
  status_.changes = std::move(changes);
  for (Problem& problem : refused) status_.refused.push_back(std::move(problem));
}

void RunWorker::enterPause(Simulation& simulation, std::unique_lock<std::mutex>& lock) {
  if (status_.state != RunState::Paused || stepped_) {
    stepped_ = false;
    lock.unlock();
    MetricTable metrics = simulation.metrics();
    std::vector<Verdict> verdicts = simulation.verdicts();
    std::vector<RunEvent> events = simulation.events();
    lock.lock();
    status_.metrics = std::move(metrics);
    status_.verdicts = std::move(verdicts);
    status_.events = std::move(events);
    status_.secondsLeft.reset();
    status_.state = RunState::Paused;
  }
  wake_.wait(lock, [this] { return stop_ || !paused_ || stepSeconds_ > 0 || !orders_.empty(); });
  reanchor_ = true;
}

void RunWorker::anchor(double fraction) {
  anchorTime_ = Clock::now();
  anchorTicks_ = 0;
  anchorFraction_ = fraction;
  reanchor_ = false;
}

void RunWorker::afterSlice(std::int64_t ticks, Clock::duration spent, const Progress& progress) {
  const double ratio = seconds(kSliceGoal) / std::max(seconds(spent), 1e-9);
  const double wanted = static_cast<double>(ticks) * std::clamp(ratio, 0.1, 2.0);
  // A slice cut short by the pace tells only that longer ones are allowed.
  if (ticks == sliceTicks_ || ratio < 1) {
    sliceTicks_ = std::clamp<std::int64_t>(static_cast<std::int64_t>(wanted), 1, kLongestSlice);
  }
  anchorTicks_ += ticks;
  const std::lock_guard lock(mutex_);
  if (stepTicks_ > 0) {
    stepTicks_ -= ticks;
    stepped_ = true;
  }
  status_.progress = progress;
  status_.wallSeconds += seconds(spent);
  const double gained = progress.fraction - anchorFraction_;
  if (!paused_ && gained > 0) {
    status_.secondsLeft =
        seconds(Clock::now() - anchorTime_) * std::max(0.0, 1 - progress.fraction) / gained;
  }
}

void RunWorker::finish(Simulation& simulation) {
  const bool stopped = simulation.state() == SimulationState::Running;
  if (stopped) simulation.stop();
  MetricTable metrics = simulation.metrics();
  std::vector<Verdict> verdicts = simulation.verdicts();
  std::vector<RunEvent> events = simulation.events();
  std::unique_lock lock(mutex_);
  if (!orders_.empty()) takeChanges(simulation, lock);  // too late: they are refused
  status_.metrics = std::move(metrics);
  status_.verdicts = std::move(verdicts);
  status_.events = std::move(events);
  status_.progress = simulation.progress();
  status_.secondsLeft.reset();
  status_.failure = simulation.failure();
  status_.state = simulation.state() == SimulationState::Failed ? RunState::Failed
                  : stopped                                     ? RunState::Stopped
                                                                : RunState::Finished;
}

void RunWorker::fail(RunFailure failure) {
  const std::lock_guard lock(mutex_);
  for (const RunOutput& output : status_.outputs) output.recording->finish();
  status_.failure = std::move(failure);
  status_.secondsLeft.reset();
  status_.state = RunState::Failed;
}

}  // namespace rotorbench
