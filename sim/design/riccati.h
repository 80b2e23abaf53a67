// The two algebraic Riccati equations behind linear-quadratic regulators.
#pragma once

#include <Eigen/Core>

namespace rotorbench {

/// P (n x n, symmetric) and how well it solves its equation: the norm of the equation's difference
/// over the sum of the norms of its terms, states balanced.
struct RiccatiSolution {
  Eigen::MatrixXd P;
  double residual = 0;
};

/// The stabilising P of A' P + P A - P B R^-1 B' P + Q = 0. A n x n, B n x m, Q n x n symmetric and
/// semidefinite, R m x m symmetric and definite (not checked: lqr does). Source: Laub, "A Schur
/// method for solving algebraic Riccati equations" (1979), here with a complex Schur form put in
/// order by rotations, states balanced and P in a unit that suits A; then steps of Kleinman, "On an
/// iterative technique for Riccati equation computations" (1968). Throws an InputError if there is
/// no such P.
RiccatiSolution solveCare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R);

/// The stabilising P of P = A' P A - A' P B (R + B' P B)^-1 B' P A + Q, of like shapes; A may be
/// singular. Source: Chu, Fan, Lin and Wang, "Structure-preserving algorithms for periodic
/// discrete-time algebraic Riccati equations" (2004), the doubling of section 2; then steps of
/// Hewer, "An iterative technique for the computation of the steady state gains" (1971). Throws an
/// InputError if there is no such P.
RiccatiSolution solveDare(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                          const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R);

/// X of A' X + X A + Q = 0 for A with poles left of the imaginary axis. Source: Bartels and
/// Stewart, "Solution of the matrix equation AX + XB = C" (1972), complex.
Eigen::MatrixXd solveLyapunov(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q);

/// X of X = A' X A + Q for A with poles inside the unit circle. Source: Smith, "Matrix equation
/// XA + BX = C" (1968), squared.
Eigen::MatrixXd solveStein(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q);

}  // namespace rotorbench
