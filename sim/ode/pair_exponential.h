// The constants of exponential time differencing for one two-by-two linear part A and step h:
// matrix exponentials and the phi functions phi_k(z) = integral over s in [0, 1] of exp((1 - s) z)
// s^(k-1) / (k-1)!, worked out once in extended precision. Any A is allowed, singular and zero
// included.
#pragma once

#include <Eigen/Core>
#include <array>

namespace rotorbench::ode {

/// phi_0 = exp, phi_1, phi_2, phi_3 of z: Taylor series after halving z until its norm is below
/// 1/2, then the doubling formula phi_k(2z) = 2^-k (phi_0(z) phi_k(z) + sum over j = 1..k of
/// phi_j(z) / (k - j)!). Hochbruck and Ostermann, Acta Numerica 19 (2010) 209-286, section 2
/// (definition and recurrence).
std::array<Eigen::Matrix<long double, 2, 2>, 4> phiFunctions(Eigen::Matrix<long double, 2, 2> z);

/// Cox and Matthews (2002), eqs. (26)-(29), with the factor h already inside.
struct PairConstants {
  Eigen::Matrix2d expHalf, expFull;  ///< exp(hA/2), exp(hA)
  Eigen::Matrix2d half;              ///< h/2 phi_1(hA/2)
  Eigen::Matrix2d first;             ///< h (phi_1 - 3 phi_2 + 4 phi_3), weight of the first stage
  Eigen::Matrix2d middle;            ///< h (2 phi_2 - 4 phi_3), weight of both middle stages
  Eigen::Matrix2d last;              ///< h (4 phi_3 - phi_2), weight of the last stage
};
PairConstants pairConstants(const Eigen::Matrix2d& a, double h);

}  // namespace rotorbench::ode
