// Roots, maxima and minima of a function of one variable, and where a condition ends: for what is
// asked now and then, Boost.Math behind it. In loops that run within a derivative or a blade's
// solution bracketed_root.h is inlined instead.
//   root      algorithm 748: G. E. Alefeld, F. A. Potra, Y. Shi, ACM Trans. Math. Software 21, 1995
//   extremum  R. P. Brent, Algorithms for Minimization without Derivatives, 1973, chapter 5
// x and f(x) in whatever units the caller has. What f throws passes through.
#pragma once

#include <functional>

namespace rotorbench {

using ScalarFunction = std::function<double(double)>;

/// x between low and high with f(x) = 0, to within `tolerance` (above 0), for low <= high and an f
/// that is 0 at an end or changes its sign between them. If it has one sign at both, because of
/// rounding or because there is no root, the end where it is nearer to 0. At most about 300 calls;
/// smooth functions take about 8.
double findRoot(const ScalarFunction& f, double low, double high, double tolerance);
/// The same where f is known at the ends.
double findRoot(const ScalarFunction& f, double low, double atLow, double high, double atHigh,
                double tolerance);

struct Extremum {
  double at = 0;     ///< x
  double value = 0;  ///< f(x)
};

/// The greatest or least value between low < high, to within `tolerance` (above 0) in x, no finer
/// than 1e-7 of the interval, for f is flat there. Some local extremum where there are several; an
/// end only to within the tolerance. Where f is not finite it counts as worse than anywhere else;
/// if it is finite nowhere the value is infinite.
Extremum findMaximum(const ScalarFunction& f, double low, double high, double tolerance);
Extremum findMinimum(const ScalarFunction& f, double low, double high, double tolerance);

/// The last x from low on where `holds`, which beyond does not hold up to high: to within 2^-60 of
/// the interval, from below. `low` is taken to hold; 60 calls.
double findLast(const std::function<bool(double)>& holds, double low, double high);

}  // namespace rotorbench
