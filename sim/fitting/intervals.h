// What a Jacobian at the solution says about the parameters: which ones the data determine, how
// well, and which go together. Used by solveLeastSquares().
#pragma once

#include <Eigen/Core>

#include "sim/fitting/least_squares.h"

namespace rotorbench {

/// Fills half widths, `determined`, remarks and correlation of `result`. `jacobian` has one column
/// per parameter, in residuals per unit of the parameter; `residuals` are weighted. Parameters at a
/// bound are taken as given.
void judgeParameters(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals,
                     FitResult& result);

}  // namespace rotorbench
