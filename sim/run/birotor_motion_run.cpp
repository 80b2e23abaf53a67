#include "sim/run/builders.h"

#include <cmath>

#include "sim/document/birotor_motion.h"
#include "sim/ode/solver.h"
#include "sim/run/birotor_view.h"
#include "sim/run/simulation.h"
#include "sim/run/simulation_base.h"

namespace rotorbench {

namespace {

template <class Plant>
class BirotorSimulation final : public SimulationBase {
 public:
  template <class Parameters>
  BirotorSimulation(const BirotorMotion& motion, const Parameters& parameters,
                    const OutputSettings& outputs)
      : SimulationBase(motion.sampleInterval),
        duration_(motion.duration),
        plant_(parameters),
        solver_(motion.solver, plant_),
        y_(plant_.initialState()),
        every_(ticksPerRow(outputs, motion.sampleInterval)),
        ticks_(std::max<std::int64_t>(1, std::llround(motion.duration / motion.sampleInterval))) {
    std::vector<Channel> channels{{"time", "s", "Simulated time"}};
    for (auto& c : BirotorView<Plant>::channels()) channels.push_back(std::move(c));
    row_.resize(channels.size());
    recording_ =
        &addRun(std::string(ode::name(motion.solver.method)), std::move(channels), outputs);
    record(0);
    recording_->publish();
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    recording_->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    return {static_cast<double>(done_) / static_cast<double>(ticks_), solver_.time(), "moving"};
  }

  [[nodiscard]] MetricTable metrics() const override {
    const auto statistics = solver_.statistics();
    const auto count = [](std::int64_t n) { return static_cast<double>(n); };
    MetricRow figures{runs().front().name, {}};
    figures.metrics = {
        {"end_time", "s", "Simulated time at the end", solver_.time()},
        {"steps", "1", "Accepted steps", count(statistics.steps)},
        {"evaluations", "1", "Evaluations of the equations of motion",
         count(statistics.evaluations)},
        {"rejected", "1", "Steps thrown away by the error control", count(statistics.rejected)}};
    for (auto& m : BirotorView<Plant>::endMetrics(plant_, solver_.time(), y_))
      figures.metrics.push_back(std::move(m));
    const auto largest = [&](const char* channel, const char* name, const char* unit,
                             const char* text) {
      const auto column = recording_->find(channel);
      if (!column) return;
      double most = 0;
      for (std::size_t r = 0; r < recording_->rows(); ++r) {
        most = std::max(most, std::abs(recording_->value(*column, r)));
      }
      figures.metrics.push_back({name, unit, text, most});
    };
    largest("angular_velocity", "peak_angular_velocity", "rad/s",
            "Largest magnitude of the angular velocity");
    largest("bar.length", "peak_bar_length", "m", "Longest the bar became");
    largest("bar.force", "peak_bar_force", "N", "Largest magnitude of the force of the bar");
    return {figures};
  }

 private:
  void tick() {
    const double end = ++done_ == ticks_ ? duration_ : static_cast<double>(done_) * tickSeconds();
    if (solver_.advanceTo(end, y_) == ode::Status::Failed) return fail(solver_.runFailure());
    if (done_ % every_ == 0 || done_ == ticks_) {
      if (!record(end)) return failFull(end);
    }
    if (done_ == ticks_) this->end(SimulationState::Finished);
  }

  bool record(double time) {
    row_[0] = time;
    view_.row(plant_, y_, row_.data() + 1);
    return recording_->append(row_);
  }

  double duration_;
  Plant plant_;
  ode::Solver<Plant> solver_;
  typename Plant::State y_;
  BirotorView<Plant> view_;
  std::int64_t every_, ticks_, done_ = 0;
  std::vector<double> row_;
  Recording* recording_ = nullptr;
};

std::unique_ptr<Simulation> make(const BirotorMotion& m, const RigidBarParameters& p,
                                 const OutputSettings& o) {
  return std::make_unique<BirotorSimulation<RigidBarBirotor>>(m, p, o);
}
std::unique_ptr<Simulation> make(const BirotorMotion& m, const SpringBarParameters& p,
                                 const OutputSettings& o) {
  return std::make_unique<BirotorSimulation<SpringBarBirotor>>(m, p, o);
}

}  // namespace

std::unique_ptr<Simulation> build(const BirotorMotion& motion, const BuildContext& context) {
  return std::visit([&](const auto& p) { return make(motion, p, context.outputs); }, motion.plant);
}

}  // namespace rotorbench
