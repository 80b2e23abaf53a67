#include "sim/run/flight_simulation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/document/flight.h"
#include "sim/run/flight_figures.h"
#include "sim/run/simulation.h"
#include "sim/run/timeline.h"

namespace rotorbench {

namespace {

/// s between two looks at the energy, and at numbers beyond every vehicle.
constexpr double kEnergyInterval = 0.01;

DriveWatch::Limits limitsOf(const PlantHandle& plant, bool controlled) {
  DriveWatch::Limits limits{.rotors = plant.rotors(), .controlled = controlled};
  for (int i = 0; i < limits.rotors; ++i) limits.current[i] = plant.currentLimit(i);
  return limits;
}

}  // namespace

FlightSimulation::FlightSimulation(const Flight& flight, const OutputSettings& outputs,
                                   FlightParts parts)
    : SimulationBase(flight.tick),
      duration_(flight.duration),
      plant_(std::move(parts.plant)),
      scheduler_(std::move(parts.tasks), Signal::Truth),
      held_(std::move(parts.held)),
      timeline_(parts.timeline),
      changes_(flight, std::move(parts.live)),
      board_(plant_->rotors()),
      watch_(held_, board_),
      drives_(limitsOf(*plant_, !held_.empty()), board_),
      every_(ticksPerRow(outputs, flight.tick)),
      everyEnergy_(std::max<std::int64_t>(1, std::llround(kEnergyInterval / flight.tick))),
      ticks_(std::max<std::int64_t>(1, std::llround(flight.duration / flight.tick))) {
  std::vector<Channel> channels{{"time", "s", "Simulated time"}};
  for (auto& c : plant_->channels()) channels.push_back(std::move(c));
  firstOfTasks_ = channels.size();
  for (auto& c : scheduler_.channels()) channels.push_back(std::move(c));
  row_.resize(channels.size());
  const auto limited = std::ranges::find(channels, "control.limited", &Channel::name);
  if (limited != channels.end()) limited_ = row_.data() + (limited - channels.begin());
  recording_ = &addRun("Flight", std::move(channels), outputs);
}

SimulationState FlightSimulation::advance(std::int64_t ticks) {
  for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
  recording_->publish();
  return state();
}

Progress FlightSimulation::progress() const {
  const double share = static_cast<double>(done_) / static_cast<double>(ticks_);
  return {endedAtEvent_ ? 1 : share, plant_->time(), "flying"};
}

void FlightSimulation::tick() {
  const double t = plant_->time();
  if (changes_.due(done_)) [[unlikely]] {
    if (const auto problem = changes_.make(done_, t))
      return fail({t, problem->path, problem->message()});
  }
  const double next =
      done_ + 1 == ticks_ ? duration_ : static_cast<double>(done_ + 1) * tickSeconds();
  if (!prepare({t, next - t})) return;
  const ode::Status reached = plant_->advance(next);
  if (reached == ode::Status::Failed) return fail(plant_->failure());
  if (reached == ode::Status::Stopped) return endAtEvent();
  if (++done_ < ticks_) return;
  // The last row shows where the flight ended.
  if (prepare({next, tickSeconds()})) end(SimulationState::Finished);
}

void FlightSimulation::endAtEvent() {
  endedAtEvent_ = true;
  plant_->observe(board_.truth);
  watch_.see(plant_->time());
  row_[0] = plant_->time();
  plant_->row(row_.data() + 1);
  if (!recording_->append(row_)) return failFull(plant_->time());
  end(SimulationState::Finished);
}

std::optional<Problem> FlightSimulation::change(const Change& change) {
  if (state() != SimulationState::Running) return Problem{{}, "the flight has ended", {}};
  return changes_.add(change, done_, plant_->time());
}

bool FlightSimulation::prepare(const ClockTick& tick) {
  plant_->observe(board_.truth);
  scheduler_.run(tick, board_, row_.data() + firstOfTasks_);
  const double bus = plant_->command(tick, board_.command);
  watch_.see(tick.time);
  drives_.see(tick, bus, limited_ != nullptr && *limited_ != 0);
  std::optional<RunFailure> end = endedBy(tick, bus);
  if (done_ % every_ != 0 && done_ < ticks_ && !end) return true;
  if (!keep(tick)) return false;
  if (end) fail(std::move(*end));
  return state() == SimulationState::Running;
}

std::optional<RunFailure> FlightSimulation::endedBy(const ClockTick& tick, double bus) {
  // A winding takes up no current at once: the bus at the start of a tick is the one under load.
  const double cutOff = plant_->supply().cutOff;
  if (bus < cutOff) {
    instants_.push_back({tick.time, tick.time, "cut_off", "battery below its cut-off"});
    return emptyBattery(tick.time, bus, cutOff);
  }
  if (done_ % everyEnergy_ != 0 && done_ < ticks_) return {};
  if (auto beyond = plant_->beyondFlight()) return beyond;
  const std::optional<EnergyBalance> now = plant_->energy();
  return now ? energy_.see(tick.time, *now) : std::nullopt;
}

bool FlightSimulation::keep(const ClockTick& tick) {
  const std::size_t stride = recording_->stride();
  row_[0] = tick.time;
  plant_->row(row_.data() + 1);
  if (!recording_->append(row_)) {
    failFull(tick.time);
    return false;
  }
  if (stride == 1 && recording_->stride() > 1) {
    instants_.push_back({tick.time, tick.time, "recording_thinned",
                         "recording thinned out to its limit of memory"});
  }
  return true;
}

std::vector<Verdict> FlightSimulation::verdicts() const {
  std::vector<Verdict> all = watch_.verdicts();
  std::ranges::move(drives_.verdicts(), std::back_inserter(all));
  std::ranges::stable_sort(all, {}, &Verdict::time);
  return all;
}

std::vector<RunEvent> FlightSimulation::events() const {
  std::vector<RunEvent> all = drives_.events();
  for (const Verdict& v : verdicts()) all.push_back({v.time, v.time, v.name, v.what});
  all.insert(all.end(), instants_.begin(), instants_.end());
  std::ranges::stable_sort(all, {}, &RunEvent::time);
  return all;
}

MetricTable FlightSimulation::metrics() const {
  MetricRow figures{runs().front().name, {}};
  const ode::Statistics statistics = plant_->statistics();
  const auto count = [](std::int64_t n) { return static_cast<double>(n); };
  figures.metrics.push_back({"end_time", "s", "Simulated time at the end", plant_->time()});
  if (timeline_ != nullptr) addStepFigures(*recording_, held_, timeline_->asked(), figures.metrics);
  addFlightFigures(*recording_, plant_->supply(), figures.metrics);
  const auto lasting = [&](const char* name, const char* text, double seconds) {
    if (seconds > 0) figures.metrics.push_back({name, "s", text, seconds});
  };
  lasting("saturated_time", "Time with a motor at full throttle", drives_.saturated());
  lasting("current_limited_time", "Time with a motor at the limit of its current",
          drives_.currentLimited());
  for (const Verdict& verdict : verdicts()) {
    figures.metrics.push_back(
        {verdict.name, "s", "Time since when: " + verdict.what, verdict.time});
  }
  figures.metrics.push_back({"steps", "1", "Accepted steps", count(statistics.steps)});
  figures.metrics.push_back({"evaluations", "1", "Evaluations of the equations of motion",
                             count(statistics.evaluations)});
  figures.metrics.push_back(
      {"rejected", "1", "Steps thrown away by the error control", count(statistics.rejected)});
  return {figures};
}

}  // namespace rotorbench
