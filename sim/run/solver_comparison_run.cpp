#include "sim/run/builders.h"

#include <array>
#include <chrono>
#include <optional>

#include "sim/document/solver_comparison.h"
#include "sim/run/birotor_view.h"
#include "sim/run/compared_run.h"
#include "sim/run/simulation.h"
#include "sim/run/simulation_base.h"

namespace rotorbench {

ode::SolverSettings comparedSettings(const SolverComparison& comparison, ode::Method method,
                                     double refinement, double toleranceFactor) {
  ode::SolverSettings settings{.method = method,
                               .step = comparison.sampleInterval / refinement,
                               .errorControl = comparison.errorControl};
  if (auto* scaled = std::get_if<ode::ScaledErrorControl>(&settings.errorControl)) {
    scaled->relativeTolerance = std::max(scaled->relativeTolerance * toleranceFactor, 1e-15);
    scaled->absoluteTolerance *= toleranceFactor;
  } else {
    auto& tolerance = std::get<ode::ThesisErrorControl>(settings.errorControl).tolerance;
    tolerance = std::max(tolerance * toleranceFactor, 1e-15);  // rounding allows no less
  }
  return settings;
}

namespace {

/// Points of the work-precision diagram: each level halves the step or divides the tolerance by
/// ten.
constexpr int kLevels = 7;
/// A method is timed this often, and a sampled run this many samples a tick.
constexpr int kTimedRuns = 3;
constexpr int kTimedSlice = 1000;

template <class Plant>
class ComparisonSimulation final : public SimulationBase {
 public:
  template <class Parameters>
  ComparisonSimulation(const SolverComparison& comparison, const Parameters& parameters,
                       const OutputSettings& outputs)
      : SimulationBase(comparison.sampleInterval),
        comparison_(comparison),
        plant_(parameters),
        reference_(plant_, comparison.referenceStep, comparison.duration),
        every_(ticksPerRow(outputs, comparison.sampleInterval)),
        ticksPerRun_(std::max<std::int64_t>(
            1, std::llround(comparison.duration / comparison.sampleInterval))) {
    const std::size_t share = comparison.methods.size() + 2;
    addRun("Reference", runChannels(false), outputs, share);
    for (const auto& m : comparison.methods) {
      addRun(std::string(ode::name(m.method)), runChannels(true), outputs, share);
    }
    if (comparison.workPrecision) addRun("Work-precision", workPrecisionChannels(), outputs, share);
    figures_.resize(comparison.methods.size());
    row_.resize(runChannels(true).size());
    recordReference(0, plant_.initialState());
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    for (const auto& run : runs()) run.recording->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    if (stage_ == stageCount()) return {1, comparison_.duration, "compared"};
    const auto stages = static_cast<double>(stageCount());
    const bool timing = timedRuns_ > 0;  // once more what was already run
    const double time = timing        ? comparison_.duration
                        : stage_ == 0 ? reference_.time()
                                      : (run_ ? run_->solver().time() : 0);
    const double within = stage_ <= comparison_.methods.size()
                              ? std::min(1.0, time / comparison_.duration)
                              : (level_ + static_cast<double>(levelMethod()) /
                                              static_cast<double>(comparison_.methods.size())) /
                                    kLevels;
    const auto index = std::min(stage_, runs().size() - 1);
    return {std::min(1.0, (static_cast<double>(stage_) + within) / stages), time,
            runs()[index].name};
  }

  [[nodiscard]] MetricTable metrics() const override {
    MetricTable table;
    for (std::size_t i = 0; i < figures_.size(); ++i) {
      const Figures& f = figures_[i];
      if (!f.started) continue;
      const auto count = [](std::int64_t n) { return static_cast<double>(n); };
      table.push_back(
          {runs()[i + 1].name,
           {{"max_error_norm", "1",
             "Largest Euclidean norm of the difference to the reference over all states (SI units "
             "mixed)",
             f.maxError},
            {"steps", "1", "Accepted steps", count(f.statistics.steps)},
            {"evaluations", "1", "Evaluations of the equations of motion",
             count(f.statistics.evaluations)},
            {"rejected", "1", "Steps thrown away by the error control",
             count(f.statistics.rejected)},
            {"wall_time", "s", "Computing time of the whole span without recording, best of three",
             f.wallTime}}});
      for (auto& m : BirotorView<Plant>::endMetrics(plant_, f.time, f.state))
        table.back().metrics.push_back(std::move(m));
    }
    return table;
  }

 private:
  struct Figures {
    bool started = false;
    double maxError = 0;
    double wallTime = std::numeric_limits<double>::quiet_NaN();
    ode::Statistics statistics;
    double time = 0;  ///< s, how far the method came
    typename Plant::State state = Plant::State::Zero();
  };

  static std::vector<Channel> runChannels(bool compared) {
    std::vector<Channel> channels{{"time", "s", "Simulated time"}};
    for (auto& c : BirotorView<Plant>::channels()) channels.push_back(std::move(c));
    if (compared) {
      channels.push_back(
          {"error_norm", "1", "Euclidean norm of the difference to the reference over all states"});
      channels.push_back({"step", "s", "Length of the step (free) or of the sample (sampled)"});
    }
    return channels;
  }

  [[nodiscard]] std::vector<Channel> workPrecisionChannels() const {
    std::vector<Channel> channels{
        {"level", "1",
         "Each level halves the step of a fixed-step method or divides the tolerance by ten"}};
    for (const auto& m : comparison_.methods) {
      const std::string name(ode::name(m.method));
      channels.push_back({name + ".evaluations", "1", "Evaluations over the whole span"});
      channels.push_back({name + ".max_error_norm", "1", "Largest error norm"});
    }
    return channels;
  }

  /// Stages: reference, one per method, work-precision levels.
  [[nodiscard]] std::size_t stageCount() const {
    return 1 + comparison_.methods.size() + (comparison_.workPrecision ? 1 : 0);
  }

  void tick() {
    if (stage_ == 0) {
      tickReference();
    } else if (stage_ <= comparison_.methods.size()) {
      tickMethod(stage_ - 1);
    } else {
      tickWorkPrecision();
    }
    if (state() == SimulationState::Running && stage_ == stageCount())
      end(SimulationState::Finished);
  }

  void nextStage() {
    ++stage_;
    sample_ = 0;
  }

  void tickReference() {
    const double t = std::min(comparison_.duration, static_cast<double>(++sample_) * tickSeconds());
    if (reference_.extendTo(t) == ode::Status::Failed) return fail(reference_.runFailure());
    const bool last = sample_ >= ticksPerRun_;
    if ((sample_ % every_ == 0 || last) && !recordReference(t, reference_.at(t)))
      return failFull(t);
    if (!last) return;
    if (reference_.extendTo(comparison_.duration) == ode::Status::Failed)
      return fail(reference_.runFailure());
    nextStage();
  }

  void tickMethod(std::size_t index) {
    if (timedRuns_ > 0) return tickTiming(index);
    Recording& recording = *runs()[index + 1].recording;
    if (!run_) {
      run_.emplace(comparison_, comparedSettings(comparison_, comparison_.methods[index].method),
                   plant_);
      view_ = {};
      figures_[index].started = true;
      record(recording, 0, plant_.initialState(), 0, 0);
    }
    bool full = false;
    const auto observer = [&](double t, const typename Plant::State& y, double error, double step) {
      ++sample_;
      if (sample_ % every_ != 0 && t < comparison_.duration) return true;
      full = !record(recording, t, y, error, step);
      return !full;
    };
    const ode::Status status = run_->advance(&reference_, observer);
    Figures& figures = figures_[index];
    figures.maxError = run_->maxError();
    figures.statistics = run_->solver().statistics();
    figures.time = run_->solver().time();
    figures.state = run_->state();
    if (full) return failFull(run_->solver().time());
    // A method that fails on this problem is a result of the comparison, not the end of it.
    const bool failed = status == ode::Status::Failed;
    if (failed) figures.maxError = std::numeric_limits<double>::infinity();
    if (!failed && !run_->done()) return;
    run_.reset();
    if (failed) return nextStage();
    timedRuns_ = kTimedRuns;
  }

  /// The whole span once more without recording or reference, against the clock; a slice a tick, so
  /// that a stop never waits for a long run.
  void tickTiming(std::size_t index) {
    using Clock = std::chrono::steady_clock;
    if (!run_) {
      run_.emplace(comparison_, comparedSettings(comparison_, comparison_.methods[index].method),
                   plant_);
      timed_ = 0;
    }
    // A slice of a free run is thousands of steps already.
    const int slice = comparison_.mode == DrivingMode::Free ? 1 : kTimedSlice;
    const auto start = Clock::now();
    for (int i = 0; i < slice && !run_->done(); ++i) run_->advance(nullptr, nullptr);
    timed_ += std::chrono::duration<double>(Clock::now() - start).count();
    if (!run_->done()) return;
    figures_[index].wallTime = std::fmin(figures_[index].wallTime, timed_);  // NaN before the first
    run_.reset();
    if (--timedRuns_ == 0) nextStage();
  }

  /// One slice of one method at one level, so that a stop never waits for a whole level.
  void tickWorkPrecision() {
    if (levelRow_.empty()) levelRow_.push_back(static_cast<double>(level_));
    if (!run_) {
      SolverComparison free = comparison_;
      free.mode = DrivingMode::Free;
      // The fixed-step methods start at four times the step of the comparison.
      run_.emplace(free,
                   comparedSettings(comparison_, comparison_.methods[levelMethod()].method,
                                    std::exp2(level_ - 2), std::pow(10.0, -level_)),
                   plant_);
    }
    const bool failed = run_->advance(&reference_, nullptr) == ode::Status::Failed;
    if (!failed && !run_->done()) return;
    levelRow_.push_back(static_cast<double>(run_->solver().statistics().evaluations));
    levelRow_.push_back(failed ? std::numeric_limits<double>::quiet_NaN() : run_->maxError());
    run_.reset();
    if (levelMethod() < comparison_.methods.size()) return;
    if (!runs().back().recording->append(levelRow_)) return failFull(comparison_.duration);
    levelRow_.clear();
    if (++level_ == kLevels) nextStage();
  }

  /// The method whose turn it is: the row holds the level, then two values per method that is done.
  [[nodiscard]] std::size_t levelMethod() const { return levelRow_.size() / 2; }

  bool recordReference(double t, const typename Plant::State& y) {
    row_[0] = t;
    view_.row(plant_, y, row_.data() + 1);
    return runs().front().recording->append({row_.data(), row_.size() - 2});
  }

  bool record(Recording& recording, double t, const typename Plant::State& y, double error,
              double step) {
    row_[0] = t;
    view_.row(plant_, y, row_.data() + 1);
    row_[row_.size() - 2] = error;
    row_[row_.size() - 1] = step;
    return recording.append(row_);
  }

  SolverComparison comparison_;
  Plant plant_;
  ReferenceSolution<Plant> reference_;
  std::optional<ComparedRun<Plant>> run_;
  BirotorView<Plant> view_;
  std::int64_t every_, ticksPerRun_, sample_ = 0;
  std::size_t stage_ = 0;
  int level_ = 0;
  int timedRuns_ = 0;  ///< how often the method of this stage is still to be timed
  double timed_ = 0;   ///< s, the clock of the timed run so far
  std::vector<double> levelRow_;
  std::vector<Figures> figures_;
  std::vector<double> row_;
};

std::unique_ptr<Simulation> make(const SolverComparison& c, const RigidBarParameters& p,
                                 const OutputSettings& o) {
  return std::make_unique<ComparisonSimulation<RigidBarBirotor>>(c, p, o);
}
std::unique_ptr<Simulation> make(const SolverComparison& c, const SpringBarParameters& p,
                                 const OutputSettings& o) {
  return std::make_unique<ComparisonSimulation<SpringBarBirotor>>(c, p, o);
}

}  // namespace

std::unique_ptr<Simulation> build(const SolverComparison& comparison, const BuildContext& context) {
  return std::visit([&](const auto& p) { return make(comparison, p, context.outputs); },
                    comparison.plant);
}

}  // namespace rotorbench
