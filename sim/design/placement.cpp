#include "sim/design/placement.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <complex>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/design/balancing.h"
#include "sim/design/placement_checks.h"
#include "sim/design/polynomial.h"

namespace rotorbench {

namespace {

using Extended = long double;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedRow = Eigen::Matrix<Extended, 1, Eigen::Dynamic>;

/// row * phi(A), factor by factor: no power of A is ever formed.
ExtendedRow timesPolynomial(ExtendedRow row, const ExtendedMatrix& A,
                            const std::vector<PoleFactor>& factors) {
  for (const PoleFactor& factor : factors) {
    const Extended re = factor.pole.real(), im = factor.pole.imag();
    const ExtendedRow once = row * A - re * row;
    row = factor.pair() ? ExtendedRow(once * A - re * once + im * im * row) : once;
  }
  return row;
}

void checkOneColumn(const Eigen::MatrixXd& b) {
  if (b.cols() != 1)
    refuse("pole placement", "B has " + std::to_string(b.cols()) + " columns", "one input");
}

double conditionOf(const Eigen::MatrixXd& closed) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(balanced(closed, balancing(closed)));
  if (solver.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd values =
      Eigen::JacobiSVD<Eigen::MatrixXcd>(solver.eigenvectors()).singularValues();
  const double least = values[values.size() - 1];
  // Vectors of a defective pole differ by rounding only.
  return least > std::numeric_limits<double>::epsilon() * values[0]
             ? values[0] / least
             : std::numeric_limits<double>::infinity();
}

}  // namespace

namespace placement {

std::vector<PoleFactor> checkedFactors(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                       const Eigen::VectorXcd& poles) {
  const Eigen::VectorXcd stuck = uncontrollableModes(A, B);
  if (poles.size() != A.rows())
    refuse("pole placement",
           std::to_string(poles.size()) + " poles are given for " + std::to_string(A.rows()) +
               " states",
           "one pole for each state");
  std::vector<PoleFactor> factors = factorsOf(poles);
  if (stuck.size() > 0)
    refuse("pole placement", "no input moves the mode at " + poleListText(stuck),
           "a plant whose modes the inputs reach");
  return factors;
}

Eigen::Index independentInputs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (B.cols() == 0) return 0;
  Eigen::MatrixXd b = balancing(A, B).cwiseInverse().asDiagonal() * B;
  for (auto column : b.colwise())
    if (column.norm() > 0) column.normalize();
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(b).singularValues();
  const double least =
      static_cast<double>(b.size()) * std::numeric_limits<double>::epsilon() * values[0];
  return (values.array() > least).count();
}

}  // namespace placement

Eigen::MatrixXd ackermann(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b,
                          const Eigen::VectorXcd& poles) {
  checkOneColumn(b);
  const std::vector<PoleFactor> factors = placement::checkedFactors(A, b, poles);
  const Eigen::Index n = A.rows();
  const Eigen::MatrixXd s = controllability(A, b).matrix;
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(n, n - 1);
  const Eigen::RowVectorXd row = s.transpose().colPivHouseholderQr().solve(last).transpose();
  return timesPolynomial(row.cast<Extended>(), A.cast<Extended>(), factors).cast<double>();
}

Eigen::MatrixXd placeSingleInput(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b,
                                 const Eigen::VectorXcd& poles) {
  checkOneColumn(b);
  const std::vector<PoleFactor> factors = placement::checkedFactors(A, b, poles);
  const Eigen::Index n = A.rows();
  const Eigen::VectorXd d = balancing(A, b);
  ExtendedMatrix a = balanced(A, d).cast<Extended>();
  const ExtendedMatrix drive = (d.cwiseInverse().asDiagonal() * b).cast<Extended>();

  // Only the first state of the new ones is driven, and each of the others by the one before it.
  const Eigen::HouseholderQR<ExtendedMatrix> reflection(drive);
  ExtendedMatrix turn = reflection.householderQ();
  a = (turn.transpose() * a * turn).eval();
  if (n > 2) {
    const Eigen::HessenbergDecomposition<ExtendedMatrix> hessenberg(a);
    a = hessenberg.matrixH();
    turn = (turn * ExtendedMatrix(hessenberg.matrixQ())).eval();
  }
  Extended chain = reflection.matrixQR()(0, 0);
  for (Eigen::Index i = 1; i < n; ++i) chain *= a(i, i - 1);
  const ExtendedRow last = ExtendedRow::Unit(n, n - 1) / chain;
  const ExtendedRow gain = timesPolynomial(last, a, factors) * turn.transpose();
  return gain.cast<double>() * d.cwiseInverse().asDiagonal();
}

Placement placePoles(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                     const Eigen::VectorXcd& wanted) {
  placement::checkedFactors(A, B, wanted);
  Placement result;
  if (placement::independentInputs(A, B) == 1) {
    // B = b v' with v of length one: K = v k, and k is that of b = B v.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(B, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd share = svd.matrixV().col(0);
    result.gain = B.cols() == 1 ? placeSingleInput(A, B, wanted)
                                : Eigen::MatrixXd(share * placeSingleInput(A, B * share, wanted));
  } else {
    result.gain = placeRobustly(A, B, wanted);
  }
  const Eigen::MatrixXd closed = A - B * result.gain;
  result.error = polynomialError(closed, wanted);
  if (!(result.error <= kPlacementTolerance))
    refuse("pole placement",
           "rounding alone moves the polynomial of these poles by " + shortNumber(result.error, 2) +
               " of its coefficients",
           "poles less sensitive: further apart, or nearer to where the plant has them");
  result.poles = poles(closed);
  result.condition = conditionOf(closed);
  return result;
}

}  // namespace rotorbench
