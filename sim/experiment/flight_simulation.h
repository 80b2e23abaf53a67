// The hybrid simulation of a flight. Once a tick the pilot (a controller, or inputs laid down in advance) reads the
// plant and sets its command; the solver then brings the plant exactly to the next tick. The order of a tick at time
// t: derivative and forces, act on them, record, advance to t + h. The derivative is the first stage of the step.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/experiment/flight.h"
#include "sim/experiment/simulation_base.h"
#include "sim/ode/solver.h"
#include "sim/vehicle/multirotor_outputs.h"

namespace rotorbench {

/// A pilot: channels() declares what it adds to each row, act() sets the command for the tick from t to t + h,
/// brings derivative and forces up to date with it and tells whether anything jumped, row() writes the channels of the last act(), figures() adds to the metrics.
template <class P, class Plant>
concept FlightPilot = requires(P& p, const P& c, Plant& plant, typename Plant::State& y,
                               MultirotorForces<Plant::kRotors>& forces, const Recording& recording,
                               std::vector<Metric>& metrics, double* out) {
  { c.channels() } -> std::same_as<std::vector<Channel>>;
  { p.act(double{}, double{}, plant, y, y, forces) } -> std::same_as<bool>;
  c.row(out);
  c.figures(recording, metrics);
};

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
        every_(ticksPerRow(outputs, flight.tick)),
        ticks_(std::max<std::int64_t>(1, std::llround(flight.duration / flight.tick))) {
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
    figures.metrics.push_back({"steps", "1", "Accepted steps", count(statistics.steps)});
    figures.metrics.push_back({"evaluations", "1", "Evaluations of the equations of motion",
                               count(statistics.evaluations + startEvaluations_)});
    figures.metrics.push_back(
        {"rejected", "1", "Steps thrown away by the error control", count(statistics.rejected)});
    return {figures};
  }

 private:
  void tick() {
    const double t = solver_.time();
    const double next =
        done_ + 1 == ticks_ ? duration_ : static_cast<double>(done_ + 1) * tickSeconds();
    if (!prepare(t, next - t)) return;
    if (solver_.advanceTo(next, y_) == ode::Status::Failed) return fail(solver_.runFailure());
    if (++done_ < ticks_) return;
    // The last row shows where the flight ended.
    if (prepare(next, tickSeconds())) end(SimulationState::Finished);
  }

  /// Everything of a tick but the integration. False if the recording is full.
  bool prepare(double t, double h) {
    plant_.derivativeAndForces(y_, derivative_, forces_);
    const bool jumped = pilot_.act(t, h, plant_, y_, derivative_, forces_);
    // A winding takes up no current at once: the bus at the start of a tick is the one under load.
    const bool empty = PlantType::kDrive == RotorDrive::Motors &&
                       forces_.busVoltage < plant_.constants().supply.cutOff;
    if (jumped) {
      ++startEvaluations_;
      // ABM4 keeps its history over ticks where nothing did.
      solver_.restart();
      solver_.setStartDerivative(derivative_);
    }
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
  MultirotorForces<PlantType::kRotors> forces_{};
  std::int64_t every_, ticks_, done_ = 0;
  std::int64_t startEvaluations_ = 0;  ///< derivatives handed to the solver as the start of a step
  std::vector<double> row_;
  Recording* recording_ = nullptr;
};

}  // namespace rotorbench
