// Butcher tableaux of the one-step methods: stage times c, stage weights a, solution weights b, and
// for the embedded pairs the fourth-order weights and the error weights e = b4 - b. The embedded
// methods advance the fifth-order solution (local extrapolation). Sources: RK5(4)7M, 6M, 7S: J. R.
// Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26, tables 2 and 3 there; dense weights
// of 7M: L. F. Shampine, Math. Comp. 46 (1986) 135-150, in the form of Hairer's CONTD5. The order
// conditions are tested, which also settles the sign of 189/55 in 6M.
#pragma once

#include <array>

namespace rotorbench::ode {

struct EulerTableau {
  static constexpr int kStages = 1;
  static constexpr int kOrder = 1;
  static constexpr bool kFirstSameAsLast = false;
  static constexpr std::array<double, 1> kC{0.0};
  static constexpr std::array<std::array<double, 1>, 1> kA{};
  static constexpr std::array<double, 1> kB{1.0};
};

struct Rk4Tableau {
  static constexpr int kStages = 4;
  static constexpr int kOrder = 4;
  static constexpr bool kFirstSameAsLast = false;
  static constexpr std::array<double, 4> kC{0.0, 1.0 / 2, 1.0 / 2, 1.0};
  static constexpr std::array<std::array<double, 4>, 4> kA{{
      {},
      {1.0 / 2},
      {0.0, 1.0 / 2},
      {0.0, 0.0, 1.0},
  }};
  static constexpr std::array<double, 4> kB{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
};

struct Rk547MTableau {
  static constexpr int kStages = 7;
  static constexpr int kOrder = 5;
  static constexpr bool kFirstSameAsLast = true;
  static constexpr std::array<double, 7> kC{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  static constexpr std::array<std::array<double, 7>, 7> kA{{
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
  }};
  static constexpr std::array<double, 7> kB{35.0 / 384,     0.0,       500.0 / 1113, 125.0 / 192,
                                            -2187.0 / 6784, 11.0 / 84, 0.0};
  static constexpr std::array<double, 7> kB4{
      5179.0 / 57600, 0.0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};
  static constexpr std::array<double, 7> kError{
      -71.0 / 57600, 0.0, 71.0 / 16695, -71.0 / 1920, 17253.0 / 339200, -22.0 / 525, 1.0 / 40};
  /// Weights of the fifth coefficient of the free fourth-order interpolant.
  static constexpr std::array<double, 7> kDense{
      -12715105075.0 / 11282082432.0,  0.0,
      87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
      701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
      69997945.0 / 29380423.0};
};

struct Rk546MTableau {
  static constexpr int kStages = 6;
  static constexpr int kOrder = 5;
  static constexpr bool kFirstSameAsLast = false;
  static constexpr std::array<double, 6> kC{0.0, 1.0 / 5, 3.0 / 10, 3.0 / 5, 2.0 / 3, 1.0};
  static constexpr std::array<std::array<double, 6>, 6> kA{{
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {3.0 / 10, -9.0 / 10, 6.0 / 5},
      {226.0 / 729, -25.0 / 27, 880.0 / 729, 55.0 / 729},
      {-181.0 / 270, 5.0 / 2, -266.0 / 297, -91.0 / 27, 189.0 / 55},
  }};
  static constexpr std::array<double, 6> kB{19.0 / 216,   0.0,       1000.0 / 2079,
                                            -125.0 / 216, 81.0 / 88, 5.0 / 56};
  static constexpr std::array<double, 6> kB4{31.0 / 540,   0.0,         190.0 / 297,
                                             -145.0 / 108, 351.0 / 220, 1.0 / 20};
  static constexpr std::array<double, 6> kError{-11.0 / 360, 0.0,       10.0 / 63,
                                                -55.0 / 72,  27.0 / 40, -11.0 / 280};
};

struct Rk547STableau {
  static constexpr int kStages = 7;
  static constexpr int kOrder = 5;
  static constexpr bool kFirstSameAsLast = true;
  static constexpr std::array<double, 7> kC{0.0, 2.0 / 9, 1.0 / 3, 5.0 / 9, 2.0 / 3, 1.0, 1.0};
  static constexpr std::array<std::array<double, 7>, 7> kA{{
      {},
      {2.0 / 9},
      {1.0 / 12, 1.0 / 4},
      {55.0 / 324, -25.0 / 108, 50.0 / 81},
      {83.0 / 330, -13.0 / 22, 61.0 / 66, 9.0 / 110},
      {-19.0 / 28, 9.0 / 4, 1.0 / 7, -27.0 / 7, 22.0 / 7},
      {19.0 / 200, 0.0, 3.0 / 5, -243.0 / 400, 33.0 / 40, 7.0 / 80},
  }};
  static constexpr std::array<double, 7> kB{19.0 / 200, 0.0,      3.0 / 5, -243.0 / 400,
                                            33.0 / 40,  7.0 / 80, 0.0};
  static constexpr std::array<double, 7> kB4{
      431.0 / 5000, 0.0, 333.0 / 500, -7857.0 / 10000, 957.0 / 1000, 193.0 / 2000, -1.0 / 50};
  static constexpr std::array<double, 7> kError{-11.0 / 1250, 0.0,        33.0 / 500, -891.0 / 5000,
                                                33.0 / 250,   9.0 / 1000, -1.0 / 50};
};

}  // namespace rotorbench::ode
