#include "sim/design/integral_action.h"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/design/balancing.h"

namespace rotorbench {

namespace {

/// Whether [A - z I, B; C, D] has full row rank at rest, z = 0 or sampled 1: no zero there.
bool holdsAtRest(const LinearSystem& plant, double restPole) {
  const Eigen::Index n = plant.A.rows(), m = plant.B.cols(), p = plant.C.rows();
  Eigen::MatrixXd whole(n + p, n + m);
  whole << plant.A - restPole * Eigen::MatrixXd::Identity(n, n), plant.B, plant.C, plant.D;
  const Eigen::VectorXd values =
      Eigen::JacobiSVD<Eigen::MatrixXd>(equilibrated(whole)).singularValues();
  const double least =
      static_cast<double>((n + m) * (n + p)) * std::numeric_limits<double>::epsilon() * values[0];
  return values[n + p - 1] > least;
}

}  // namespace

LinearSystem withIntegrators(const LinearSystem& plant, std::optional<double> period) {
  checkSystem(plant);
  if (period && (!(*period > 0) || !std::isfinite(*period)))
    refuse("integral action", "the period is not positive", "a positive time");
  const Eigen::Index n = plant.A.rows(), m = plant.B.cols(), p = plant.C.rows();
  if (p > m)
    refuse("integral action", "there are more outputs to hold than inputs",
           "at most as many outputs as inputs");
  if (p > 0 && !holdsAtRest(plant, period ? 1 : 0))
    refuse("integral action",
           "no constant input holds the outputs at any set-point: the plant has a zero at rest",
           "outputs that the inputs can move and hold");
  const double step = period.value_or(1);
  LinearSystem all = plant;
  all.A = Eigen::MatrixXd::Zero(n + p, n + p);
  all.A.topLeftCorner(n, n) = plant.A;
  all.A.bottomLeftCorner(p, n) = -step * plant.C;
  if (period) all.A.bottomRightCorner(p, p).setIdentity();
  all.B.resize(n + p, m);
  all.B << plant.B, -step * plant.D;
  all.C = Eigen::MatrixXd::Zero(p, n + p);
  all.C.leftCols(n) = plant.C;
  if (!plant.states.empty() && !plant.outputs.empty())
    for (const std::string& output : plant.outputs) all.states.push_back("integral of " + output);
  else
    all.states.clear();
  return all;
}

IntegralGain splitGain(const Eigen::MatrixXd& gain, Eigen::Index plantStates) {
  if (plantStates < 0 || plantStates > gain.cols())
    refuse("integral action", "the gain has fewer columns than the plant states");
  return {gain.leftCols(plantStates), gain.rightCols(gain.cols() - plantStates)};
}

}  // namespace rotorbench
