#include "sim/run/builders.h"

#include <algorithm>
#include <cmath>

#include "sim/document/propeller_bench.h"
#include "sim/run/propeller_track.h"
#include "sim/run/simulation.h"
#include "sim/run/simulation_base.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

namespace {

using ScalarSignal = InputSignal<double>;

ScalarSignal signalOf(const PropellerBench& bench) {
  std::vector<ScalarSignal::Sample> samples;
  for (const PropellerSpeedRow& row : bench.speeds) samples.push_back({row.time, row.speed});
  return {std::move(samples), bench.interpolation};
}

ScalarSignal streamOf(const PropellerBench& bench) {
  if (const auto* steady = std::get_if<SteadyStream>(&bench.stream))
    return {{{0, steady->speed}}, Interpolation::Hold};
  const auto& profile = std::get<StreamProfile>(bench.stream);
  std::vector<ScalarSignal::Sample> samples;
  for (const AirSpeedRow& row : profile.rows) samples.push_back({row.time, row.speed});
  return {std::move(samples), profile.interpolation};
}

/// What tells the runs of two propellers apart: their models, or their order where these are the
/// same.
std::vector<std::string> namesOf(const std::vector<BenchPropeller>& propellers) {
  if (propellers.size() < 2) return std::vector<std::string>(propellers.size());
  std::vector<std::string> names;
  for (const BenchPropeller& propeller : propellers) {
    std::string label = std::visit(
        [](const auto& p) { return schema::typeOf<std::decay_t<decltype(p)>>().label; }, propeller);
    // In the middle of a name; all labels begin with a letter of ASCII.
    if (label.front() >= 'A' && label.front() <= 'Z') label.front() += 'a' - 'A';
    names.push_back(std::move(label));
  }
  if (names[0] == names[1]) return {"first", "second"};
  return names;
}

class PropellerBenchSimulation final : public SimulationBase {
 public:
  PropellerBenchSimulation(const PropellerBench& bench, const OutputSettings& outputs)
      : SimulationBase(bench.run.tick),
        speed_(signalOf(bench)),
        stream_(streamOf(bench)),
        duration_(bench.run.duration),
        every_(ticksPerRow(outputs, bench.run.tick)),
        ticks_(std::max<std::int64_t>(1, std::llround(bench.run.duration / bench.run.tick))) {
    const std::vector<BenchPropeller> propellers = propellersOn(bench);
    const std::vector<std::string> names = namesOf(propellers);
    std::size_t share = 0;
    for (const BenchPropeller& propeller : propellers) share += PropellerTrack::runsOf(propeller);
    const auto add = [&](std::string name, std::vector<Channel> channels) -> Recording& {
      return addRun(std::move(name), std::move(channels), outputs, share);
    };
    for (std::size_t i = 0; i < propellers.size(); ++i) {
      tracks_.emplace_back(propellers[i], bench, names[i], add);
      for (AbsentChannels& absent : tracks_.back().absent()) addAbsent(std::move(absent));
    }
    record(0);
    for (PropellerTrack& track : tracks_) track.publish();
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    for (const RunOutput& run : runs()) run.recording->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override { return {share(), time(done_), "turning"}; }

  [[nodiscard]] MetricTable metrics() const override {
    MetricTable table;
    for (const PropellerTrack& track : tracks_) table.push_back(track.metrics());
    return table;
  }

 private:
  [[nodiscard]] double time(std::int64_t tick) const {
    return tick == ticks_ ? duration_ : static_cast<double>(tick) * tickSeconds();
  }
  [[nodiscard]] double share() const {
    return static_cast<double>(done_) / static_cast<double>(ticks_);
  }
  void tick() {
    ++done_;
    for (PropellerTrack& track : tracks_) track.fillCurves(share());
    const bool last = done_ == ticks_;
    if ((done_ % every_ == 0 || last) && !record(time(done_))) return failFull(time(done_));
    if (last) end(SimulationState::Finished);
  }
  bool record(double t) {
    const double w = speed_.at(t), v = stream_.at(t);
    // Every propeller has the row, or none of them goes on.
    bool room = true;
    for (PropellerTrack& track : tracks_) room = track.record(t, w, v) && room;
    return room;
  }

  ScalarSignal speed_, stream_;
  double duration_;
  std::int64_t every_, ticks_, done_ = 0;
  std::vector<PropellerTrack> tracks_;
};

}  // namespace

std::unique_ptr<Simulation> build(const PropellerBench& bench, const BuildContext& context) {
  return std::make_unique<PropellerBenchSimulation>(bench, context.outputs);
}

}  // namespace rotorbench
