// Plants to design controllers for: eight of the kinds that vehicles and textbooks have, and random
// ones from a seed.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "sim/core/random.h"

namespace rotorbench::test {

inline Eigen::VectorXcd poleList(const std::vector<std::complex<double>>& poles) {
  return Eigen::Map<const Eigen::VectorXcd>(poles.data(), std::ssize(poles));
}

struct DesignPlant {
  std::string name;
  Eigen::MatrixXd A, B;
  std::vector<std::complex<double>> wanted;  ///< poles
  double period = 0.01;                      ///< s

  [[nodiscard]] Eigen::VectorXcd poles() const { return poleList(wanted); }
};

inline std::vector<DesignPlant> designPlants() {
  using Matrix = Eigen::MatrixXd;
  std::vector<DesignPlant> plants;
  plants.push_back(
      {"double-integrator", Matrix{{0, 1}, {0, 0}}, Matrix{{0}, {1}}, {{-1, 1}, {-1, -1}}, 0.1});
  // Luukkonen (2011): Ixx 4.856e-3 kg m^2; motors of 50 ms.
  plants.push_back({"roll-with-motor-lag",
                    Matrix{{0, 1, 0}, {0, 0, 1 / 4.856e-3}, {0, 0, -20}},
                    Matrix{{0}, {0}, {20}},
                    {{-10, 1}, {-10, -1}, -30},
                    0.004});
  plants.push_back({"position-via-attitude",
                    Matrix{{0, 1, 0, 0}, {0, 0, 9.80665, 0}, {0, 0, 0, 1}, {0, 0, 0, 0}},
                    Matrix{{0}, {0}, {0}, {1 / 4.856e-3}},
                    {{-1, 1}, {-1, -1}, {-6, 3}, {-6, -3}},
                    0.02});
  // Messner and Tilbury, Control Tutorials for MATLAB: M 0.5 kg, m 0.2 kg, b 0.1 N s/m, l 0.3 m,
  // I 0.006 kg m^2.
  const double M = 0.5, m = 0.2, b = 0.1, l = 0.3, I = 0.006, g = 9.8;
  const double p = I * (M + m) + M * m * l * l;
  plants.push_back({"inverted-pendulum",
                    Matrix{{0, 1, 0, 0},
                           {0, -(I + m * l * l) * b / p, m * m * g * l * l / p, 0},
                           {0, 0, 0, 1},
                           {0, -m * l * b / p, m * g * l * (M + m) / p, 0}},
                    Matrix{{0}, {(I + m * l * l) / p}, {0}, {m * l / p}},
                    {{-2, 1}, {-2, -1}, -5, -6},
                    0.01});
  // (s - 1) / ((s - 2) (s + 1) (s + 3))
  plants.push_back({"unstable-non-minimum-phase",
                    Matrix{{-2, 5, 6}, {1, 0, 0}, {0, 1, 0}},
                    Matrix{{1}, {0}, {0}},
                    {-1.5, {-2, 2}, {-2, -2}},
                    0.05});
  // Kautsky, Nichols and Van Dooren (1985), example 1: a chemical reactor.
  plants.push_back({"two-inputs-four-states",
                    Matrix{{1.38, -0.2077, 6.715, -5.676},
                           {-0.5814, -4.29, 0, 0.675},
                           {1.067, 4.273, -6.654, 5.893},
                           {0.048, 4.273, 1.343, -2.104}},
                    Matrix{{0, 0}, {5.679, 0}, {1.136, -3.146}, {1.136, 0}},
                    {-0.2, -0.5, -5.0566, -8.6659},
                    0.05});
  // Attitude and body rates with rotors' momentum and products of inertia.
  plants.push_back({"three-inputs-six-states",
                    Matrix{{0, 0, 0, 1, 0, 0},
                           {0, 0, 0, 0, 1, 0},
                           {0, 0, 0, 0, 0, 1},
                           {0, 0, 0, -0.3, 3, 0.2},
                           {0, 0, 0, -2.5, -0.4, 0.1},
                           {0, 0, 0, 0.1, 0.2, -0.05}},
                    Matrix{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {120, 4, -3}, {4, 110, 2}, {-3, 2, 60}},
                    {{-3, 2}, {-3, -2}, {-4, 1}, {-4, -1}, -5, -6},
                    0.01});
  // A lift drive: position in micrometres, speed in m/s, force in kN, current in microamperes.
  const Eigen::Vector4d unit(1e-6, 1, 1e3, 1e-6);
  const Matrix inSi{{0, 1, 0, 0}, {0, -0.3, 0.8, 0}, {0, 0, -40, 15}, {0, -7, 0, -900}};
  plants.push_back({"badly-scaled",
                    unit.cwiseInverse().asDiagonal() * inSi * unit.asDiagonal(),
                    unit.cwiseInverse().asDiagonal() * Matrix{{0}, {0}, {0}, {2000}},
                    {{-2, 1}, {-2, -1}, -60, -1000},
                    0.002});
  return plants;
}

/// n states, m inputs, all entries normal with deviation 1.
inline DesignPlant randomPlant(RandomStream& random, Eigen::Index n, Eigen::Index m) {
  DesignPlant plant;
  plant.name = "random " + std::to_string(n) + " x " + std::to_string(m);
  plant.A = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random.normal(); });
  plant.B = Eigen::MatrixXd::NullaryExpr(n, m, [&] { return random.normal(); });
  while (std::ssize(plant.wanted) < n) {
    const double real = -0.5 - 4 * random.uniform(), imag = 0.2 + 3 * random.uniform();
    if (std::ssize(plant.wanted) + 1 < n && random.uniform() < 0.5) {
      plant.wanted.emplace_back(real, imag);
      plant.wanted.emplace_back(real, -imag);
    } else {
      plant.wanted.emplace_back(real);
    }
  }
  return plant;
}

/// The largest |got - wanted| / |wanted| of all entries; of zeros wanted, |got| over the largest.
inline double relativeError(const Eigen::MatrixXd& got, const Eigen::MatrixXd& wanted) {
  if (got.rows() != wanted.rows() || got.cols() != wanted.cols()) return INFINITY;
  if (!got.allFinite() || !wanted.allFinite()) return INFINITY;
  double most = 0;
  const double largest = wanted.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < got.size(); ++i) {
    const double size = std::abs(wanted.reshaped()[i]);
    const double off = std::abs(got.reshaped()[i] - wanted.reshaped()[i]);
    if (off > 0) most = std::max(most, off / (size > 0 ? size : largest));
  }
  return most;
}

/// How far the farthest pole is from the one of the other list nearest to it, over its magnitude
/// (or 1 if that is less).
inline double poleError(const Eigen::VectorXcd& got, Eigen::VectorXcd wanted) {
  if (got.size() != wanted.size()) return INFINITY;
  double most = 0;
  for (const std::complex<double> pole : got) {
    Eigen::Index nearest = 0;
    const double off = (wanted.array() - pole).abs().minCoeff(&nearest);
    most = std::max(most, off / std::max(1.0, std::abs(pole)));
    wanted[nearest] = INFINITY;  // taken
  }
  return most;
}

}  // namespace rotorbench::test
