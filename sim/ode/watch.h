// What a caller sees of a free run: every accepted step with its dense output, and events, the zero
// crossings of functions of time and state, located on the dense output. Times in s.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "sim/ode/dense_output.h"

namespace rotorbench::ode {

enum class Crossing { Any, Rising, Falling };

template <class State>
struct Event {
  std::function<double(double t, const State& y)> value;  ///< the event is its zero crossing
  Crossing direction = Crossing::Any;
  bool terminal = true;  ///< the run stops at the event
};

template <class State>
struct Occurrence {
  std::size_t event;  ///< index into the list of events
  double time;        ///< s, just past the crossing, within rounding
  State state;
};

/// An accepted step; `dense` holds between start and end.
template <class State>
struct StepView {
  double start, end;
  const DenseOutput<State>& dense;
};

template <class State>
struct Watch {
  std::function<bool(const StepView<State>&)>
      onStep;  ///< may be empty; false pauses the run after this step
  std::vector<Event<State>> events;
  std::function<void(const Occurrence<State>&)> onEvent;  ///< may be empty
  [[nodiscard]] bool wanted() const { return onStep || !events.empty(); }
};

/// The end of the bracket [a, b] of a sign change of g, narrowed to rounding: the point just past
/// the root, so that a search that goes on from there does not find it again. Illinois method, with
/// a bisection wherever it is slow. `ga` = g(a) and `gb` = g(b) have opposite signs, or gb is 0.
template <class Function>
double rootPast(Function&& g, double a, double b, double ga, double gb) {
  int kept = 0;  // which end the last step kept: -1 a, +1 b
  for (int i = 0; i < 200 && gb != 0.0; ++i) {
    const double resolution =
        2.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
    if (!(b - a > resolution)) break;
    double x = b - gb * (b - a) / (gb - ga);
    if (i % 4 == 3 || !(x > a && x < b)) x = 0.5 * (a + b);
    if (!(x > a && x < b)) break;
    const double gx = g(x);
    if ((gx > 0.0) == (gb > 0.0) || gx == 0.0) {
      b = x;
      gb = gx;
      if (kept == -1) ga *= 0.5;
      kept = -1;
    } else {
      a = x;
      ga = gx;
      if (kept == 1) gb *= 0.5;
      kept = 1;
    }
  }
  return b;
}

/// Finds the events of a run step by step.
template <class State>
class EventFinder {
 public:
  /// Starts at time t with state y. Allocates; find() does not.
  void begin(const std::vector<Event<State>>& events, double t, const State& y) {
    events_ = &events;
    values_.resize(events.size());
    found_.clear();
    found_.reserve(events.size() * kSamples);
    for (std::size_t i = 0; i < events.size(); ++i) values_[i] = events[i].value(t, y);
  }

  /// The occurrences inside the step in the order of time, ended by the first terminal one.
  /// Crossings closer together than a quarter of the step may be missed: limit the step where that
  /// matters.
  const std::vector<Occurrence<State>>& find(const DenseOutput<State>& dense, double end,
                                             const State& endState) {
    found_.clear();
    for (std::size_t i = 0; i < values_.size(); ++i) search(i, dense, end, endState);
    std::sort(found_.begin(), found_.end(),
              [](const auto& l, const auto& r) { return l.time < r.time; });
    const auto terminal = std::find_if(found_.begin(), found_.end(), [this](const auto& o) {
      return (*events_)[o.event].terminal;
    });
    if (terminal != found_.end()) found_.erase(terminal + 1, found_.end());
    return found_;
  }
  [[nodiscard]] bool isTerminal(const Occurrence<State>& o) const {
    return (*events_)[o.event].terminal;
  }

 private:
  static constexpr int kSamples = 4;

  void search(std::size_t i, const DenseOutput<State>& dense, double end, const State& endState) {
    const Event<State>& event = (*events_)[i];
    double a = dense.start;
    double ga = values_[i];
    for (int k = 1; k <= kSamples; ++k) {
      const double b = k == kSamples ? end : dense.start + (end - dense.start) * k / kSamples;
      const double gb = event.value(b, k == kSamples ? endState : dense.at(b));
      const bool rising = ga < 0.0 && gb >= 0.0;
      const bool falling = ga > 0.0 && gb <= 0.0;
      if ((rising && event.direction != Crossing::Falling) ||
          (falling && event.direction != Crossing::Rising)) {
        const double root =
            rootPast([&](double t) { return event.value(t, dense.at(t)); }, a, b, ga, gb);
        found_.push_back({i, root, root == end ? endState : dense.at(root)});
      }
      a = b;
      ga = gb;
    }
    values_[i] = ga;
  }

  const std::vector<Event<State>>* events_ = nullptr;
  std::vector<double> values_;
  std::vector<Occurrence<State>> found_;
};

}  // namespace rotorbench::ode
