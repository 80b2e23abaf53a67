// A root between two points where a function changes sign: bisection that turns to inverse
// quadratic interpolation where that is safe. T. R. Chandrupatla, "A new hybrid quadratic/bisection
// algorithm for finding the zero of a nonlinear function", Advances in Engineering Software 28,
// 1997.
#pragma once

#include <algorithm>
#include <cmath>

namespace rotorbench {

/// x between a and b with f(x) = 0, to within `tolerance` (above 0); fa = f(a) and fb = f(b) have
/// opposite signs or one is 0. Ends after at most 100 evaluations, of which bisection alone needs
/// 60.
template <class Function>
double bracketedRoot(const Function& f, double a, double fa, double b, double fb,
                     double tolerance) {
  double t = 0.5;
  for (int i = 0; i < 100; ++i) {
    const double x = a + t * (b - a), fx = f(x);
    double c, fc;  // the point left over
    if ((fx > 0) == (fa > 0)) {
      c = a, fc = fa;
    } else {
      c = b, fc = fb;
      b = a, fb = fa;
    }
    a = x, fa = fx;
    const double best = std::abs(fa) < std::abs(fb) ? a : b;
    const double width = std::abs(b - a);
    if (fa == 0 || width <= 2 * tolerance) return best;
    const double least = tolerance / width;
    const double xi = (a - b) / (c - b), ratio = (fa - fb) / (fc - fb);
    t = 0.5;
    if (ratio * ratio < xi && (1 - ratio) * (1 - ratio) < 1 - xi) {
      t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    }
    t = std::clamp(t, least, 1 - least);
  }
  return std::abs(fa) < std::abs(fb) ? a : b;
}

}  // namespace rotorbench
