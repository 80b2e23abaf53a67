// One explicit Runge-Kutta step of any tableau, on the stack. The derivative at the start of a step
// is kept: a first-same-as-last method gets it for nothing, a rejected step does not compute it
// again, and a caller that knows it may hand it in.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "sim/ode/dense_output.h"
#include "sim/ode/system.h"

namespace rotorbench::ode {

/// The first component of `v` that is not finite, or -1.
template <class State>
int firstNonFiniteOf(const State& v) {
  for (int i = 0; i < v.size(); ++i) {
    if (!(v[i] - v[i] == 0.0)) return i;
  }
  return -1;
}

template <class Tableau, OdeSystem System>
class RungeKutta {
 public:
  using State = typename System::State;
  static constexpr int kStages = Tableau::kStages;
  static constexpr bool kAdaptive = requires { Tableau::kError; };

  /// Inputs or state jumped: the kept derivative is void.
  void restart() { startKnown_ = false; }
  void setStart(const State& derivative) {
    k_[0] = derivative;
    startKnown_ = true;
  }
  const State& start(System& f, double t, const State& y) {
    if (!startKnown_) {
      f(t, y, k_[0]);
      ++evaluations_;
      startKnown_ = true;
    }
    return k_[0];
  }

  /// out = the solution at t + h of the system that passes through y at t; `out` may be `y` itself.
  void step(System& f, double t, double h, const State& y, State& out) {
    start(f, t, y);
    innerStages(f, t, h, y, std::make_integer_sequence<int, kInner>{});
    if constexpr (Tableau::kFirstSameAsLast) {
      combine<kStages - 1, kStages - 1>(y, h, out);
      f(t + h, out, k_[kStages - 1]);
    } else {
      combine<kSolution, kStages>(y, h, out);
    }
    evaluations_ += kStages - 1;
  }

  /// Difference of the fourth- and the fifth-order solution of the step just made.
  [[nodiscard]] State error(double h) const requires kAdaptive {
    State e;
    scaledSum<kErrorRow>(h, e);
    return e;
  }

  void accept() {
    if constexpr (Tableau::kFirstSameAsLast) {
      k_[0] = k_[kStages - 1];
    } else {
      startKnown_ = false;
    }
  }

  /// Like accept(), and fills `dense` for the step from (t, y0) to (end, y1), end = t + h up to rounding.
  void accept(System& f, double t, [[maybe_unused]] double end, double h, const State& y0,
              const State& y1, DenseOutput<State>& dense) {
    const State first = k_[0];
    State last;
    if constexpr (Tableau::kFirstSameAsLast) {
      last = k_[kStages - 1];
    } else {
      f(end, y1, last);
      ++evaluations_;
    }
    dense.setHermite(t, h, y0, first, y1, last);
    if constexpr (requires { Tableau::kDense; }) {
      scaledSum<kDenseRow>(h, dense.c[4]);
    }
    setStart(last);
  }

  /// The component that spoiled the step just made, judged by the earliest derivative that is not
  /// finite.
  [[nodiscard]] int firstNonFinite() const {
    for (const State& k : k_) {
      if (const int i = firstNonFiniteOf(k); i >= 0) return i;
    }
    return -1;
  }
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  static constexpr int kInner = Tableau::kFirstSameAsLast ? kStages - 2 : kStages - 1;
  static constexpr int kSize = State::RowsAtCompileTime;
  // Rows of weights beyond those of the stages.
  static constexpr int kSolution = kStages;
  static constexpr int kErrorRow = kStages + 1;
  static constexpr int kDenseRow = kStages + 2;

  template <int Row, int J>
  static constexpr double weight() {
    if constexpr (Row < kStages) {
      return Tableau::kA[Row][J];
    } else if constexpr (Row == kSolution) {
      return Tableau::kB[J];
    } else if constexpr (Row == kErrorRow) {
      return Tableau::kError[J];
    } else {
      return Tableau::kDense[J];
    }
  }

  template <int Row, int J>
  void addTerm(int i, double h, double& sum) const {
    if constexpr (weight<Row, J>() != 0.0) sum += (h * weight<Row, J>()) * k_[J][i];
  }

  /// The terms are added in the order of the stages, each one product: the derivative computed last, the one
  /// everything waits for, passes through one multiplication and one addition only.
  template <int Row, int... J>
  double weightedSum(int i, double h, double from, std::integer_sequence<int, J...>) const {
    (addTerm<Row, J>(i, h, from), ...);
    return from;
  }

  /// out = y + h * sum of the first Count derivatives with the weights of the row.
  template <int Row, int Count>
  void combine(const State& y, double h, State& out) const {
    for (int i = 0; i < kSize; ++i) {
      out[i] = weightedSum<Row>(i, h, y[i], std::make_integer_sequence<int, Count>{});
    }
  }
  template <int Row>
  void scaledSum(double h, State& out) const {
    for (int i = 0; i < kSize; ++i) {
      out[i] = weightedSum<Row>(i, h, 0.0, std::make_integer_sequence<int, kStages>{});
    }
  }

  template <int... I>
  void innerStages(System& f, [[maybe_unused]] double t, [[maybe_unused]] double h, const State& y,
                   std::integer_sequence<int, I...>) {
    (stage<I + 1>(f, t, h, y), ...);
  }
  template <int I>
  void stage(System& f, double t, double h, const State& y) {
    State at;
    combine<I, I>(y, h, at);
    f(t + Tableau::kC[I] * h, at, k_[I]);
  }

  std::array<State, kStages> k_{};
  bool startKnown_ = false;
  std::int64_t evaluations_ = 0;
};

}  // namespace rotorbench::ode
