#include "sim/design/discretise.h"

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/design/balancing.h"

namespace rotorbench {

namespace {

void checkPeriod(double period) {
  if (!(period > 0) || !std::isfinite(period))
    refuse("sampling", "the period is " + shortNumber(period, 6) + " s", "a positive time");
}

/// Padé's approximant of degree 13, good to rounding for a 1-norm up to 5.37.
Eigen::MatrixXd padeExponential(const Eigen::MatrixXd& A) {
  // Higham (2005), (2.3): the coefficients of 1, A, A^2, ...
  constexpr double b[] = {64764752532480000,
                          32382376266240000,
                          7771770303897600,
                          1187353796428800,
                          129060195264000,
                          10559470521600,
                          670442572800,
                          33522128640,
                          1323241920,
                          40840800,
                          960960,
                          16380,
                          182,
                          1};
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(A.rows(), A.cols());
  const Eigen::MatrixXd a2 = A * A, a4 = a2 * a2, a6 = a4 * a2;
  const Eigen::MatrixXd highOdd = b[13] * a6 + b[11] * a4 + b[9] * a2;
  const Eigen::MatrixXd lowOdd = b[7] * a6 + b[5] * a4 + b[3] * a2 + b[1] * one;
  const Eigen::MatrixXd highEven = b[12] * a6 + b[10] * a4 + b[8] * a2;
  const Eigen::MatrixXd lowEven = b[6] * a6 + b[4] * a4 + b[2] * a2 + b[0] * one;
  const Eigen::MatrixXd odd = A * (a6 * highOdd + lowOdd), even = a6 * highEven + lowEven;
  return (even - odd).partialPivLu().solve(even + odd);
}

/// Names of inputs on their way, the oldest first.
std::vector<std::string> namesOnTheWay(const std::vector<std::string>& inputs, int periods) {
  std::vector<std::string> names;
  for (int ago = periods; ago > 0; --ago)
    for (const std::string& input : inputs)
      names.push_back(input + ", " + std::to_string(ago) + (ago == 1 ? " period" : " periods") +
                      " ago");
  return names;
}

}  // namespace

Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& A) {
  if (A.rows() != A.cols()) refuse("linear model", "A is not square", "n rows and n columns");
  if (!A.allFinite()) refuse("linear model", "an entry is no number", "finite numbers");
  if (A.rows() == 0) return A;
  constexpr double kLargest = 5.371920351148152;  // Higham (2005), table 2.3
  // Without balancing one large coupling alone would ask for squarings, which lose digits.
  const Eigen::VectorXd d = balancing(A);
  const Eigen::MatrixXd inner = balanced(A, d);
  const double size = inner.cwiseAbs().colwise().sum().maxCoeff();
  const int halvings =
      size > kLargest ? static_cast<int>(std::ceil(std::log2(size / kLargest))) : 0;
  Eigen::MatrixXd result = padeExponential(std::ldexp(1.0, -halvings) * inner);
  for (int i = 0; i < halvings; ++i) result = (result * result).eval();
  result = balanced(result, d.cwiseInverse());
  if (!result.allFinite()) refuse("sampling", "the states grow beyond all numbers within the time");
  return result;
}

HeldStep heldStep(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double t) {
  stateSystem(A, B);  // throws where shapes do not fit
  if (!(t >= 0) || !std::isfinite(t))
    refuse("sampling", "the time is " + shortNumber(t, 6) + " s", "a time that is not negative");
  const Eigen::Index n = A.rows(), m = B.cols();
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n + m, n + m);
  block.topLeftCorner(n, n) = A * t;
  block.topRightCorner(n, m) = B * t;
  const Eigen::MatrixXd e = matrixExponential(block);
  return {e.topLeftCorner(n, n), e.topRightCorner(n, m)};
}

LinearSystem holdSampled(const LinearSystem& continuous, double period, double inputDelay) {
  constexpr double kWhole = 1e-9;  // periods
  checkSystem(continuous);
  checkPeriod(period);
  if (!(inputDelay >= 0) || !(inputDelay / period <= kMostDelayedPeriods))
    refuse("sampling", "the delay is " + shortNumber(inputDelay, 6) + " s",
           "0 to " + std::to_string(kMostDelayedPeriods) + " periods");
  const Eigen::Index n = continuous.A.rows(), m = continuous.B.cols();
  const double inPeriods = inputDelay / period;
  const int periods = static_cast<int>(std::ceil(inPeriods - kWhole));
  // How far into a period the newer of the two inputs at work in it arrives; 0 for whole delays.
  double late = inPeriods - (periods - 1);
  if (periods == 0 || std::abs(late - 1) <= kWhole) late = periods == 0 ? 0 : 1;

  const HeldStep rest = heldStep(continuous.A, continuous.B, (1 - late) * period);
  const HeldStep first = heldStep(continuous.A, continuous.B, late * period);
  const Eigen::MatrixXd newer = rest.input, older = rest.transition * first.input;

  LinearSystem sampled = continuous;
  if (periods == 0) {
    sampled.A = rest.transition;
    sampled.B = newer;
    return sampled;
  }
  // States: x, u(k-d), ..., u(k-1); at work in this period: u(k-d), then u(k-d+1).
  const Eigen::Index all = n + m * periods;
  sampled.A = Eigen::MatrixXd::Zero(all, all);
  sampled.B = Eigen::MatrixXd::Zero(all, m);
  sampled.A.topLeftCorner(n, n) = heldStep(continuous.A, continuous.B, period).transition;
  sampled.A.block(0, n, n, m) = older;
  if (periods == 1) {
    sampled.B.topRows(n) = newer;
  } else {
    sampled.A.block(0, n + m, n, m) = newer;
    sampled.A.block(n, n + m, m * (periods - 1), m * (periods - 1)).setIdentity();
  }
  sampled.B.bottomRows(m).setIdentity();
  sampled.C = Eigen::MatrixXd::Zero(continuous.C.rows(), all);
  sampled.C.leftCols(n) = continuous.C;
  // At the instant itself the older one is still at work.
  sampled.C.middleCols(n, m) = continuous.D;
  sampled.D.setZero();
  if (!sampled.states.empty() && !sampled.inputs.empty())
    for (std::string& name : namesOnTheWay(sampled.inputs, periods))
      sampled.states.push_back(std::move(name));
  else
    sampled.states.clear();
  return sampled;
}

LinearSystem tustinSampled(const LinearSystem& continuous, double period) {
  checkSystem(continuous);
  checkPeriod(period);
  const Eigen::Index n = continuous.A.rows();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd half = continuous.A * (period / 2);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(identity - half);
  if (!(lu.rcond() > std::numeric_limits<double>::epsilon()))
    refuse("sampling", "the model has a pole at 2 / T, which the bilinear rule cannot map",
           "another period than " + shortNumber(period, 6) + " s");
  LinearSystem sampled = continuous;
  sampled.A = lu.solve(identity + half);
  sampled.B = lu.solve(continuous.B * period);
  const Eigen::MatrixXd turned = (identity - half).transpose();
  sampled.C = turned.partialPivLu().solve(continuous.C.transpose()).transpose();
  sampled.D = continuous.D + sampled.C * continuous.B * (period / 2);
  sampled.states.clear();
  return sampled;
}

Eigen::VectorXcd continuousPoles(const Eigen::VectorXcd& z, double period) {
  checkPeriod(period);
  return z.unaryExpr([period](std::complex<double> pole) -> std::complex<double> {
    if (pole == 0.0) return -std::numeric_limits<double>::infinity();
    return std::log(pole) / period;
  });
}

Eigen::VectorXcd sampledPoles(const Eigen::VectorXcd& s, double period) {
  checkPeriod(period);
  return s.unaryExpr([period](std::complex<double> pole) { return std::exp(pole * period); });
}

}  // namespace rotorbench
