// What every kind of simulation keeps: its runs, its state, its failure. Kinds derive from it and
// fill in advance().
#pragma once

#include "sim/document/experiment.h"
#include "sim/run/simulation.h"

namespace rotorbench {

class SimulationBase : public Simulation {
 public:
  [[nodiscard]] SimulationState state() const override { return state_; }
  [[nodiscard]] const std::vector<RunOutput>& runs() const override { return runs_; }
  [[nodiscard]] const std::optional<RunFailure>& failure() const override { return failure_; }
  [[nodiscard]] double tickSeconds() const override { return tickSeconds_; }
  /// Only kinds that override these take changes.
  std::optional<Problem> change(const Change& change) override;
  [[nodiscard]] const std::vector<Change>& changes() const override;
  void stop() override {
    if (state_ == SimulationState::Running) end(SimulationState::Finished);
  }

 protected:
  explicit SimulationBase(double tickSeconds) : tickSeconds_(tickSeconds) {}

  /// Adds a run; all of them before the first advance(). `share` of them divide the memory limit.
  Recording& addRun(std::string name, std::vector<Channel> channels, const OutputSettings& outputs,
                    std::size_t share = 1);
  /// Says in the run added last why it has no channels of these names.
  void addAbsent(AbsentChannels absent) { runs_.back().absent.push_back(std::move(absent)); }
  void end(SimulationState state);
  void fail(RunFailure failure);
  /// The failure of a recording that reached its memory limit.
  void failFull(double time);

 private:
  double tickSeconds_;
  SimulationState state_ = SimulationState::Running;
  std::vector<RunOutput> runs_;
  std::optional<RunFailure> failure_;
};

/// Every `every`-th tick is recorded, so that rows are outputs.recordInterval apart as nearly as
/// ticks allow.
std::int64_t ticksPerRow(const OutputSettings& outputs, double tickSeconds);

}  // namespace rotorbench
