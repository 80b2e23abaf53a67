// The hybrid simulation of a flight. Once a tick the pilot (a controller, or inputs laid down in
// advance) reads the plant and sets its command; the solver then brings the plant exactly to the
// next tick, and to each instant between at which a command that had to wait for a dead time begins
// to act. The order of a tick at time t: derivative and forces, act on them, record, advance to t +
// h. The derivative is the first stage of the step.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include "sim/experiment/delayed_commands.h"
#include "sim/experiment/flight.h"
#include "sim/experiment/flight_watch.h"
#include "sim/experiment/simulation_base.h"
#include "sim/ode/solver.h"
#include "sim/vehicle/multirotor_outputs.h"

namespace rotorbench {

/// A pilot: channels() declares what it adds to each row, row() writes them as of its last action,
/// figures() adds to the metrics; held() names what it is to hold, watch() gives set-points and
/// values of it as of its last action. Asked once a tick, a pilot of motors gives their command()
/// for the time from t on; one of prescribed speeds sets them itself for the tick from t to t + h
/// in act(), brings derivative and forces up to date and tells whether anything jumped.
template <class P, class Plant>
concept FlightPilot = requires(const P& c, const Recording& recording, std::vector<Metric>& metrics,
                               double* out) {
  { c.channels() } -> std::same_as<std::vector<Channel>>;
  { c.held() } -> std::same_as<std::vector<HeldQuantity>>;
  c.row(out);
  c.figures(recording, metrics);
}
&&(
    requires(P& p, const Plant& plant, const typename Plant::State& y,
             const MultirotorForces<Plant::kRotors>& forces) {
      { p.command(double{}, plant, y, forces) } -> std::convertible_to<typename Plant::Command>;
    } ||
    requires(P & p, Plant& plant, typename Plant::State& y,
             MultirotorForces<Plant::kRotors>& forces) {
      { p.act(double{}, double{}, plant, y, y, forces) } -> std::same_as<bool>;
    });

/// Figures of any flight: peaks, energy and what is left of it, where it ended.
void addFlightFigures(const Recording& recording, const Supply& supply,
                      std::vector<Metric>& metrics);
/// How a flight ends whose battery is below its cut-off, V.
RunFailure emptyBattery(double time, double voltage, double cutOff);

/// "rotor2.thrust" for a quantity of rotor 2; rotor 0 is the vehicle and has no prefix.
inline std::string channelName(int rotor, const char* name) {
  return rotor == 0 ? name : "rotor" + std::to_string(rotor) + "." + name;
}

template <class PlantType, FlightPilot<PlantType> Pilot>
class FlightSimulation final : public SimulationBase {
 public:
  using State = typename PlantType::State;

  FlightSimulation(const Flight& flight, const OutputSettings& outputs, PlantType plant,
                   Pilot pilot)
      : SimulationBase(flight.tick),
        duration_(flight.duration),
        plant_(std::move(plant)),
        pilot_(std::move(pilot)),
        solver_(flight.solver, plant_),
        y_(plant_.initialState(flight.start)),
        watch_(pilot_.held()),
        commands_(deadTimes(plant_.constants()), flight.tick),
        every_(ticksPerRow(outputs, flight.tick)),
        ticks_(std::max<std::int64_t>(1, std::llround(flight.duration / flight.tick))) {
    // Until the pilot's first command acts, the one that brought the rotors to their speeds does.
    if constexpr (kMotors) plant_.setCommand(y_.template segment<kRotors>(Layout::kDuty));
    std::vector<Channel> channels{{"time", "s", "Simulated time"}};
    visitMultirotorOutputs<PlantType>(
        y_, forces_,
        [&](int rotor, const char* name, const char* unit, const char* description, double) {
          channels.push_back({channelName(rotor, name), unit, description});
        });
    for (auto& c : pilot_.channels()) channels.push_back(std::move(c));
    row_.resize(channels.size());
    recording_ = &addRun("Flight", std::move(channels), outputs);
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    recording_->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    return {static_cast<double>(done_) / static_cast<double>(ticks_), solver_.time(), "flying"};
  }

  [[nodiscard]] MetricTable metrics() const override {
    MetricRow figures{runs().front().name, {}};
    const auto statistics = solver_.statistics();
    const auto count = [](std::int64_t n) { return static_cast<double>(n); };
    figures.metrics.push_back({"end_time", "s", "Simulated time at the end", solver_.time()});
    pilot_.figures(*recording_, figures.metrics);
    addFlightFigures(*recording_, plant_.constants().supply, figures.metrics);
    for (const Verdict& verdict : verdicts()) {
      figures.metrics.push_back(
          {verdict.name, "s", "Time since when: " + verdict.what, verdict.time});
    }
    figures.metrics.push_back({"steps", "1", "Accepted steps", count(statistics.steps)});
    figures.metrics.push_back({"evaluations", "1", "Evaluations of the equations of motion",
                               count(statistics.evaluations + startEvaluations_)});
    figures.metrics.push_back(
        {"rejected", "1", "Steps thrown away by the error control", count(statistics.rejected)});
    return {figures};
  }

  [[nodiscard]] std::vector<Verdict> verdicts() const override { return watch_.verdicts(); }

 private:
  using Layout = typename PlantType::Layout;
  using Command = typename PlantType::Command;
  static constexpr int kRotors = PlantType::kRotors;
  static constexpr bool kMotors = PlantType::kDrive == RotorDrive::Motors;

  static std::array<double, kRotors> deadTimes(const MultirotorConstants<kRotors>& constants) {
    std::array<double, kRotors> times{};
    for (std::size_t i = 0; kMotors && i < times.size(); ++i) times[i] = constants.hubs[i].deadTime;
    return times;
  }

  void tick() {
    const double t = solver_.time();
    const double next =
        done_ + 1 == ticks_ ? duration_ : static_cast<double>(done_ + 1) * tickSeconds();
    if (!prepare(t, next - t)) return;
    const auto act = [this](double time) {
      Command acting = plant_.command();
      commands_.take(time, acting);
      if (set(acting)) solver_.restart();
    };
    if (advanceWithCommands(solver_, y_, commands_, next, tickSeconds(), act) ==
        ode::Status::Failed)
      return fail(solver_.runFailure());
    if (++done_ < ticks_) return;
    // The last row shows where the flight ended.
    if (prepare(next, tickSeconds())) end(SimulationState::Finished);
  }

  /// The state follows; false if nothing changed.
  bool set(const Command& acting) {
    if (acting == plant_.command()) return false;
    plant_.setCommand(acting, y_);
    return true;
  }

  /// The pilot's action at t. True if anything jumped.
  bool fly(double t, double h) {
    if constexpr (kMotors) {
      Command acting = plant_.command();
      commands_.give(t, plant_.allowed(pilot_.command(t, plant_, y_, forces_)), acting);
      if (!set(acting)) return false;
      plant_.updateCommand(y_, derivative_, forces_);
      return true;
    } else {
      return pilot_.act(t, h, plant_, y_, derivative_, forces_);
    }
  }

  /// Everything of a tick but the integration. False if the recording is full.
  bool prepare(double t, double h) {
    plant_.derivativeAndForces(y_, derivative_, forces_);
    const bool jumped = fly(t, h);
    // A winding takes up no current at once: the bus at the start of a tick is the one under load.
    const bool empty = kMotors && forces_.busVoltage < plant_.constants().supply.cutOff;
    if (jumped) {
      ++startEvaluations_;
      // ABM4 keeps its history over ticks where nothing did.
      solver_.restart();
      solver_.setStartDerivative(derivative_);
    }
    pilot_.watch(y_, forces_, [&](const double* wanted, const double* values) {
      const double qx = y_[Layout::kAttitude + 1], qy = y_[Layout::kAttitude + 2];
      watch_.see(t, y_[Layout::kPosition + 2], 1 - 2 * (qx * qx + qy * qy), wanted, values);
    });
    if (done_ % every_ != 0 && done_ < ticks_ && !empty) return true;
    double* out = row_.data();
    *out++ = t;
    visitMultirotorOutputs<PlantType>(
        y_, forces_,
        [&](int, const char*, const char*, const char*, double value) { *out++ = value; });
    pilot_.row(out);
    const bool kept = recording_->append(row_);
    if (!kept) failFull(t);
    if (kept && empty) fail(emptyBattery(t, forces_.busVoltage, plant_.constants().supply.cutOff));
    return kept && !empty;
  }

  double duration_;
  PlantType plant_;
  Pilot pilot_;
  ode::Solver<PlantType> solver_;
  State y_, derivative_;
  FlightWatch watch_;
  DelayedCommands<kRotors> commands_;
  MultirotorForces<PlantType::kRotors> forces_{};
  std::int64_t every_, ticks_, done_ = 0;
  std::int64_t startEvaluations_ = 0;  ///< derivatives handed to the solver as the start of a step
  std::vector<double> row_;
  Recording* recording_ = nullptr;
};

}  // namespace rotorbench
