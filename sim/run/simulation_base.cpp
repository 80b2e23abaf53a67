#include "sim/run/simulation_base.h"

#include <algorithm>
#include <cmath>

#include "sim/document/changes.h"

namespace rotorbench {

std::optional<Problem> SimulationBase::change(const Change& change) {
  return Problem{change.parameter, "cannot change while this experiment runs",
                 "only flights take changes; all else needs a new run"};
}

const std::vector<Change>& SimulationBase::changes() const {
  static const std::vector<Change> kNone;
  return kNone;
}

Recording& SimulationBase::addRun(std::string name, std::vector<Channel> channels,
                                  const OutputSettings& outputs, std::size_t share) {
  const RecordingLimits limits{
      static_cast<std::size_t>(outputs.memoryLimit) / std::max<std::size_t>(1, share),
      outputs.thinWhenFull ? WhenFull::Thin : WhenFull::Stop};
  runs_.push_back({std::move(name), std::make_shared<Recording>(std::move(channels), limits)});
  return *runs_.back().recording;
}

void SimulationBase::end(SimulationState state) {
  for (const auto& run : runs_) run.recording->finish();
  state_ = state;
}

void SimulationBase::fail(RunFailure failure) {
  failure_ = std::move(failure);
  end(SimulationState::Failed);
}

void SimulationBase::failFull(double time) {
  fail({time, "recording",
        "the memory limit of the recording is reached; raise outputs.memoryLimit or "
        "outputs.recordInterval, or let "
        "it thin out"});
}

std::int64_t ticksPerRow(const OutputSettings& outputs, double tickSeconds) {
  return std::max<std::int64_t>(1, std::llround(outputs.recordInterval / tickSeconds));
}

}  // namespace rotorbench
