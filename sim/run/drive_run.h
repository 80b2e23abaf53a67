// One drive on a stand in time: once a tick the commander (a throttle laid down in advance, or a
// speed controller) sets the throttle, the solver brings the drive exactly to the next tick and to
// each instant between at which a command that had to wait begins to act.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/ode/solver.h"
#include "sim/run/delayed_commands.h"
#include "sim/run/drive_build.h"

namespace rotorbench {

/// throttle() is asked once a tick; channels() and row() add to what the stand records; figures()
/// reads the recording. A commander that has reached(t, train, y) is shown every tick's end before
/// the next command acts.
template <class C>
concept DriveCommander = requires(C& c, const C& k, double t, const DriveTrain& train,
                                  const DriveTrain::State& y, double* out, const Recording& r,
                                  std::vector<Metric>& metrics) {
  { c.throttle(t, train, y) } -> std::convertible_to<double>;
  { k.channels() } -> std::convertible_to<std::vector<Channel>>;
  k.row(out);
  k.figures(r, train, metrics);
};

enum class DriveProgress { Going, Ended, Failed, Full };

template <DriveCommander Commander>
class DriveRun {
 public:
  /// `deadTime` in s is that of the speed controller; a row is kept every `ticksPerRow` ticks.
  DriveRun(DriveTrain train, double deadTime, const DriveRunSettings& run, Commander commander,
           std::int64_t ticksPerRow)
      : train_(std::move(train)),
        commander_(std::move(commander)),
        solver_(run.solver, train_),
        y_(train_.initialState()),
        commands_({deadTime}, run.tick),
        duration_(run.duration),
        tick_(run.tick),
        every_(ticksPerRow),
        ticks_(std::max<std::int64_t>(1, std::llround(run.duration / run.tick))) {}
  DriveRun(const DriveRun&) = delete;
  DriveRun& operator=(const DriveRun&) = delete;
  ~DriveRun() = default;

  [[nodiscard]] std::vector<Channel> channels() const {
    std::vector<Channel> channels = driveChannels();
    for (auto& channel : commander_.channels()) channels.push_back(std::move(channel));
    return channels;
  }
  /// Records the first row; the recording must stay and have channels().
  void start(Recording& recording) {
    recording_ = &recording;
    own_ = driveChannels().size();
    row_.resize(recording.channels().size());
    command(0);
    record(0);
  }
  DriveProgress tick() {
    const double end = ++done_ == ticks_ ? duration_ : static_cast<double>(done_) * tick_;
    if (!advanceTo(end)) return DriveProgress::Failed;
    if constexpr (requires { commander_.reached(end, train_, y_); })
      commander_.reached(end, train_, y_);
    const bool empty = train_.instant(y_).busVoltage < train_.supply().cutOff;
    const bool last = done_ == ticks_ || empty;
    if (!last) command(end);
    if ((done_ % every_ == 0 || last) && !record(end)) return DriveProgress::Full;
    // An empty battery is how such a run ends, not a failure of it.
    return last ? DriveProgress::Ended : DriveProgress::Going;
  }

  [[nodiscard]] double time() const { return solver_.time(); }
  [[nodiscard]] double fraction() const {
    return static_cast<double>(done_) / static_cast<double>(ticks_);
  }
  [[nodiscard]] RunFailure failure() const { return solver_.runFailure(); }
  [[nodiscard]] std::vector<Metric> figures() const {
    std::vector<Metric> metrics;
    commander_.figures(*recording_, train_, metrics);
    return metrics;
  }
  [[nodiscard]] const DriveTrain& train() const { return train_; }
  [[nodiscard]] Commander& commander() { return commander_; }

 private:
  using Throttle = DelayedCommands<1>::Command;

  bool advanceTo(double end) {
    const auto act = [this](double time) {
      Throttle acting(train_.throttle());
      commands_.take(time, acting);
      set(acting[0]);
    };
    const auto step = [this](double to, auto& y) { return solver_.advanceTo(to, y); };
    return advanceWithCommands(step, y_, commands_, end, tick_, act) != ode::Status::Failed;
  }
  void command(double time) {
    asked_ = train_.allowedThrottle(commander_.throttle(time, train_, y_));
    Throttle acting(train_.throttle());
    commands_.give(time, Throttle(asked_), acting);
    set(acting[0]);
  }
  void set(double throttle) {
    if (throttle == train_.throttle()) return;
    train_.setThrottle(throttle, y_);
    solver_.restart();
  }
  bool record(double time) {
    driveRow(train_, time, asked_, y_, row_.data());
    commander_.row(row_.data() + own_);
    return recording_->append(row_);
  }

  DriveTrain train_;
  Commander commander_;
  ode::Solver<DriveTrain> solver_;
  DriveTrain::State y_;
  DelayedCommands<1> commands_;
  double duration_, tick_, asked_ = 0;
  std::int64_t every_, ticks_, done_ = 0;
  std::size_t own_ = 0;
  std::vector<double> row_;
  Recording* recording_ = nullptr;
};

}  // namespace rotorbench
