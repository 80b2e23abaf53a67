// A simulation whose every property a test can foretell: one channel counts the ticks, computing a
// tick takes a given wall time, and it can fail or throw at a given tick.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "sim/document/changes.h"
#include "sim/run/simulation.h"

namespace rotorbench {

struct FakePlan {
  std::int64_t ticks = 1000;
  double tickSeconds = 0.001;
  std::chrono::microseconds tickCost{0};
  std::int64_t failAt = std::numeric_limits<std::int64_t>::max();
  std::int64_t throwAt = std::numeric_limits<std::int64_t>::max();
  std::size_t runs = 1;
  std::atomic<std::int64_t>* longestSlice = nullptr;  ///< microseconds
  std::vector<RunEvent> events{};
};

class FakeSimulation : public Simulation {
 public:
  explicit FakeSimulation(const FakePlan& plan) : plan_(plan) {
    for (std::size_t i = 0; i < plan.runs; ++i) {
      const std::vector<Channel> channels{{"time", "s", "Time"},
                                          {"count", "1", "Weights of the ticks done"}};
      runs_.push_back({"run " + std::to_string(i + 1), std::make_shared<Recording>(channels)});
    }
  }
  SimulationState advance(std::int64_t ticks) override {
    const auto begin = std::chrono::steady_clock::now();
    for (std::int64_t i = 0; i < ticks && state_ == SimulationState::Running; ++i) tick();
    for (const RunOutput& run : runs_) run.recording->publish();
    if (plan_.longestSlice != nullptr) {
      const auto spent = std::chrono::duration_cast<std::chrono::microseconds>(
          std::chrono::steady_clock::now() - begin);
      if (spent.count() > plan_.longestSlice->load()) plan_.longestSlice->store(spent.count());
    }
    return state_;
  }
  void stop() override { end(SimulationState::Finished); }
  [[nodiscard]] SimulationState state() const override { return state_; }
  [[nodiscard]] Progress progress() const override {
    const auto done = static_cast<double>(done_);
    return {done / static_cast<double>(plan_.ticks), done * plan_.tickSeconds, "counting"};
  }
  [[nodiscard]] const std::vector<RunOutput>& runs() const override { return runs_; }
  [[nodiscard]] const std::optional<RunFailure>& failure() const override { return failure_; }
  [[nodiscard]] MetricTable metrics() const override {
    MetricTable table;
    for (const RunOutput& run : runs_) {
      table.push_back({run.name, {{"ticks", "1", "Ticks done", static_cast<double>(done_)}}});
    }
    return table;
  }
  [[nodiscard]] std::vector<RunEvent> events() const override { return plan_.events; }
  [[nodiscard]] double tickSeconds() const override { return plan_.tickSeconds; }
  /// The value of "weight" is what a tick counts from then on; anything else is refused.
  std::optional<Problem> change(const Change& change) override {
    if (change.parameter != "weight") return Problem{change.parameter, "is unknown", "weight"};
    if (state_ != SimulationState::Running) return Problem{{}, "the run has ended", {}};
    weight_ = std::stod(change.value);
    changes_.push_back({static_cast<double>(done_) * plan_.tickSeconds, "weight", change.value});
    return {};
  }
  [[nodiscard]] const std::vector<Change>& changes() const override { return changes_; }

 private:
  void tick() {
    if (done_ == plan_.throwAt) throw std::runtime_error("A model broke its promise.");
    if (done_ == plan_.failAt) {
      failure_ = RunFailure{static_cast<double>(done_) * plan_.tickSeconds, "count", "It failed."};
      end(SimulationState::Failed);
      return;
    }
    spend();
    ++done_;
    count_ += weight_;
    const std::array<double, 2> row{static_cast<double>(done_) * plan_.tickSeconds, count_};
    for (const RunOutput& run : runs_) run.recording->append(row);
    if (done_ == plan_.ticks) end(SimulationState::Finished);
  }
  void spend() const {
    const auto until = std::chrono::steady_clock::now() + plan_.tickCost;
    while (plan_.tickCost.count() > 0 && std::chrono::steady_clock::now() < until) {
    }
  }
  void end(SimulationState state) {
    state_ = state;
    for (const RunOutput& run : runs_) run.recording->finish();
  }

  FakePlan plan_;
  std::vector<RunOutput> runs_;
  std::optional<RunFailure> failure_;
  SimulationState state_ = SimulationState::Running;
  std::int64_t done_ = 0;
  double weight_ = 1, count_ = 0;
  std::vector<Change> changes_;
};

}  // namespace rotorbench
