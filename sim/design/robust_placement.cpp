#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <complex>

#include "sim/core/error.h"
#include "sim/design/balancing.h"
#include "sim/design/placement.h"
#include "sim/design/placement_checks.h"

namespace rotorbench {

namespace {

using Real = long double;
using Complex = std::complex<Real>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using ComplexMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using ComplexVector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

/// Vectors orthogonal to the columns, as many as there is room for beside `count` of them.
template <class Matrix>
Matrix complementOf(const Matrix& columns) {
  const Eigen::Index n = columns.rows(), count = columns.cols();
  if (count == 0) return Matrix::Identity(n, n);
  const Matrix q = Eigen::HouseholderQR<Matrix>(columns).householderQ();
  return q.rightCols(n - count);
}

/// One real pole or a pair, the vectors its eigenvector may be made of, and its place in X.
struct Choice {
  PoleFactor factor;
  RealMatrix real;        ///< orthonormal basis if the pole is real, n x rank of B
  ComplexMatrix complex;  ///< the same of a pair
  Eigen::Index column = 0;
};

/// Eigenvectors of the closed loop, of a pair the real and the imaginary part, and how they are
/// turned.
class Vectors {
 public:
  Vectors(const RealMatrix& A, const RealMatrix& outside, const std::vector<PoleFactor>& factors)
      : x_(RealMatrix::Zero(A.rows(), A.rows())) {
    Eigen::Index column = 0;
    const RealMatrix across = outside.transpose() * A, sides = outside.transpose();
    for (const PoleFactor& factor : factors) {
      Choice choice{factor, {}, {}, column};
      const Complex pole(factor.pole);
      // B can make up for (A - s I) x only where that has no part outside B's columns.
      if (factor.pair()) {
        const ComplexMatrix rest = across.cast<Complex>() - pole * sides.cast<Complex>();
        choice.complex = complementOf<ComplexMatrix>(rest.adjoint());
      } else {
        const RealMatrix rest = across - pole.real() * sides;
        choice.real = complementOf<RealMatrix>(rest.transpose());
      }
      column += factor.pair() ? 2 : 1;
      choices_.push_back(std::move(choice));
    }
    begin();
  }

  /// Turns until the determinant no longer grows by a hundredth a round.
  void spread() {
    constexpr int kMostRounds = 100;
    constexpr Real kWorthIt = 0.01L;
    Real before = size();
    for (int round = 0; round < kMostRounds; ++round) {
      turnAll(static_cast<std::size_t>(round));
      const Real now = size();
      if (now <= before * (1 + kWorthIt) && now > 0) break;
      before = now;
    }
  }

  [[nodiscard]] Real size() const { return std::abs(x_.determinant()); }

  /// The closed loop, X Lambda X^-1.
  [[nodiscard]] RealMatrix closedLoop() const {
    RealMatrix scaled = x_;
    for (const Choice& choice : choices_) {
      const Eigen::Index i = choice.column;
      const Real re = choice.factor.pole.real(), im = choice.factor.pole.imag();
      scaled.col(i) = re * x_.col(i);
      if (!choice.factor.pair()) continue;
      scaled.col(i) -= im * x_.col(i + 1);
      scaled.col(i + 1) = im * x_.col(i) + re * x_.col(i + 1);
    }
    return Eigen::FullPivLU<RealMatrix>(x_.transpose()).solve(scaled.transpose()).transpose();
  }

 private:
  /// Poles asked for several times begin with different vectors.
  void begin() {
    for (std::size_t k = 0; k < choices_.size(); ++k) {
      Eigen::Index times = 0;
      for (std::size_t j = 0; j < k; ++j)
        if (choices_[j].factor.pole == choices_[k].factor.pole) ++times;
      const Choice& choice = choices_[k];
      if (choice.factor.pair())
        putPair(choice, choice.complex.col(times % choice.complex.cols()));
      else
        x_.col(choice.column) = choice.real.col(times % choice.real.cols());
    }
  }

  /// A pair's vector, so long that its parts are as long as a real one on average.
  void putPair(const Choice& choice, const ComplexVector& vector) {
    const ComplexVector sized = vector * (std::sqrt(Real(2)) / vector.norm());
    x_.col(choice.column) = sized.real();
    x_.col(choice.column + 1) = sized.imag();
  }

  /// Two vectors orthogonal to all columns of X but these two.
  [[nodiscard]] RealMatrix besides(Eigen::Index i, Eigen::Index j) const {
    RealMatrix others(x_.rows(), x_.cols() - 2);
    for (Eigen::Index from = 0, to = 0; from < x_.cols(); ++from)
      if (from != i && from != j) others.col(to++) = x_.col(from);
    return complementOf<RealMatrix>(others);
  }

  /// For two columns x, y of X, |det X| is proportional to |x' M y|, M = u v' - v u'.
  [[nodiscard]] RealMatrix areaForm(Eigen::Index i, Eigen::Index j) const {
    const RealMatrix free = besides(i, j);
    return free.col(0) * free.col(1).transpose() - free.col(1) * free.col(0).transpose();
  }

  void turnAll(std::size_t round) {
    std::vector<const Choice*> real;
    for (const Choice& choice : choices_)
      if (choice.factor.pair())
        turnPair(choice);
      else
        real.push_back(&choice);
    if (real.size() == 1) turnAlone(*real[0]);
    // Each round with other partners.
    for (std::size_t k = 0; real.size() > 1 && k < real.size(); ++k)
      turnTwo(*real[k], *real[(k + 1 + round % (real.size() - 1)) % real.size()]);
  }

  /// x' M y with x = S a, y = T b is greatest for the first singular vectors of S' M T.
  void turnTwo(const Choice& one, const Choice& other) {
    const RealMatrix form = one.real.transpose() * areaForm(one.column, other.column) * other.real;
    const Eigen::JacobiSVD<RealMatrix> svd(form, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (!(svd.singularValues()[0] > 0)) return;
    x_.col(one.column) = one.real * svd.matrixU().col(0);
    x_.col(other.column) = other.real * svd.matrixV().col(0);
  }

  /// With x = xr + i xi, xr' M xi = x* (M / 2i) x, a Hermitian form.
  void turnPair(const Choice& choice) {
    const ComplexMatrix form = choice.complex.adjoint() *
                               areaForm(choice.column, choice.column + 1).cast<Complex>() *
                               Complex(0, -0.5L) * choice.complex;
    const Eigen::SelfAdjointEigenSolver<ComplexMatrix> solver(form);
    if (solver.info() != Eigen::Success) return;
    const auto& values = solver.eigenvalues();
    const Eigen::Index last = values.size() - 1;
    const Eigen::Index best = std::abs(values[0]) > std::abs(values[last]) ? 0 : last;
    if (!(std::abs(values[best]) > 0)) return;
    putPair(choice, choice.complex * solver.eigenvectors().col(best));
  }

  /// The only real pole: as far from the others as its vectors allow.
  void turnAlone(const Choice& choice) {
    RealMatrix others(x_.rows(), x_.cols() - 1);
    for (Eigen::Index from = 0, to = 0; from < x_.cols(); ++from)
      if (from != choice.column) others.col(to++) = x_.col(from);
    const RealVector away = complementOf<RealMatrix>(others).col(0);
    const RealVector inside = choice.real * (choice.real.transpose() * away);
    if (inside.norm() > 0) x_.col(choice.column) = inside.normalized();
  }

  RealMatrix x_;
  std::vector<Choice> choices_;
};

void checkMultiplicity(const std::vector<PoleFactor>& factors, Eigen::Index rank) {
  for (const PoleFactor& factor : factors) {
    Eigen::Index times = 0;
    for (const PoleFactor& other : factors) times += other.pole == factor.pole ? 1 : 0;
    if (times > rank)
      refuse("pole placement",
             "the pole " + poleText(factor.pole) + " is wanted " + std::to_string(times) +
                 " times, but the inputs act in " + std::to_string(rank) + " independent ways",
             "each pole at most " + std::to_string(rank) + " times");
  }
}

}  // namespace

Eigen::MatrixXd placeRobustly(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                              const Eigen::VectorXcd& poles) {
  const std::vector<PoleFactor> factors = placement::checkedFactors(A, B, poles);
  const Eigen::Index rank = placement::independentInputs(A, B);
  checkMultiplicity(factors, rank);
  const Eigen::VectorXd d = balancing(A, B);
  const RealMatrix a = balanced(A, d).cast<Real>();
  // Inputs of a like size, so that none is spared for its unit.
  Eigen::MatrixXd drive = d.cwiseInverse().asDiagonal() * B;
  Eigen::VectorXd unit = drive.colwise().norm().transpose();
  unit = (unit.array() > 0).select(unit, 1);
  drive = (drive * unit.cwiseInverse().asDiagonal()).eval();

  const Eigen::JacobiSVD<RealMatrix> svd(drive.cast<Real>(),
                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
  const RealMatrix inside = svd.matrixU().leftCols(rank);
  Vectors vectors(a, svd.matrixU().rightCols(A.rows() - rank), factors);
  vectors.spread();
  if (!(vectors.size() > 0))
    refuse("pole placement", "these poles leave no independent eigenvectors",
           "poles further apart");
  const RealMatrix inner = svd.singularValues().head(rank).cwiseInverse().asDiagonal() *
                           (inside.transpose() * (a - vectors.closedLoop()));
  const Eigen::MatrixXd gain = (svd.matrixV().leftCols(rank) * inner).cast<double>();
  return unit.cwiseInverse().asDiagonal() * gain * d.cwiseInverse().asDiagonal();
}

}  // namespace rotorbench
