// A measured series against a computed one: the computed one is read between its points at the
// abscissa of each measured point; residual = measured - computed. Points outside the computed
// range, and what is not finite, are left out and counted.
//   RMSE = sqrt(mean r^2),  R^2 = 1 - sum r^2 / sum (m - mean m)^2
#pragma once

#include <span>
#include <string>
#include <vector>

namespace rotorbench {

/// One channel over another; the abscissa of a computed series may come in any order and its points
/// are sorted.
struct Series {
  std::vector<double> x, y;
};

struct ResidualFigures {
  std::size_t count = 0;    ///< points compared
  std::size_t outside = 0;  ///< measured points outside the computed range
  double rmse = 0;
  double mean = 0;       ///< of measured - computed
  double mostApart = 0;  ///< largest |measured - computed|
  double mostApartAt = 0;
  double rSquared = 0;  ///< NaN where the measured values do not vary
  double range = 0;     ///< largest less smallest measured value compared
};

struct ResidualReport {
  ResidualFigures figures;
  std::vector<double> x, measured, computed;  ///< the points compared, in rising x
  std::vector<std::string> sentences;         ///< what was left out, or why nothing can be compared
  [[nodiscard]] double residual(std::size_t i) const { return measured[i] - computed[i]; }
};

/// Compares; with nothing to compare, `figures.count` is 0 and a sentence says why. Where several
/// computed points have the same x, the last one counts.
ResidualReport compareSeries(const Series& measured, const Series& computed);

}  // namespace rotorbench
