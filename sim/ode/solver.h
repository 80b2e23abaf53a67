// Solver: integrates one system with the method its settings name. Two ways of driving it (times in
// s):
//  - sampled: advanceTo(t, y) ends exactly at t and never evaluates the system beyond it, so that
//  inputs may
//    jump there (call restart() when they do). The fixed-step methods divide the span into equal
//    steps no longer than the set step; the embedded ones keep their step from call to call.
//  - free: integrate(t, y, watch) runs over a whole span, reports every step with its dense output
//  and finds
//    events. The fixed-step methods step at t0 + n h and shorten the last step only.
// The method is chosen once, by a variant visit per call; inside a step there is no heap, no
// virtual call and no exception. Both ways may be mixed.
//
//   ode::Solver<Plant> solver(settings, plant);          // the plant must outlive the solver
//   if (solver.advanceTo(0.001, state) == ode::Status::Failed) report(solver.runFailure());
//   plant.setInput(u); solver.restart();
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include "sim/core/error.h"
#include "sim/ode/solver_settings.h"
#include "sim/ode/status.h"
#include "sim/ode/step_control.h"
#include "sim/ode/stepper.h"
#include "sim/ode/system.h"
#include "sim/ode/watch.h"

namespace rotorbench::ode {

template <OdeSystem System>
class Solver {
 public:
  using State = typename System::State;

  /// Throws InputError (path "method") if the method is exponential and the system names no linear
  /// pairs.
  Solver(const SolverSettings& settings, System& system, double startTime = 0)
      : system_(&system),
        settings_(settings),
        maximumStep_(settings.maximumStep > 0 ? settings.maximumStep
                                              : std::numeric_limits<double>::infinity()),
        control_(settings),
        stepper_(makeStepper<System>(settings.method)),
        time_(startTime) {}

  /// Sampled: brings `y` from time() to `end`. Nothing happens if `end` is not later than time().
  Status advanceTo(double end, State& y) { return run(end, y, nullptr, true); }
  /// The same, with events: a terminal one leaves time() and `y` at it, and Stopped is returned.
  /// An event that holds at time() already is not found again.
  Status advanceTo(double end, State& y, const Watch<State>& watch) {
    return run(end, y, watch.wanted() ? &watch : nullptr, true);
  }

  /// Free: the same in one go, showing `watch` every step and event on the way. A terminal event
  /// leaves time() and `y` at the event.
  Status integrate(double end, State& y, const Watch<State>& watch = {}) {
    return run(end, y, watch.wanted() ? &watch : nullptr, false);
  }

  /// Inputs, parameters or the state jumped: whatever was kept of earlier derivatives is void. The
  /// step of an embedded method is kept as a first guess.
  void restart() {
    std::visit([](auto& s) { s.restart(); }, stepper_);
    control_.forget();
  }
  /// The derivative at time() is already known to the caller: saves one evaluation. Call after
  /// restart().
  void setStartDerivative(const State& dydt) {
    std::visit([&](auto& s) { s.setStart(dydt); }, stepper_);
  }
  /// The matrices linear(i) of the system changed.
  void relinearize() {
    std::visit(
        [](auto& s) {
          if constexpr (requires { s.relinearize(); }) s.relinearize();
        },
        stepper_);
  }
  /// A new run from `time`: forgets everything, the statistics too.
  void reset(double time) {
    stepper_ = makeStepper<System>(settings_.method);
    control_.forget();
    statistics_ = {};
    failure_ = {};
    time_ = time;
    nextStep_ = 0;
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] Statistics statistics() const {
    Statistics s = statistics_;
    s.evaluations +=
        std::visit([](const auto& stepper) { return stepper.evaluations(); }, stepper_);
    return s;
  }
  [[nodiscard]] const Failure& failure() const { return failure_; }
  [[nodiscard]] RunFailure runFailure() const {
    return describeFailure(failure_, componentName(failure_.component));
  }
  [[nodiscard]] const SolverSettings& settings() const { return settings_; }

 private:
  using Stepper = typename StepperOf<System>::type;
  static constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

  struct AfterStep {
    System* system;
    void operator()(State& y) const {
      if constexpr (HasAfterStep<System>) system->afterStep(y);
    }
  };

  Status run(double end, State& y, const Watch<State>* watch, bool sampled) {
    if (!(end > time_)) return Status::Done;
    if (watch != nullptr) finder_.begin(watch->events, time_, y);
    return std::visit(
        [&](auto& stepper) {
          if constexpr (std::remove_reference_t<decltype(stepper)>::kAdaptive) {
            return runAdaptive(stepper, end, y, watch);
          } else {
            return runFixed(stepper, end, y, watch, sampled);
          }
        },
        stepper_);
  }

  template <class S>
  Status runFixed(S& stepper, double end, State& y, const Watch<State>* watch, bool sampled) {
    const Division d = divide(end, sampled);
    const double start = time_;
    std::int64_t i = 0;
    if constexpr (requires { stepper.run(*system_, start, d.step, 1, y, AfterStep{system_}); }) {
      if (watch == nullptr) i = runEqual(stepper, d, end, y);
    }
    for (; i < d.steps; ++i) {
      if (i >= settings_.maximumSteps) return fail(FailureKind::BudgetExceeded, -1, d.step, i);
      const bool isLast = i + 1 == d.steps;
      const double h = isLast ? d.last : d.step;
      const State before = y;
      stepper.step(*system_, time_, h, y, y);
      if (!isFinite(y)) [[unlikely]] {
        const int component = culprit(stepper, y);
        y = before;
        return fail(FailureKind::NonFinite, component, h, i);
      }
      const double reached = isLast ? end : start + static_cast<double>(i + 1) * d.step;
      if (!accept(stepper, h, reached, before, y, watch)) return Status::Stopped;
    }
    return Status::Done;
  }

  /// How the fixed-step methods go from time_ to `end`.
  struct Division {
    double step, last;  ///< s; length of every step but the last, and of the last
    std::int64_t steps;
  };
  /// A span that is a multiple of the set step up to rounding takes the set step itself, so that
  /// neither the history of ABM4 nor the constants of the exponential method are thrown away for
  /// nothing.
  [[nodiscard]] Division divide(double end, bool sampled) const {
    const double span = end - time_;
    const double h = settings_.step;
    const double slack = std::max(1e-9 * h, 4.0 * kEpsilon * std::abs(end));
    if (std::abs(span - h) <= slack) return {h, h, 1};
    const double count = std::clamp(std::ceil((span - slack) / h), 1.0, 1e15);
    const auto steps = static_cast<std::int64_t>(count);
    if (std::abs(count * h - span) <= slack) return {h, h, steps};
    if (sampled) return {span / count, span / count, steps};
    return {h, span - (count - 1.0) * h, steps};
  }

  /// The steps of equal length in one go, as far as they are finite and within the budget. Returns
  /// how many.
  template <class S>
  std::int64_t runEqual(S& stepper, const Division& d, double end, State& y) {
    const std::int64_t equal = d.last == d.step ? d.steps : d.steps - 1;
    const std::int64_t count = std::min(equal, settings_.maximumSteps);
    const std::int64_t made = stepper.run(*system_, time_, d.step, count, y, AfterStep{system_});
    statistics_.steps += made;
    time_ = made == d.steps ? end : time_ + static_cast<double>(made) * d.step;
    return made;
  }

  template <class S>
  Status runAdaptive(S& stepper, double end, State& y, const Watch<State>* watch) {
    if (!(nextStep_ > 0)) nextStep_ = firstStep(stepper, end, y);
    bool finite = true;  // the last try was
    int culpritIndex = -1;
    State e = State::Zero();
    for (std::int64_t tries = 0; time_ < end; ++tries) {
      const double left = end - time_;
      double h = std::min(nextStep_, maximumStep_);
      // As dopri5: a step that nearly reaches the end is stretched to it.
      const bool isLast = 1.01 * h >= left && left <= maximumStep_ * (1.0 + 1e-9);
      const bool isCut = isLast && h > left;
      if (isLast) h = left;
      if (tries >= settings_.maximumSteps) return fail(FailureKind::BudgetExceeded, -1, h, tries);
      const double least = std::max(settings_.minimumStep, 4.0 * kEpsilon * std::abs(time_));
      if (h < least && !isLast) [[unlikely]] {
        return finite ? fail(FailureKind::StepUnderflow, control_.worst(e, y, y), least, tries)
                      : fail(FailureKind::NonFinite, culpritIndex, least, tries);
      }
      const State before = y;
      stepper.step(*system_, time_, h, y, y);
      e = stepper.error(h);
      const double error = control_.norm(e, before, y);
      if (error <= 1.0) {
        nextStep_ = isCut ? std::max(nextStep_, h * control_.growAfterCut(error))
                          : h * control_.growAfter(error);
        if (!accept(stepper, h, isLast ? end : time_ + h, before, y, watch)) return Status::Stopped;
      } else {
        finite = std::isfinite(error);
        if (!finite) culpritIndex = culprit(stepper, y);
        y = before;
        if (!finite && firstNonFiniteOf(stepper.start(*system_, time_, y)) >= 0) {
          return fail(FailureKind::NonFinite, culpritIndex, h, tries);
        }
        ++statistics_.rejected;
        nextStep_ = h * control_.shrinkAfter(error);
      }
    }
    return Status::Done;
  }

  /// Takes over the step from (time_, before) to (reached, y). False if the watch ends the run
  /// there.
  template <class S>
  bool accept(S& stepper, double h, double reached, const State& before, State& y,
              const Watch<State>* watch) {
    if constexpr (HasAfterStep<System>) system_->afterStep(y);
    ++statistics_.steps;
    if (watch == nullptr) {
      stepper.accept();
      time_ = reached;
      return true;
    }
    stepper.accept(*system_, time_, reached, h, before, y, dense_);
    time_ = reached;
    return show(stepper, *watch, y);
  }

  template <class S>
  bool show(S& stepper, const Watch<State>& watch, State& y) {
    bool goOn = true;
    if (!watch.events.empty()) {
      for (const Occurrence<State>& o : finder_.find(dense_, time_, y)) {
        if (finder_.isTerminal(o)) {
          time_ = o.time;
          y = o.state;
          // What the stepper remembers belongs to the end of the step, not to the event.
          stepper.restart();
          goOn = false;
        }
        if (watch.onEvent) watch.onEvent(o);
      }
    }
    if (watch.onStep && !watch.onStep({dense_.start, time_, dense_})) goOn = false;
    return goOn;
  }

  /// First step for a fifth-order method: HINIT of dopri5; Hairer, Norsett, Wanner I, section II.4.
  template <class S>
  double firstStep(S& stepper, double end, const State& y) {
    if (settings_.initialStep > 0) return settings_.initialStep;
    if (control_.startsWithWholeSpan()) return end - time_;
    const State f0 = stepper.start(*system_, time_, y);
    const double size = control_.squaredSize(y, y);
    const double slope = control_.squaredSize(f0, y);
    double h = size <= 1e-10 || slope <= 1e-10 ? 1e-6 : 0.01 * std::sqrt(size / slope);
    h = std::min({h, maximumStep_, end - time_});
    State f1;
    (*system_)(time_ + h, y + h * f0, f1);
    ++statistics_.evaluations;
    const double curvature = std::sqrt(control_.squaredSize(State(f1 - f0), y)) / h;
    const double larger = std::max(curvature, std::sqrt(slope));
    const double bound = larger <= 1e-15 ? std::max(1e-6, 1e-3 * h) : std::pow(0.01 / larger, 0.2);
    h = std::min({100.0 * h, bound, maximumStep_});
    return h > 0 ? h : 1e-6;
  }

  template <class S>
  [[gnu::noinline]] static int culprit(const S& stepper, const State& next) {
    const int i = stepper.firstNonFinite();
    return i >= 0 ? i : firstNonFiniteOf(next);
  }
  [[gnu::noinline]] Status fail(FailureKind kind, int component, double step, std::int64_t steps) {
    failure_ = {kind, time_, component, step, steps};
    return Status::Failed;
  }
  [[nodiscard]] std::string componentName(int i) const {
    if (i < 0) return {};
    if constexpr (HasComponentNames<System>) {
      return std::string(std::string_view(system_->componentName(i)));
    } else {
      return "y[" + std::to_string(i) + "]";
    }
  }

  System* system_;
  SolverSettings settings_;
  double maximumStep_;
  StepControl control_;
  Stepper stepper_;
  double time_;
  double nextStep_ = 0;  ///< s; what an embedded method tries next, 0 before its first step
  Statistics statistics_;
  Failure failure_;
  DenseOutput<State> dense_;
  EventFinder<State> finder_;
};

}  // namespace rotorbench::ode
