// One explicit Runge-Kutta step of any tableau, on the stack. The derivative at the start of a step
// is kept: a first-same-as-last method gets it for nothing, a rejected step does not compute it
// again, and a caller that knows it may hand it in.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "sim/ode/dense_output.h"
#include "sim/ode/system.h"

namespace rotorbench::ode {

/// The first component of `v` that is not finite, or -1.
template <class State>
[[gnu::noinline]] int firstNonFiniteOf(const State& v) {
  for (int i = 0; i < v.size(); ++i) {
    if (!(v[i] - v[i] == 0.0)) return i;
  }
  return -1;
}

/// Up to this size a state is handled component by component. The right-hand side has just stored
/// the derivative so, and a packed load of two such stores waits until both have left the store
/// buffer, which costs more than the sums. A larger state is past that wait, and gains.
inline constexpr int kSmallState = 12;

/// The sum of components is finite unless one of them is not (or beyond 1e307, which is looked at
/// closer).
template <class State>
[[gnu::always_inline]] inline bool isFinite(const State& v) {
  constexpr int kSize = State::RowsAtCompileTime;
  double sum = 0.0;
  if constexpr (kSize > kSmallState) {
    double odd = 0.0;
    for (int i = 1; i < kSize; i += 2) {
      sum += v[i - 1];
      odd += v[i];
    }
    sum += odd + (kSize % 2 != 0 ? v[kSize - 1] : 0.0);
  } else {
    for (int i = 0; i < kSize; ++i) sum += v[i];
  }
  return sum - sum == 0.0 || firstNonFiniteOf(v) < 0;
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
    innerStages(k_, f, t, h, y, std::make_integer_sequence<int, kInner>{});
    if constexpr (Tableau::kFirstSameAsLast) {
      combine<kStages - 1, kStages - 1>(k_, y, h, out);
      f(t + h, out, k_[kStages - 1]);
    } else {
      combine<kSolution, kStages>(k_, y, h, out);
    }
    evaluations_ += kStages - 1;
  }

  /// step() and accept() `count` times from `start` on, with `afterStep(y)` after each. State and
  /// derivatives are variables of this function: the compiler then knows that storing them leaves
  /// the parameters of `f` alone. Ends before a step whose result is not finite; step() tells more
  /// about it. Returns the steps made.
  template <class AfterStep>
  std::int64_t run(System& f, double start, double h, std::int64_t count, State& y,
                   AfterStep&& afterStep) requires(!kAdaptive && !Tableau::kFirstSameAsLast) {
    Derivatives k;
    // A large state is not worth the copies.
    std::conditional_t<(kSize > kSmallState), State&, State> at = y;
    bool known = startKnown_;
    std::int64_t made = 0;
    for (; made < count; ++made) {
      const double t = start + static_cast<double>(made) * h;
      if (known) {
        k[0] = k_[0];
      } else {
        f(t, at, k[0]);
      }
      innerStages(k, f, t, h, at, std::make_integer_sequence<int, kInner>{});
      const State before = at;
      combine<kSolution, kStages>(k, before, h, at);
      if (!isFinite(at)) [[unlikely]] {
        at = before;
        break;
      }
      afterStep(at);
      known = false;
    }
    if constexpr (kSize <= kSmallState) y = at;
    evaluations_ += kStages * made - (startKnown_ && !known ? 1 : 0);
    startKnown_ = known;
    return made;
  }

  /// Difference of the fourth- and the fifth-order solution of the step just made.
  [[nodiscard]] State error(double h) const requires kAdaptive {
    State e;
    scaledSum<kErrorRow>(k_, h, e);
    return e;
  }

  void accept() {
    if constexpr (Tableau::kFirstSameAsLast) {
      k_[0] = k_[kStages - 1];
    } else {
      startKnown_ = false;
    }
  }

  /// Like accept(), and fills `dense` for the step from (t, y0) to (end, y1), end = t + h up to
  /// rounding.
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
      scaledSum<kDenseRow>(k_, h, dense.c[4]);
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
  using Derivatives = std::array<State, kStages>;
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
  static void addTerm(const Derivatives& k, int i, double h, double& sum) {
    if constexpr (weight<Row, J>() != 0.0) sum += (h * weight<Row, J>()) * k[J][i];
  }

  /// Keeps the sums of a small state from being packed two by two, see kSmallState.
  static void keepApart([[maybe_unused]] double& sum) {
#if defined(__GNUC__) && defined(__x86_64__)
    if constexpr (kSize <= kSmallState) asm("" : "+x"(sum));
#endif
  }

  /// The terms are added in the order of the stages, each one product: the derivative computed
  /// last, the one everything waits for, passes through one multiplication and one addition only.
  template <int Row, int... J>
  static double weightedSum(const Derivatives& k, int i, double h, double from,
                            std::integer_sequence<int, J...>) {
    (addTerm<Row, J>(k, i, h, from), ...);
    keepApart(from);
    return from;
  }

  /// out = y + h * sum of the first Count derivatives with the weights of the row.
  template <int Row, int Count>
  [[gnu::always_inline]] static void combine(const Derivatives& k, const State& y, double h,
                                             State& out) {
    for (int i = 0; i < kSize; ++i) {
      out[i] = weightedSum<Row>(k, i, h, y[i], std::make_integer_sequence<int, Count>{});
    }
  }
  template <int Row>
  static void scaledSum(const Derivatives& k, double h, State& out) {
    for (int i = 0; i < kSize; ++i) {
      out[i] = weightedSum<Row>(k, i, h, 0.0, std::make_integer_sequence<int, kStages>{});
    }
  }

  template <int... I>
  [[gnu::always_inline]] static void innerStages(Derivatives& k, System& f,
                                                 [[maybe_unused]] double t,
                                                 [[maybe_unused]] double h, const State& y,
                                                 std::integer_sequence<int, I...>) {
    (stage<I + 1>(k, f, t, h, y), ...);
  }
  template <int I>
  [[gnu::always_inline]] static void stage(Derivatives& k, System& f, double t, double h,
                                           const State& y) {
    State at;
    combine<I, I>(k, y, h, at);
    f(t + Tableau::kC[I] * h, at, k[I]);
  }

  Derivatives k_{};
  bool startKnown_ = false;
  std::int64_t evaluations_ = 0;
};

}  // namespace rotorbench::ode
