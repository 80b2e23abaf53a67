#include "sim/design/balancing.h"

#include <cmath>

namespace rotorbench {

Eigen::VectorXd balancing(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const Eigen::MatrixXd& C) {
  constexpr int kMostSweeps = 200;
  constexpr double kWorthIt = 0.95;  // Parlett and Reinsch's
  const Eigen::Index n = A.rows();
  Eigen::VectorXd d = Eigen::VectorXd::Ones(n);
  Eigen::MatrixXd a = A.cwiseAbs();
  a.diagonal().setZero();
  Eigen::VectorXd in = Eigen::VectorXd::Zero(n), out = Eigen::VectorXd::Zero(n);
  if (B.cols() > 0) in = B.cwiseAbs().rowwise().sum();
  if (C.rows() > 0) out = C.cwiseAbs().colwise().sum().transpose();
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool changed = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double row = a.row(i).sum() + in[i], column = a.col(i).sum() + out[i];
      if (!(row > 0 && column > 0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (column * factor + row / factor >= kWorthIt * (column + row)) continue;
      d[i] *= factor;
      a.col(i) *= factor;
      a.row(i) /= factor;
      out[i] *= factor;
      in[i] /= factor;
      changed = true;
    }
    if (!changed) break;
  }
  return d;
}

Eigen::MatrixXd balanced(const Eigen::MatrixXd& A, const Eigen::VectorXd& d) {
  return d.cwiseInverse().asDiagonal() * A * d.asDiagonal();
}

Eigen::MatrixXd equilibrated(Eigen::MatrixXd matrix) {
  constexpr int kTurns = 10;  // each halves what is left on a logarithmic scale, or better
  for (int turn = 0; turn < kTurns; ++turn) {
    for (auto row : matrix.rowwise())
      if (row.norm() > 0) row /= std::sqrt(row.norm());
    for (auto column : matrix.colwise())
      if (column.norm() > 0) column /= std::sqrt(column.norm());
  }
  return matrix;
}

}  // namespace rotorbench
