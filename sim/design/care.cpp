#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "sim/core/error.h"
#include "sim/design/balancing.h"
#include "sim/design/riccati.h"

namespace rotorbench {

namespace {

using Complex = std::complex<double>;

/// A = U T U* with the eigenvalues of negative real part first.
struct OrderedSchur {
  Eigen::MatrixXcd T, U;
  Eigen::Index stable = 0;

  explicit OrderedSchur(const Eigen::MatrixXd& A) {
    const Eigen::ComplexSchur<Eigen::MatrixXcd> schur(A.cast<Complex>());
    if (schur.info() != Eigen::Success)
      refuse("Riccati equation", "the poles of the closed loop cannot be found");
    T = schur.matrixT();
    U = schur.matrixU();
    for (Eigen::Index i = 0; i < T.rows(); ++i) {
      if (T(i, i).real() >= 0) continue;
      for (Eigen::Index at = i; at > stable; --at) swapWithNext(at - 1);
      ++stable;
    }
  }

 private:
  /// A rotation that exchanges two neighbours on the diagonal.
  void swapWithNext(Eigen::Index k) {
    const Complex first = T(k, k), second = T(k + 1, k + 1);
    Eigen::JacobiRotation<Complex> rotation;
    rotation.makeGivens(T(k, k + 1), second - first);
    T.applyOnTheLeft(k, k + 1, rotation.adjoint());
    T.applyOnTheRight(k, k + 1, rotation);
    U.applyOnTheRight(k, k + 1, rotation);
    T(k + 1, k) = 0;
    T(k, k) = second;
    T(k + 1, k + 1) = first;
  }
};

Eigen::MatrixXd symmetric(const Eigen::MatrixXd& m) {
  return 0.5 * (m + m.transpose());
}

double careResidual(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G, const Eigen::MatrixXd& Q,
                    const Eigen::MatrixXd& P) {
  const Eigen::MatrixXd linear = P * A, square = P * G * P;
  const double terms = 2 * linear.norm() + square.norm() + Q.norm();
  return terms > 0 ? (linear + linear.transpose() - square + Q).norm() / terms : 0;
}

/// Kleinman's steps while they help.
void refineCare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G, const Eigen::MatrixXd& Q,
                RiccatiSolution& solution) {
  constexpr int kMostSteps = 4;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::MatrixXd square = solution.P * G * solution.P;
    const Eigen::MatrixXd next = solveLyapunov(A - G * solution.P, Q + symmetric(square));
    const double residual = careResidual(A, G, Q, next);
    if (!(residual < solution.residual)) return;
    solution = {next, residual};
  }
}

}  // namespace

Eigen::MatrixXd solveLyapunov(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  // With A = U T U*: T* Y + Y T = -U* Q U, column by column.
  const Eigen::Index n = A.rows();
  const Eigen::ComplexSchur<Eigen::MatrixXcd> schur(A.cast<Complex>());
  if (schur.info() != Eigen::Success)
    refuse("Lyapunov equation", "the poles of the closed loop cannot be found");
  const Eigen::MatrixXcd& T = schur.matrixT();
  const Eigen::MatrixXcd& U = schur.matrixU();
  Eigen::MatrixXcd y = -(U.adjoint() * Q.cast<Complex>() * U);
  for (Eigen::Index k = 0; k < n; ++k) {
    y.col(k) -= y.leftCols(k) * T.col(k).head(k);
    Eigen::MatrixXcd lower = T.adjoint();
    lower.diagonal().array() += T(k, k);
    lower.triangularView<Eigen::Lower>().solveInPlace(y.col(k));
  }
  return symmetric((U * y * U.adjoint()).real());
}

RiccatiSolution solveCare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R) {
  const Eigen::Index n = A.rows();
  const Eigen::VectorXd d = balancing(A, B);
  const Eigen::MatrixXd a = balanced(A, d), b = d.cwiseInverse().asDiagonal() * B;
  Eigen::MatrixXd g = symmetric(b * R.llt().solve(b.transpose()));
  Eigen::MatrixXd q = d.asDiagonal() * Q * d.asDiagonal();
  // P in a unit in which both its terms are alike in size.
  const double unit = g.norm() > 0 && q.norm() > 0 ? std::sqrt(q.norm() / g.norm()) : 1;
  g *= unit;
  q /= unit;

  Eigen::MatrixXd hamiltonian(2 * n, 2 * n);
  hamiltonian << a, -g, -q, -a.transpose();
  const OrderedSchur schur(hamiltonian);
  if (schur.stable != n)
    refuse("Riccati equation", "it has no solution that stabilises: poles stay on the boundary",
           "a plant the inputs can stabilise and weights on what does not decay by itself");
  const Eigen::MatrixXcd upper = schur.U.topLeftCorner(n, n),
                         lower = schur.U.bottomLeftCorner(n, n);
  const Eigen::MatrixXcd p =
      Eigen::PartialPivLU<Eigen::MatrixXcd>(upper.transpose()).solve(lower.transpose());
  RiccatiSolution solution{symmetric(p.real()), 0};
  solution.residual = careResidual(a, g, q, solution.P);
  if (!solution.P.allFinite() || std::isnan(solution.residual))
    refuse("Riccati equation", "it has no solution that stabilises",
           "a plant the inputs can stabilise");
  refineCare(a, g, q, solution);
  const Eigen::VectorXd back = d.cwiseInverse();
  solution.P = (unit * (back.asDiagonal() * solution.P * back.asDiagonal())).eval();
  return solution;
}

}  // namespace rotorbench
