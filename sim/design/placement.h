// State feedback u = -K x that gives A - B K the poles wanted, in continuous or sampled time. All
// functions throw an InputError of one sentence if the shapes do not fit, there are not as many
// poles as states, a complex pole lacks its conjugate, or a mode cannot be moved (which one is
// said).
#pragma once

#include "sim/design/linear_system.h"

namespace rotorbench {

/// How far the coefficients of the closed loop may be from those wanted (see polynomialError)
/// before a placement is refused as too sensitive.
inline constexpr double kPlacementTolerance = 1e-8;

struct Placement {
  Eigen::MatrixXd gain;    ///< K, m x n, unit of the input per unit of the state
  Eigen::VectorXcd poles;  ///< of A - B K, computed from it
  double error = 0;        ///< polynomialError of A - B K
  /// Of the closed loop's eigenvectors (2-norm, states balanced): by how much a disturbed entry
  /// moves the poles at most. Infinite where a pole is multiple without vectors enough.
  double condition = 0;
};

/// K (1 x n) by Ackermann's formula as textbooks have it, (0 ... 0 1) S^-1 phi(A): for orders up to
/// six or so; S of more states or far-apart poles loses the digits. Poles as often as wanted.
/// Source: Ackermann, "Der Entwurf linearer Regelungssysteme im Zustandsraum" (1972).
Eigen::MatrixXd ackermann(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b,
                          const Eigen::VectorXcd& poles);

/// The same gain in numerically sound steps: states balanced, (A, b) brought by reflections to
/// Hessenberg form, where S is triangular and only its last entry is needed, and phi multiplied
/// factor by factor onto the last row; extended precision. For any order a controller has.
Eigen::MatrixXd placeSingleInput(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b,
                                 const Eigen::VectorXcd& poles);

/// K (m x n) whose closed loop is as insensitive as several inputs allow: each eigenvector, or pair
/// of them, is turned in turn within what the pole leaves free so that the determinant of the unit
/// vectors grows. Sources: Kautsky, Nichols and Van Dooren, "Robust pole assignment in linear state
/// feedback" (1985), method 0; Tits and Yang, "Globally convergent algorithms for robust pole
/// assignment by state feedback" (1996), for the pairs. No pole more often than the rank of B.
Eigen::MatrixXd placeRobustly(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                              const Eigen::VectorXcd& poles);

/// The gain by placeSingleInput if the inputs act in one way only (rank of B is 1), else by
/// placeRobustly, and the proof of it: throws also if the error is above kPlacementTolerance.
Placement placePoles(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                     const Eigen::VectorXcd& poles);

}  // namespace rotorbench
