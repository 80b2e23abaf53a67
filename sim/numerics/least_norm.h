// The shortest of the best solutions of a linear system.
#pragma once

#include <Eigen/Core>

namespace rotorbench {

/// x of least norm among those for which |a x - b| is least. Any shape, any rank; sizes must agree.
Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace rotorbench
