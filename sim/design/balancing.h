// Units for the states in which a linear model's numbers are alike in size, so that rounding does
// not depend on whether lengths came in metres or in nanometres.
#pragma once

#include <Eigen/Core>

namespace rotorbench {

/// Powers of two d (n) such that with x = diag(d) x~ the rows and columns of [A~ B~; C~ 0] without
/// A's diagonal have sums alike: A~ = diag(d)^-1 A diag(d), B~ = diag(d)^-1 B, C~ = C diag(d).
/// B (n x m) and C (p x n) may be empty. Exact in floating point. Source: Parlett and Reinsch,
/// "Balancing a matrix for calculation of eigenvalues and eigenvectors" (1969), on the whole system
/// as SLICOT's TB01ID.
Eigen::VectorXd balancing(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B = {},
                          const Eigen::MatrixXd& C = {});

/// diag(d)^-1 A diag(d).
Eigen::MatrixXd balanced(const Eigen::MatrixXd& A, const Eigen::VectorXd& d);

/// The matrix with rows and columns scaled to like lengths (those of zeros left alone), which does
/// not change its rank but lets singular values tell it.
Eigen::MatrixXd equilibrated(Eigen::MatrixXd matrix);

}  // namespace rotorbench
