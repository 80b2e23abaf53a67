// Exponential RK4: the fourth-order scheme ETDRK4 of S. M. Cox and P. C. Matthews, J. Comput. Phys.
// 176 (2002) 430-455, on two-by-two linear pairs (a motor's speed and current), and plain RK4 on
// all other components. A pair d(u)/dt = A u + N(t, y) may be as stiff as it likes: A is solved
// exactly, only N must vary slowly over a step. With A = 0 the scheme is RK4.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "sim/ode/dense_output.h"
#include "sim/ode/pair_exponential.h"
#include "sim/ode/runge_kutta.h"
#include "sim/ode/system.h"

namespace rotorbench::ode {

template <OdeSystem System>
requires HasLinearPairs<System>
class ExponentialRk4 {
 public:
  using State = typename System::State;
  static constexpr bool kAdaptive = false;
  static constexpr int kPairs = System::kPairs;

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
  /// The linear parts changed: the constants are worked out again before the next step.
  void relinearize() { kept_ = {}; }

  void step(System& f, double t, double h, const State& y, State& out) {
    // Constants for a step that differs by rounding only serve as well.
    if (!holds(kept_[current_], h)) setStep(f, h);
    start(f, t, y);
    std::array<Rest, 4> n;
    rests(y, k_[0], n[0]);

    State at = y + 0.5 * h * k_[0];
    forPairs([&](auto p, const PairConstants& c) {
      put(p, at, c.expHalf * get(p, y) + c.half * n[0][p.i]);
    });
    const State second = at;
    f(t + 0.5 * h, at, k_[1]);
    rests(at, k_[1], n[1]);

    at = y + 0.5 * h * k_[1];
    forPairs([&](auto p, const PairConstants& c) {
      put(p, at, c.expHalf * get(p, y) + c.half * n[1][p.i]);
    });
    f(t + 0.5 * h, at, k_[2]);
    rests(at, k_[2], n[2]);

    at = y + h * k_[2];
    forPairs([&](auto p, const PairConstants& c) {
      put(p, at, c.expHalf * get(p, second) + c.half * (2.0 * n[2][p.i] - n[0][p.i]));
    });
    f(t + h, at, k_[3]);
    rests(at, k_[3], n[3]);
    evaluations_ += 3;

    at = y + (h / 6.0) * (k_[0] + 2.0 * (k_[1] + k_[2]) + k_[3]);
    forPairs([&](auto p, const PairConstants& c) {
      put(p, at,
          c.expFull * get(p, y) + c.first * n[0][p.i] + c.middle * (n[1][p.i] + n[2][p.i]) +
              c.last * n[3][p.i]);
    });
    out = at;
  }

  void accept() { startKnown_ = false; }
  void accept(System& f, double t, double end, double h, const State& y0, const State& y1,
              DenseOutput<State>& dense) {
    const State first = k_[0];
    startKnown_ = false;
    dense.setHermite(t, h, y0, first, y1, start(f, end, y1));
  }

  [[nodiscard]] int firstNonFinite() const {
    for (const State& k : k_) {
      if (const int i = firstNonFiniteOf(k); i >= 0) return i;
    }
    return -1;
  }
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  using Vector = Eigen::Vector2d;
  using Rest = std::array<Vector, kPairs>;  ///< N of every pair
  struct Place {
    std::size_t i;  ///< number of the pair
    int a, b;       ///< its two state components
  };

  static Vector get(Place p, const State& y) { return {y[p.a], y[p.b]}; }
  static void put(Place p, State& y, const Vector& v) {
    y[p.a] = v[0];
    y[p.b] = v[1];
  }
  template <class Function>
  void forPairs(Function&& function) const {
    for (int i = 0; i < pairs_; ++i) {
      const auto [a, b] = System::pair(i);
      const auto p = static_cast<std::size_t>(i);
      function(Place{p, a, b}, kept_[current_].pairs[p]);
    }
  }
  void rests(const State& y, const State& dydt, Rest& n) const {
    forPairs(
        [&](Place p, const PairConstants&) { n[p.i] = get(p, dydt) - linear_[p.i] * get(p, y); });
  }
  /// The constants of one length of step; working them out takes far longer than a step.
  struct Constants {
    double step = 0;  ///< s; 0: none yet
    std::array<PairConstants, kPairs> pairs{};
  };
  /// Where a tick is divided, at instants that lie alike in every tick, a few lengths of step
  /// return again and again.
  static constexpr std::size_t kKept = 8;

  static bool holds(const Constants& constants, double h) {
    return std::abs(h - constants.step) <= 1e-9 * h;
  }
  [[gnu::noinline]] void setStep(const System& f, double h) {
    for (current_ = 0; current_ < kKept; ++current_)
      if (holds(kept_[current_], h)) return;
    current_ = oldest_;
    oldest_ = (oldest_ + 1) % kKept;
    kept_[current_].step = h;
    pairs_ = 0;
    for (int i = 0; i < kPairs; ++i) {
      const auto p = static_cast<std::size_t>(i);
      linear_[p] = f.linear(i);
      if (!linear_[p].isZero(0)) pairs_ = i + 1;
      kept_[current_].pairs[p] = pairConstants(linear_[p], h);
    }
  }

  std::array<State, 4> k_{};
  std::array<Eigen::Matrix2d, kPairs> linear_{};
  std::array<Constants, kKept> kept_{};
  std::size_t current_ = 0, oldest_ = 0;
  int pairs_ =
      kPairs;  ///< the first so many; of those behind every A is 0, and RK4 serves them as well
  bool startKnown_ = false;
  std::int64_t evaluations_ = 0;
};

}  // namespace rotorbench::ode
