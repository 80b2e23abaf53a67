#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/design/balancing.h"
#include "sim/design/riccati.h"

namespace rotorbench {

namespace {

constexpr int kMostDoublings = 60;  // 2^60 periods: what has not settled by then does not

Eigen::MatrixXd evened(const Eigen::MatrixXd& m) {
  return 0.5 * (m + m.transpose());
}

/// P (I + G P)^-1, without forming an inverse.
Eigen::MatrixXd damped(const Eigen::MatrixXd& P, const Eigen::MatrixXd& G) {
  const Eigen::MatrixXd sum = Eigen::MatrixXd::Identity(P.rows(), P.rows()) + G * P;
  return evened(sum.transpose().partialPivLu().solve(P).transpose());
}

double dareResidual(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G, const Eigen::MatrixXd& Q,
                    const Eigen::MatrixXd& P) {
  const Eigen::MatrixXd ahead = A.transpose() * damped(P, G) * A;
  const double terms = P.norm() + ahead.norm() + Q.norm();
  return terms > 0 ? (P - ahead - Q).norm() / terms : 0;
}

/// The doubling: H after k turns is the cost of 2^k periods.
Eigen::MatrixXd doubled(Eigen::MatrixXd a, Eigen::MatrixXd g, Eigen::MatrixXd h) {
  constexpr double kSettled = 4 * std::numeric_limits<double>::epsilon();
  const Eigen::Index n = a.rows();
  for (int turn = 0; turn < kMostDoublings; ++turn) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd::Identity(n, n) + g * h);
    const Eigen::MatrixXd nextA = lu.solve(a), reach = lu.solve(g);
    const Eigen::MatrixXd rise = evened(a.transpose() * h * nextA);
    g = evened(g + a * reach * a.transpose());
    a = (a * nextA).eval();
    h += rise;
    if (!h.allFinite() || !g.allFinite()) break;
    if (rise.norm() <= kSettled * h.norm()) return h;
  }
  refuse("Riccati equation", "it has no solution that stabilises: poles stay on the boundary",
         "a plant the inputs can stabilise and weights on what does not decay by itself");
}

/// Hewer's steps while they help.
void refineDare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& G,
                const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R, RiccatiSolution& solution) {
  constexpr int kMostSteps = 4;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::MatrixXd reach = B.transpose() * solution.P;
    const Eigen::MatrixXd gain = evened(R + reach * B).llt().solve(reach * A);
    const Eigen::MatrixXd next = solveStein(A - B * gain, evened(Q + gain.transpose() * R * gain));
    if (!next.allFinite()) return;
    const double residual = dareResidual(A, G, Q, next);
    if (!(residual < solution.residual)) return;
    solution = {next, residual};
  }
}

}  // namespace

Eigen::MatrixXd solveStein(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  Eigen::MatrixXd a = A, x = Q;
  for (int turn = 0; turn < kMostDoublings; ++turn) {
    const Eigen::MatrixXd rise = a.transpose() * x * a;
    x += rise;
    a = (a * a).eval();
    // What is left to add falls with the square of a.
    if (!x.allFinite() || rise.norm() <= 1e-20 * x.norm()) break;
  }
  return evened(x);
}

RiccatiSolution solveDare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R) {
  const Eigen::VectorXd d = balancing(A, B);
  const Eigen::MatrixXd a = balanced(A, d), b = d.cwiseInverse().asDiagonal() * B;
  Eigen::MatrixXd g = evened(b * R.llt().solve(b.transpose()));
  Eigen::MatrixXd q = d.asDiagonal() * Q * d.asDiagonal();
  // P in a unit in which both its terms are alike in size.
  const double unit = g.norm() > 0 && q.norm() > 0 ? std::sqrt(q.norm() / g.norm()) : 1;
  g *= unit;
  q /= unit;
  RiccatiSolution solution{doubled(a, g, q), 0};
  solution.residual = dareResidual(a, g, q, solution.P);
  refineDare(a, b, g, q, R / unit, solution);
  const Eigen::VectorXd back = d.cwiseInverse();
  solution.P = (unit * (back.asDiagonal() * solution.P * back.asDiagonal())).eval();
  return solution;
}

}  // namespace rotorbench
