#include "sim/numerics/scalar_search.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace rotorbench {

namespace {

/// Stands for what is not finite: parabolas through infinities would be none.
constexpr double kWorstValue = 1e100;

/// Brent's method over parts of the interval, of which its relative tolerance becomes an absolute
/// one. `sign` -1 looks for the greatest value.
Extremum extremumOf(const ScalarFunction& f, double low, double high, double tolerance,
                    double sign) {
  const auto at = [&](double part) { return low + part * (high - low); };
  const auto cost = [&](double part) {
    const double value = sign * f(at(part));
    return std::isfinite(value) ? value : kWorstValue;
  };
  // The method ends within 2.5 * 2^(1 - bits) of the interval; half the bits of a double are the
  // most that a flat function resolves, and the most it takes.
  constexpr double kEnd = 2.5;
  constexpr int kMostBits = std::numeric_limits<double>::digits / 2;
  const double bits = 1 + std::ceil(std::log2(kEnd * (high - low) / tolerance));
  const auto [part, least] = boost::math::tools::brent_find_minima(
      cost, 0.0, 1.0, static_cast<int>(std::clamp(bits, 2.0, 1.0 * kMostBits)));
  const double value = least < kWorstValue ? least : std::numeric_limits<double>::infinity();
  return {at(part), sign * value};
}

}  // namespace

double findRoot(const ScalarFunction& f, double low, double high, double tolerance) {
  return findRoot(f, low, f(low), high, f(high), tolerance);
}

double findRoot(const ScalarFunction& f, double low, double atLow, double high, double atHigh,
                double tolerance) {
  if (!(low < high) || (atLow > 0) == (atHigh > 0))
    return std::abs(atLow) <= std::abs(atHigh) ? low : high;
  const auto close = [tolerance](double a, double b) { return b - a <= 2 * tolerance; };
  std::uintmax_t most = 300;
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, atLow, atHigh, close, most);
  return 0.5 * (a + b);
}

Extremum findMaximum(const ScalarFunction& f, double low, double high, double tolerance) {
  return extremumOf(f, low, high, tolerance, -1);
}

Extremum findMinimum(const ScalarFunction& f, double low, double high, double tolerance) {
  return extremumOf(f, low, high, tolerance, 1);
}

double findLast(const std::function<bool(double)>& holds, double low, double high) {
  constexpr int kHalvings = 60;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace rotorbench
