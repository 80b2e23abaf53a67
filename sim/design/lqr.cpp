#include "sim/design/lqr.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <string>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/design/balancing.h"
#include "sim/design/polynomial.h"
#include "sim/design/riccati.h"

namespace rotorbench {

namespace {

enum class Time { Continuous, Sampled };

constexpr const char* kSource = "linear-quadratic regulator";

void checkSymmetric(const Eigen::MatrixXd& weights, const std::string& name, Eigen::Index size) {
  constexpr double kAlike = 1e-10;
  if (weights.rows() != size || weights.cols() != size)
    refuse(kSource, name + " has not the size of what it weighs",
           std::to_string(size) + " rows and columns");
  if (!weights.allFinite()) refuse(kSource, name + " has an entry that is no number");
  if ((weights - weights.transpose()).cwiseAbs().maxCoeff() >
      kAlike * weights.cwiseAbs().maxCoeff())
    refuse(kSource, name + " is not symmetric", "the same weight on both sides of its diagonal");
}

/// The least eigenvalue with all diagonal entries brought to one, so that units do not matter;
/// minus one if an entry of the diagonal is negative, or zero beside others that are not.
double leastShare(const Eigen::MatrixXd& weights) {
  const Eigen::Index n = weights.rows();
  Eigen::VectorXd size = weights.diagonal();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (size[i] < 0) return -1;
    if (size[i] == 0 && (weights.row(i).array() != 0).any()) return -1;
    size[i] = size[i] > 0 ? 1 / std::sqrt(size[i]) : 0;
  }
  const Eigen::MatrixXd shares = size.asDiagonal() * weights * size.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(shares, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0];
}

void checkCost(const QuadraticCost& cost, Eigen::Index n, Eigen::Index m) {
  constexpr double kRounding = 1e-12;
  const auto& [Q, R, N] = cost;
  if (m == 0) refuse(kSource, "the plant has no input");
  checkSymmetric(Q, "Q", n);
  checkSymmetric(R, "R", m);
  if (!(leastShare(R) > kRounding))
    refuse(kSource, "R is not positive definite", "weights above zero for every input");
  if (!(leastShare(Q) >= -kRounding * static_cast<double>(n)))
    refuse(kSource, "Q is not positive semidefinite", "weights that are not negative");
  if (N.size() == 0) return;
  if (N.rows() != n || N.cols() != m || !N.allFinite())
    refuse(kSource, "N is not as large as B", "a row for each state, a column for each input");
  Eigen::MatrixXd all(n + m, n + m);
  all << Q, N, N.transpose(), R;
  if (!(leastShare(all) >= -kRounding * static_cast<double>(n + m)))
    refuse(kSource, "Q, R and N together are not positive semidefinite",
           "a cross weight N that its Q and R outweigh");
}

/// Those that do not decay by themselves.
Eigen::VectorXcd lasting(const Eigen::VectorXcd& modes, const Eigen::MatrixXd& A, Time time) {
  constexpr double kOnIt = 1e-8;
  const double near = kOnIt * balanced(A, balancing(A)).norm();
  std::vector<std::complex<double>> kept;
  for (const std::complex<double> mode : modes)
    if (time == Time::Continuous ? mode.real() >= -near : std::abs(mode) >= 1 - kOnIt)
      kept.push_back(mode);
  return Eigen::Map<const Eigen::VectorXcd>(kept.data(), std::ssize(kept));
}

void checkModes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& Q,
                Time time) {
  const Eigen::VectorXcd stuck = lasting(uncontrollableModes(A, B), A, time);
  if (stuck.size() > 0)
    refuse(kSource, "no input stabilises the mode at " + poleListText(stuck),
           "a plant whose unstable modes the inputs reach");
  const Eigen::VectorXcd unseen = lasting(unobservableModes(A, Q), A, time);
  if (unseen.size() > 0)
    refuse(
        kSource,
        "Q does not see the mode at " + poleListText(unseen) + ", which does not decay by itself",
        "a weight on a state that takes part in it");
}

LqrDesign design(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const QuadraticCost& cost,
                 Time time) {
  stateSystem(A, B);  // throws where shapes do not fit
  checkCost(cost, A.rows(), B.cols());
  const Eigen::MatrixXd R = 0.5 * (cost.R + cost.R.transpose());
  const Eigen::LLT<Eigen::MatrixXd> inverse(R);
  // The feedback R^-1 N' alone takes the cross weight away.
  Eigen::MatrixXd a = A, q = 0.5 * (cost.Q + cost.Q.transpose());
  Eigen::MatrixXd across = Eigen::MatrixXd::Zero(B.cols(), A.rows());
  if (cost.N.size() > 0) across = inverse.solve(cost.N.transpose());
  a -= B * across;
  if (cost.N.size() > 0) {
    q -= cost.N * across;
    q = (0.5 * (q + q.transpose())).eval();
  }
  checkModes(a, B, q, time);
  LqrDesign result;
  const RiccatiSolution solution =
      time == Time::Continuous ? solveCare(a, B, q, R) : solveDare(a, B, q, R);
  result.P = solution.P;
  result.residual = solution.residual;
  const Eigen::MatrixXd reach = B.transpose() * result.P;
  if (time == Time::Continuous) {
    result.gain = inverse.solve(reach) + across;
  } else {
    const Eigen::MatrixXd price = R + reach * B;
    result.gain = price.llt().solve(reach * a) + across;
  }
  result.poles = poles(A - B * result.gain);
  return result;
}

}  // namespace

QuadraticCost brysonCost(const Eigen::VectorXd& largestStates,
                         const Eigen::VectorXd& largestInputs) {
  const auto weights = [](const Eigen::VectorXd& largest) {
    for (const double value : largest)
      if (!(value > 0) || !std::isfinite(value))
        refuse(kSource, "a largest value is " + shortNumber(value, 6), "a positive number");
    return Eigen::MatrixXd(largest.cwiseAbs2().cwiseInverse().asDiagonal());
  };
  return {weights(largestStates), weights(largestInputs), {}};
}

LqrDesign lqr(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const QuadraticCost& cost) {
  return design(A, B, cost, Time::Continuous);
}

LqrDesign sampledLqr(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                     const QuadraticCost& cost) {
  return design(A, B, cost, Time::Sampled);
}

LqiDesign lqi(const LinearSystem& plant, const QuadraticCost& cost) {
  const LinearSystem whole = withIntegrators(plant);
  const LqrDesign all = lqr(whole.A, whole.B, cost);
  return {all, splitGain(all.gain, plant.A.rows())};
}

LqiDesign sampledLqi(const LinearSystem& plant, double period, const QuadraticCost& cost) {
  const LinearSystem whole = withIntegrators(plant, period);
  const LqrDesign all = sampledLqr(whole.A, whole.B, cost);
  return {all, splitGain(all.gain, plant.A.rows())};
}

}  // namespace rotorbench
