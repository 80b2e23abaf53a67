// Adams-Bashforth-Moulton predictor-corrector of fourth order in PECE form: AB4 predicts, AM3
// corrects, two evaluations a step; the first three steps after a restart or a change of step are
// RK4. (AM3 has +19 f_n; the 2014 thesis prints -19 in eqs. (1.12) and (1.15).) Hairer, Norsett,
// Wanner I, section III.1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sim/ode/runge_kutta.h"
#include "sim/ode/tableau.h"

namespace rotorbench::ode {

template <OdeSystem System>
class Abm4 {
 public:
  using State = typename System::State;
  static constexpr bool kAdaptive = false;

  /// Inputs or state jumped: derivatives from before say nothing about what follows.
  void restart() {
    startKnown_ = false;
    history_ = 0;
  }
  void setStart(const State& derivative) {
    past(0) = derivative;
    startKnown_ = true;
  }
  const State& start(System& f, double t, const State& y) {
    if (!startKnown_) {
      f(t, y, past(0));
      ++evaluations_;
      startKnown_ = true;
    }
    return past(0);
  }

  void step(System& f, double t, double h, const State& y, State& out) {
    if (!(std::abs(h - spacing_) <= kSameStep * h)) {
      history_ = 0;
      spacing_ = h;
    }
    start(f, t, y);
    if (history_ < 3) {
      starter_.setStart(past(0));
      starter_.step(f, t, h, y, out);
      evaluations_ += 3;
      return;
    }
    const double u = h / 24.0;
    const State predicted =
        y + u * (55.0 * past(0) - 59.0 * past(1) + 37.0 * past(2) - 9.0 * past(3));
    f(t + h, predicted, ahead_);
    ++evaluations_;
    out = y + u * (9.0 * ahead_ + 19.0 * past(0) - 5.0 * past(1) + past(2));
  }

  void accept() {
    newest_ = (newest_ + 1) & 3U;
    history_ = std::min(history_ + 1, 3);
    startKnown_ = false;
  }
  void accept(System& f, double t, double end, double h, const State& y0, const State& y1,
              DenseOutput<State>& dense) {
    const State first = past(0);
    accept();
    dense.setHermite(t, h, y0, first, y1, start(f, end, y1));
  }

  [[nodiscard]] int firstNonFinite() const {
    if (const int i = firstNonFiniteOf(f_[newest_]); i >= 0) return i;
    return history_ < 3 ? starter_.firstNonFinite() : firstNonFiniteOf(ahead_);
  }
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  /// Steps that differ by rounding only are equal.
  static constexpr double kSameStep = 1e-9;

  State& past(unsigned age) { return f_[(newest_ - age) & 3U]; }

  std::array<State, 4> f_{};  ///< ring of derivatives at the last four step ends
  unsigned newest_ = 0;
  int history_ = 0;  ///< how many older derivatives are valid
  double spacing_ = 0;
  bool startKnown_ = false;
  State ahead_ = State::Zero();
  RungeKutta<Rk4Tableau, System> starter_;
  std::int64_t evaluations_ = 0;
};

}  // namespace rotorbench::ode
