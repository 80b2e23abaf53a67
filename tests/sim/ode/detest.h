// Right-hand sides and initial values of the Toronto nonstiff test set DETEST: T. E. Hull, W. H.
// Enright, B. M. Fellen, A. E. Sedgwick, "Comparing numerical methods for ordinary differential
// equations", SIAM J. Numer. Anal. 9 (1972) 603-637, and W. H. Enright, J. D. Pryce, ACM TOMS 13
// (1987) 1-27. Problems of fewer than four components are padded with components that stay zero.
#pragma once

#include <cmath>
#include <numbers>

#include "tests/sim/ode/function_system.h"

namespace rotorbench::test {

using State4 = FunctionSystem<4>::State;

struct SmallProblem {
  const char* name;
  FunctionSystem<4>::Function f;
};

inline double forcing(double t) {
  return std::fmod(std::floor(t), 2.0) == 0.0 ? 1.0 : -1.0;
}

inline void kepler(double, const State4& y, State4& d) {
  const double r3 = std::pow(y[0] * y[0] + y[1] * y[1], 1.5);
  d << y[2], y[3], -y[0] / r3, -y[1] / r3;
}

inline const SmallProblem kSmallProblems[] = {
    {"A1", [](double, const State4& y, State4& d) { d << -y[0], 0, 0, 0; }},
    {"A2", [](double, const State4& y, State4& d) { d << -0.5 * y[0] * y[0] * y[0], 0, 0, 0; }},
    {"A3", [](double t, const State4& y, State4& d) { d << y[0] * std::cos(t), 0, 0, 0; }},
    {"A4", [](double, const State4& y, State4& d) { d << 0.25 * y[0] * (1 - y[0] / 20), 0, 0, 0; }},
    {"A5", [](double t, const State4& y, State4& d) { d << (y[0] - t) / (y[0] + t), 0, 0, 0; }},
    {"B1", [](double, const State4& y,
              State4& d) { d << 2 * (y[0] - y[0] * y[1]), -(y[1] - y[0] * y[1]), 0, 0; }},
    {"B2", [](double, const State4& y,
              State4& d) { d << -y[0] + y[1], y[0] - 2 * y[1] + y[2], y[1] - y[2], 0; }},
    {"B3",
     [](double, const State4& y, State4& d) { d << -y[0], y[0] - y[1] * y[1], y[1] * y[1], 0; }},
    {"B4",
     [](double, const State4& y, State4& d) {
       const double r = std::hypot(y[0], y[1]);
       d << -y[1] - y[0] * y[2] / r, y[0] - y[1] * y[2] / r, y[0] / r, 0;
     }},
    {"B5", [](double, const State4& y,
              State4& d) { d << y[1] * y[2], -y[0] * y[2], -0.51 * y[0] * y[1], 0; }},
    {"D1", kepler},
    {"D2", kepler},
    {"D3", kepler},
    {"D4", kepler},
    {"D5", kepler},
    {"E1",
     [](double t, const State4& y, State4& d) {
       d << y[1], -(y[1] / (t + 1) + (1 - 0.25 / ((t + 1) * (t + 1))) * y[0]), 0, 0;
     }},
    {"E2",
     [](double, const State4& y, State4& d) { d << y[1], (1 - y[0] * y[0]) * y[1] - y[0], 0, 0; }},
    {"E3",
     [](double t, const State4& y, State4& d) {
       d << y[1], y[0] * y[0] * y[0] / 6 - y[0] + 2 * std::sin(2.78535 * t), 0, 0;
     }},
    {"E4", [](double, const State4& y, State4& d) { d << y[1], 0.032 - 0.4 * y[1] * y[1], 0, 0; }},
    {"E5", [](double t, const State4& y,
              State4& d) { d << y[1], std::sqrt(1 + y[1] * y[1]) / (25 - t), 0, 0; }},
    {"F1",
     [](double t, const State4& y, State4& d) {
       constexpr double a = 0.1;
       d << y[1], 2 * a * y[1] - (std::numbers::pi * std::numbers::pi + a * a) * y[0] + forcing(t),
           0, 0;
     }},
    {"F2", [](double t, const State4& y,
              State4& d) { d << 55 - (forcing(t) > 0 ? 1.5 : 0.5) * y[0], 0, 0, 0; }},
    {"F3",
     [](double t, const State4& y, State4& d) {
       d << y[1], 0.01 * y[1] * (1 - y[0] * y[0]) - y[0] - std::abs(std::sin(std::numbers::pi * t)),
           0, 0;
     }},
    {"F4",
     [](double t, const State4& y, State4& d) {
       d.setZero();
       d[0] = t <= 10 ? -2.0 / 21 - 120 * (t - 5) / std::pow(1 + 4 * (t - 5) * (t - 5), 16)
                      : -2 * y[0];
     }},
    {"F5",
     [](double t, const State4& y, State4& d) {
       double c = 0;
       double sum = 0;
       for (int i = 1; i <= 19; ++i) {
         c += std::pow(i, 4.0 / 3);
         sum += std::copysign(std::cbrt(std::abs(t - i)), t - i);
       }
       d << 4.0 / (3 * c) * sum * y[0], 0, 0, 0;
     }},
};

using State10 = FunctionSystem<10>::State;
using State51 = FunctionSystem<51>::State;
using State30 = FunctionSystem<30>::State;

inline void problemC1(double, const State10& y, State10& d) {
  d[0] = -y[0];
  for (int i = 1; i < 9; ++i) d[i] = y[i - 1] - y[i];
  d[9] = y[8];
}
inline void problemC2(double, const State10& y, State10& d) {
  d[0] = -y[0];
  for (int i = 1; i < 9; ++i) d[i] = i * y[i - 1] - (i + 1) * y[i];
  d[9] = 9 * y[8];
}
/// C3 (ten components) and C4 (fifty-one): the second-difference matrix.
template <class State>
void heat(double, const State& y, State& d) {
  const auto n = y.size();
  for (int i = 0; i < n; ++i) {
    d[i] = -2 * y[i] + (i > 0 ? y[i - 1] : 0.0) + (i + 1 < n ? y[i + 1] : 0.0);
  }
}
/// C5: motion of the five outer planets about the Sun; positions (x, y, z of each), then
/// velocities.
inline void problemC5(double, const State30& y, State30& d) {
  constexpr double k2 = 2.95912208286;
  constexpr double sun = 1.00000597682;
  constexpr double mass[] = {0.000954786104043, 0.000285583733151, 0.0000437273164546,
                             0.0000517759138449, 0.00000277777777778};
  using Vector = Eigen::Vector3d;
  const auto at = [&](Eigen::Index j) -> Vector { return y.segment<3>(3 * j); };
  d.head<15>() = y.tail<15>();
  for (int j = 0; j < 5; ++j) {
    Vector a = -(sun + mass[j]) * at(j) / std::pow(at(j).norm(), 3);
    for (int k = 0; k < 5; ++k) {
      if (k == j) continue;
      const Vector apart = at(k) - at(j);
      a += mass[k] * (apart / std::pow(apart.norm(), 3) - at(k) / std::pow(at(k).norm(), 3));
    }
    d.segment<3>(15 + 3 * j) = k2 * a;
  }
}

}  // namespace rotorbench::test
