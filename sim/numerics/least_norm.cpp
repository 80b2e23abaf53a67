#include "sim/numerics/least_norm.h"

#include <Eigen/QR>

namespace rotorbench {

Eigen::VectorXd leastNormSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

}  // namespace rotorbench
