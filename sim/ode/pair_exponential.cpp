#include "sim/ode/pair_exponential.h"

#include <Eigen/LU>
#include <cmath>

namespace rotorbench::ode {

using Matrix = Eigen::Matrix<long double, 2, 2>;

std::array<Matrix, 4> phiFunctions(Matrix z) {
  const long double size = z.cwiseAbs().rowwise().sum().maxCoeff();
  int halvings = 0;
  if (size > 0.5L) {
    std::frexp(size / 0.5L, &halvings);
    z *= std::ldexp(1.0L, -halvings);
  }
  // phi_k(z) = sum z^n / (n + k)!; with |z| <= 1/2 the twentieth term is below 1e-24.
  std::array<Matrix, 4> phi;
  for (int k = 0; k < 4; ++k) {
    long double factorial = 1.0L;
    for (int i = 2; i <= k; ++i) factorial *= i;
    Matrix term = Matrix::Identity() / factorial;
    Matrix sum = term;
    for (int n = 1; n <= 20; ++n) {
      term = (term * z / static_cast<long double>(n + k)).eval();
      sum += term;
    }
    phi[static_cast<std::size_t>(k)] = sum;
  }
  for (; halvings > 0; --halvings) {
    const auto [p0, p1, p2, p3] = phi;
    phi[3] = (p0 * p3 + p1 / 2.0L + p2 + p3) / 8.0L;
    phi[2] = (p0 * p2 + p1 + p2) / 4.0L;
    phi[1] = (p0 * p1 + p1) / 2.0L;
    phi[0] = p0 * p0;
  }
  return phi;
}

PairConstants pairConstants(const Eigen::Matrix2d& a, double h) {
  const long double step = h;
  const Matrix z = step * a.cast<long double>();
  const auto whole = phiFunctions(z);
  const auto half = phiFunctions(z / 2.0L);
  PairConstants c;
  c.expFull = whole[0].cast<double>();
  c.expHalf = half[0].cast<double>();
  c.half = (step / 2.0L * half[1]).cast<double>();
  c.first = (step * (whole[1] - 3.0L * whole[2] + 4.0L * whole[3])).cast<double>();
  c.middle = (step * (2.0L * whole[2] - 4.0L * whole[3])).cast<double>();
  c.last = (step * (4.0L * whole[3] - whole[2])).cast<double>();
  return c;
}

}  // namespace rotorbench::ode
