#include "sim/design/linear_system.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "sim/core/error.h"
#include "sim/design/balancing.h"

namespace rotorbench {

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kReach = 1e-11;  // above the rounding of a model in other coordinates

/// Without what is rounding of an exact zero: balancing would take a lone cos(pi/2) for a coupling
/// in small units and enlarge it.
Eigen::MatrixXd withoutRounding(Eigen::MatrixXd matrix) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    const double least = 4 * kEps * matrix.col(j).cwiseAbs().maxCoeff();
    for (double& entry : matrix.col(j))
      if (std::abs(entry) <= least) entry = 0;
  }
  return matrix;
}

/// A pair in units that suit it: states balanced, time over 1 / |A|, inputs of length one.
struct ScaledPair {
  Eigen::MatrixXd A, B;
  double rate = 1;  ///< of A, what time was scaled with

  ScaledPair(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    A = withoutRounding(a);
    B = withoutRounding(b);
    for (auto column : B.colwise())
      if (column.norm() > 0) column.normalize();
    const Eigen::VectorXd d = balancing(A, B);
    A = balanced(A, d);
    B = d.cwiseInverse().asDiagonal() * B;
    for (auto column : B.colwise())
      if (column.norm() > 0) column.normalize();
    if (A.norm() > 0) rate = A.norm();
    A /= rate;
  }
};

void checkPair(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  checkSystem({A, B, Eigen::MatrixXd(0, A.rows()), Eigen::MatrixXd(0, B.cols()), {}, {}, {}});
}

Eigen::MatrixXd krylov(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::Index n = A.rows(), m = B.cols();
  Eigen::MatrixXd s(n, n * m);
  for (Eigen::Index k = 0; k < n; ++k)
    s.middleCols(k * m, m) = k == 0 ? B : A * s.middleCols((k - 1) * m, m);
  return s;
}

}  // namespace

void checkSystem(const LinearSystem& system) {
  const auto& [A, B, C, D, states, inputs, outputs] = system;
  const Eigen::Index n = A.rows(), m = B.cols(), p = C.rows();
  if (A.cols() != n || n == 0) refuse("linear model", "A is not square", "n rows and n columns");
  if (B.rows() != n) refuse("linear model", "B has not as many rows as A");
  if (C.cols() != n) refuse("linear model", "C has not as many columns as A");
  if (D.rows() != p || D.cols() != m)
    refuse("linear model", "D has not the rows of C and the columns of B");
  if (!A.allFinite() || !B.allFinite() || !C.allFinite() || !D.allFinite())
    refuse("linear model", "an entry is no number", "finite numbers");
  const auto names = [](const std::vector<std::string>& list, Eigen::Index count,
                        const std::string& of) {
    if (!list.empty() && std::ssize(list) != count)
      refuse("linear model", "there are not as many names as " + of, "one name for each, or none");
  };
  names(states, n, "states");
  names(inputs, m, "inputs");
  names(outputs, p, "outputs");
}

LinearSystem stateSystem(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  LinearSystem system{A,
                      B,
                      Eigen::MatrixXd::Identity(A.rows(), A.rows()),
                      Eigen::MatrixXd::Zero(A.rows(), B.cols()),
                      {},
                      {},
                      {}};
  checkSystem(system);
  return system;
}

Eigen::VectorXcd poles(const Eigen::MatrixXd& A) {
  if (A.rows() != A.cols()) refuse("linear model", "A is not square", "n rows and n columns");
  if (!A.allFinite()) refuse("linear model", "an entry is no number", "finite numbers");
  if (A.rows() == 0) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(balanced(A, balancing(A)), false);
  if (solver.info() != Eigen::Success) refuse("linear model", "the poles of A cannot be found");
  Eigen::VectorXcd found = solver.eigenvalues();
  std::sort(found.begin(), found.end(), [](std::complex<double> a, std::complex<double> b) {
    if (a.real() != b.real()) return a.real() < b.real();
    if (std::abs(a.imag()) != std::abs(b.imag())) return std::abs(a.imag()) < std::abs(b.imag());
    return a.imag() > b.imag();
  });
  return found;
}

RankReport controllability(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  checkPair(A, B);
  RankReport report{krylov(A, B), {}, 0, 0};
  if (B.cols() == 0) return report;
  const ScaledPair scaled(A, B);
  const Eigen::MatrixXd s = equilibrated(krylov(scaled.A, scaled.B));
  report.singularValues = Eigen::JacobiSVD<Eigen::MatrixXd>(s).singularValues();
  report.tolerance = kReach;
  const double least = report.tolerance * report.singularValues[0];
  report.rank = (report.singularValues.array() > least).count();
  return report;
}

RankReport observability(const Eigen::MatrixXd& A, const Eigen::MatrixXd& C) {
  RankReport report = controllability(A.transpose(), C.transpose());
  report.matrix.transposeInPlace();
  return report;
}

Eigen::VectorXcd uncontrollableModes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  checkPair(A, B);
  ScaledPair pair(A, B);
  const Eigen::Index n = A.rows();
  // Each turn splits the states not yet reached into those the last ones drive and the rest.
  Eigen::MatrixXd& a = pair.A;
  Eigen::MatrixXd drive = pair.B;
  Eigen::Index reached = 0;
  while (reached < n && drive.cols() > 0) {
    const Eigen::Index left = n - reached;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(drive, Eigen::ComputeFullU);
    const Eigen::Index rank = (svd.singularValues().array() > kReach).count();
    if (rank == 0) break;
    a.bottomRows(left) = (svd.matrixU().transpose() * a.bottomRows(left)).eval();
    a.rightCols(left) = (a.rightCols(left) * svd.matrixU()).eval();
    drive = a.block(reached + rank, reached, left - rank, rank);
    reached += rank;
  }
  const Eigen::Index left = n - reached;
  if (left == 0) return {};
  return pair.rate * poles(a.bottomRightCorner(left, left));
}

Eigen::VectorXcd unobservableModes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& C) {
  return uncontrollableModes(A.transpose(), C.transpose());
}

std::vector<AxisControllability> controllabilityByInput(const LinearSystem& system) {
  checkSystem(system);
  const Eigen::MatrixXd a = withoutRounding(system.A), b = withoutRounding(system.B);
  std::vector<AxisControllability> axes;
  for (Eigen::Index input = 0; input < b.cols(); ++input) {
    Eigen::VectorX<bool> reached = b.col(input).array() != 0;
    for (Eigen::Index turn = 0; turn < a.rows(); ++turn)
      for (Eigen::Index from = 0; from < a.rows(); ++from)
        if (reached[from]) reached = reached.array() || (a.col(from).array() != 0);
    AxisControllability axis;
    axis.input = input;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      if (reached[i]) axis.states.push_back(i);
    if (!axis.states.empty()) {
      const Eigen::MatrixXd own = system.A(axis.states, axis.states);
      const Eigen::MatrixXd drive = system.B(axis.states, std::vector<Eigen::Index>{input});
      axis.kalman = controllability(own, drive);
      axis.stuck = uncontrollableModes(own, drive);
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

}  // namespace rotorbench
