// The hybrid simulation of a drive on a stand: once a tick the commander (a throttle laid down in advance, or a speed
// controller) sets the throttle, the solver brings the drive exactly to the next tick.
#pragma once

#include <concepts>
#include <utility>
#include <vector>

#include "sim/experiment/drive_stand.h"
#include "sim/experiment/simulation_base.h"
#include "sim/ode/solver.h"

namespace rotorbench {

/// throttle() is asked once a tick; channels() and row() add to what the stand records; figures() reads the recording.
template <class C>
concept DriveCommander = requires(C& c, const C& k, double t, const DriveTrain& train,
                                  const DriveTrain::State& y, double* out, const Recording& r,
                                  std::vector<Metric>& metrics) {
  { c.throttle(t, train, y) } -> std::convertible_to<double>;
  { k.channels() } -> std::convertible_to<std::vector<Channel>>;
  k.row(out);
  k.figures(r, train, metrics);
};

template <DriveCommander Commander>
class DriveSimulation : public SimulationBase {
 public:
  DriveSimulation(const DriveStand& stand, const DriveRunSettings& run,
                  const OutputSettings& outputs, Commander commander, std::size_t share = 1)
      : SimulationBase(run.tick),
        train_(buildDriveTrain(stand)),
        commander_(std::move(commander)),
        solver_(run.solver, train_),
        y_(train_.initialState()),
        duration_(run.duration),
        every_(ticksPerRow(outputs, run.tick)),
        ticks_(std::max<std::int64_t>(1, std::llround(run.duration / run.tick))) {
    std::vector<Channel> channels = driveChannels();
    own_ = channels.size();
    for (auto& channel : commander_.channels()) channels.push_back(std::move(channel));
    row_.resize(channels.size());
    recording_ = &addRun("Run", std::move(channels), outputs, share);
    command(0);
    record(0);
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    recording_->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    return {static_cast<double>(done_) / static_cast<double>(ticks_), solver_.time(), "running"};
  }

  [[nodiscard]] MetricTable metrics() const override {
    MetricRow row{runs().front().name, {}};
    commander_.figures(*recording_, train_, row.metrics);
    return {row};
  }

 protected:
  [[nodiscard]] const DriveTrain& train() const { return train_; }

 private:
  void tick() {
    const double end = ++done_ == ticks_ ? duration_ : static_cast<double>(done_) * tickSeconds();
    if (solver_.advanceTo(end, y_) == ode::Status::Failed) return fail(solver_.runFailure());
    const double voltage = train_.instant(y_).busVoltage;
    const bool empty = voltage < train_.supply().cutOff;
    const bool last = done_ == ticks_ || empty;
    if (!last) command(end);
    if ((done_ % every_ == 0 || last) && !record(end)) return failFull(end);
    // An empty battery is how such a run ends, not a failure of it.
    if (last) this->end(SimulationState::Finished);
  }

  void command(double time) {
    const double before = train_.throttle();
    train_.setThrottle(commander_.throttle(time, train_, y_), y_);
    if (train_.throttle() != before) solver_.restart();
  }

  bool record(double time) {
    driveRow(train_, time, y_, row_.data());
    commander_.row(row_.data() + own_);
    return recording_->append(row_);
  }

  DriveTrain train_;
  Commander commander_;
  ode::Solver<DriveTrain> solver_;
  DriveTrain::State y_;
  double duration_;
  std::int64_t every_, ticks_, done_ = 0;
  std::size_t own_ = 0;
  std::vector<double> row_;
  Recording* recording_ = nullptr;
};

}  // namespace rotorbench
