// What every way of placing poles asks first. For the room's own use.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/design/polynomial.h"

namespace rotorbench::placement {

/// The poles in factors, once shapes, number and controllability are as they must be; throws an
/// InputError else.
std::vector<PoleFactor> checkedFactors(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                       const Eigen::VectorXcd& poles);

/// In how many independent ways the inputs act: the rank of B with states balanced and columns of
/// length one, tolerance n m eps.
Eigen::Index independentInputs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace rotorbench::placement
