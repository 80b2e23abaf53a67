#include "sim/design/polynomial.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/design/balancing.h"

namespace rotorbench {

namespace {

using Complex = std::complex<double>;
using Extended = long double;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedVector = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;

/// p(s) * (s^2 + b s + c), or p(s) * (s + b) if `degree` is 1; 1 first.
ExtendedVector times(const ExtendedVector& p, int degree, Extended b, Extended c) {
  const Eigen::Index n = p.size();
  ExtendedVector product = ExtendedVector::Zero(n + degree);
  product.head(n) += p;
  product.segment(1, n) += b * p;
  if (degree == 2) product.segment(2, n) += c * p;
  return product;
}

ExtendedVector productOf(const Eigen::VectorXcd& poles) {
  ExtendedVector p = ExtendedVector::Ones(1);
  for (const PoleFactor& factor : factorsOf(poles)) {
    const Extended re = factor.pole.real(), im = factor.pole.imag();
    p = factor.pair() ? times(p, 2, -2 * re, re * re + im * im) : times(p, 1, -re, 0);
  }
  return p;
}

}  // namespace

std::vector<PoleFactor> factorsOf(const Eigen::VectorXcd& poles) {
  constexpr double kAlike = 1e-10;
  std::vector<PoleFactor> factors;
  std::vector<bool> used(static_cast<std::size_t>(poles.size()), false);
  for (Eigen::Index i = 0; i < poles.size(); ++i) {
    const Complex pole = poles[i];
    if (!std::isfinite(pole.real()) || !std::isfinite(pole.imag()))
      refuse("poles", "a pole is no number", "finite numbers");
    if (used[static_cast<std::size_t>(i)]) continue;
    if (std::abs(pole.imag()) <= kAlike * 1e-3 * std::abs(pole)) {
      factors.push_back({pole.real()});
      continue;
    }
    Eigen::Index partner = i + 1;
    while (partner < poles.size() &&
           (used[static_cast<std::size_t>(partner)] ||
            std::abs(poles[partner] - std::conj(pole)) > kAlike * std::abs(pole)))
      ++partner;
    if (partner == poles.size())
      refuse("poles", "the pole " + poleText(pole) + " lacks its conjugate",
             "complex poles in pairs, " + poleText({pole.real(), std::abs(pole.imag())}) + " and " +
                 poleText({pole.real(), -std::abs(pole.imag())}));
    used[static_cast<std::size_t>(partner)] = true;
    const Complex middle = 0.5 * (pole + std::conj(poles[partner]));
    factors.push_back({{middle.real(), std::abs(middle.imag())}});
  }
  return factors;
}

Eigen::VectorXd polynomialOf(const Eigen::VectorXcd& poles) {
  return productOf(poles).cast<double>();
}

Eigen::VectorXd characteristicPolynomial(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows();
  if (n == 0) return Eigen::VectorXd::Ones(1);
  const ExtendedMatrix a = balanced(A, balancing(A)).cast<Extended>();
  ExtendedMatrix h = a;
  if (n > 2) h = Eigen::HessenbergDecomposition<ExtendedMatrix>(a).matrixH();
  // leading[k]: the polynomial of the first k rows and columns; expansion along the last column.
  std::vector<ExtendedVector> leading{ExtendedVector::Ones(1)};
  for (Eigen::Index k = 1; k <= n; ++k) {
    ExtendedVector p = times(leading.back(), 1, -h(k - 1, k - 1), 0);
    Extended chain = 1;
    for (Eigen::Index j = k - 2; j >= 0; --j) {
      chain *= h(j + 1, j);
      const ExtendedVector& minor = leading[static_cast<std::size_t>(j)];
      p.tail(minor.size()) -= h(j, k - 1) * chain * minor;
    }
    leading.push_back(p);
  }
  return leading.back().cast<double>();
}

double polynomialError(const Eigen::MatrixXd& A, const Eigen::VectorXcd& poles) {
  const Eigen::VectorXd wanted = polynomialOf(poles), got = characteristicPolynomial(A);
  if (wanted.size() != got.size()) refuse("poles", "there are not as many poles as states");
  const Eigen::VectorXcd alike = -poles.cwiseAbs().cast<Complex>();
  const Eigen::VectorXd size = polynomialOf(alike);
  double most = 0;
  for (Eigen::Index i = 0; i < got.size(); ++i) {
    const double off = std::abs(got[i] - wanted[i]);
    if (std::isnan(off)) return off;
    // All poles at zero: the coefficients themselves.
    most = std::max(most, size[i] > 0 ? off / size[i] : off);
  }
  return most;
}

std::string poleText(Complex pole) {
  const std::string re = shortNumber(pole.real(), 6);
  if (pole.imag() == 0) return re;
  return re + (pole.imag() < 0 ? " - " : " + ") + shortNumber(std::abs(pole.imag()), 6) + "i";
}

std::string poleListText(const Eigen::VectorXcd& poles) {
  std::vector<std::string> words;
  for (const Complex pole : poles) {
    if (pole.imag() < 0) continue;
    words.push_back(pole.imag() == 0
                        ? poleText(pole)
                        : shortNumber(pole.real(), 6) + " ± " + shortNumber(pole.imag(), 6) + "i");
  }
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace rotorbench
