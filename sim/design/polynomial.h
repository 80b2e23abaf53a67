// Polynomials of poles: from a list of poles to coefficients, and from a matrix to the same.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

namespace rotorbench {

/// A pole that is real, or a pair: `pole` with positive imaginary part and its conjugate.
struct PoleFactor {
  std::complex<double> pole;
  [[nodiscard]] bool pair() const { return pole.imag() != 0; }
};

/// The poles as real ones and pairs, in their order. Parts of a pair may differ by rounding (1e-10
/// of the pole). Throws an InputError if one is not finite or lacks its conjugate.
std::vector<PoleFactor> factorsOf(const Eigen::VectorXcd& poles);

/// 1, c1, ..., cn of s^n + c1 s^(n-1) + ... + cn with these roots (n + 1 numbers). Throws as
/// factorsOf does.
Eigen::VectorXd polynomialOf(const Eigen::VectorXcd& poles);

/// The coefficients of det(s I - A), 1 first (n + 1 numbers), by La Budde's recursion on the
/// balanced Hessenberg form in extended precision. Source: Rehman and Ipsen, "La Budde's method for
/// computing characteristic polynomials" (2011).
Eigen::VectorXd characteristicPolynomial(const Eigen::MatrixXd& A);

/// The largest difference of the coefficients, each as a fraction of what it would be if all of
/// these poles pulled the same way (the polynomial with the roots -|pole|): where poles lie left of
/// the imaginary axis, about the relative error of each coefficient.
double polynomialError(const Eigen::MatrixXd& A, const Eigen::VectorXcd& poles);

/// A pole as a person writes it: "-2", "-10 + 1i", "-10 ± 1i".
std::string poleText(std::complex<double> pole);

/// Poles after another, of a pair the one above the axis with "±"; "-10 ± 1i and 0".
std::string poleListText(const Eigen::VectorXcd& poles);

}  // namespace rotorbench
