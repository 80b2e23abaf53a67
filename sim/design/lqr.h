// Linear-quadratic regulators: the state feedback u = -K x of least cost.
#pragma once

#include "sim/design/integral_action.h"
#include "sim/design/linear_system.h"

namespace rotorbench {

/// What deviations cost: x' Q x + u' R u + 2 x' N u, per second or per sample. Q n x n and R m x m
/// symmetric (to 1e-10), R definite, [Q N; N' R] semidefinite; N n x m or empty for zero. Units
/// such that all terms agree.
struct QuadraticCost {
  Eigen::MatrixXd Q, R, N = {};
};

/// Q and R with 1 / (largest acceptable value)^2 on their diagonals, a deviation of that size in
/// any one costing 1. Source: Bryson and Ho, "Applied Optimal Control" (1975). Throws an InputError
/// for values that are not positive.
QuadraticCost brysonCost(const Eigen::VectorXd& largestStates,
                         const Eigen::VectorXd& largestInputs);

struct LqrDesign {
  Eigen::MatrixXd gain;    ///< K, m x n, unit of the input per unit of the state
  Eigen::MatrixXd P;       ///< n x n: x' P x is the cost from x on
  Eigen::VectorXcd poles;  ///< of A - B K
  double residual = 0;     ///< of the Riccati equation, see RiccatiSolution
};

/// Of x' = A x + B u: least integral of the cost over time. Throws an InputError of one sentence if
/// shapes do not fit, the cost is not as QuadraticCost wants it, the inputs cannot stabilise a mode
/// or the cost does not see one that does not decay by itself (which is said). Modes within 1e-8
/// |A| of the boundary count as on it. Sources: Kalman (1960); see solveCare.
LqrDesign lqr(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const QuadraticCost& cost);

/// Of x(k+1) = A x(k) + B u(k): least sum of the cost over all samples; else as lqr. See solveDare.
LqrDesign sampledLqr(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const QuadraticCost& cost);

/// A regulator of the plant with integrators behind its outputs, and its gain in two parts.
struct LqiDesign {
  LqrDesign all;
  IntegralGain gain;
};

/// `cost` is over the states and then the integrals of the outputs (see withIntegrators); throws as
/// that and lqr do.
LqiDesign lqi(const LinearSystem& plant, const QuadraticCost& cost);

/// Of a plant sampled with `period` (s).
LqiDesign sampledLqi(const LinearSystem& plant, double period, const QuadraticCost& cost);

}  // namespace rotorbench
