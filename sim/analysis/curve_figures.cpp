#include "sim/analysis/curve_figures.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {

double largestMagnitude(const Recording& recording, std::string_view channel) {
  const auto column = recording.find(channel);
  double most = 0;
  for (std::size_t row = 0; column && row < recording.rows(); ++row)
    most = std::max(most, std::abs(recording.value(*column, row)));
  return most;
}

double largestValue(const Recording& recording, std::string_view channel) {
  const auto column = recording.find(channel);
  if (!column || recording.rows() == 0) return std::numeric_limits<double>::quiet_NaN();
  double most = recording.value(*column, 0);
  for (std::size_t row = 1; row < recording.rows(); ++row)
    most = std::max(most, recording.value(*column, row));
  return most;
}

CurvePeak peakOf(const Recording& r, std::size_t x, std::size_t y) {
  std::size_t best = 0;
  for (std::size_t row = 0; row < r.rows(); ++row)
    if (r.value(y, row) > r.value(y, best)) best = row;
  if (best == 0 || best + 1 >= r.rows()) return {};
  const double a = r.value(y, best - 1), b = r.value(y, best), c = r.value(y, best + 1);
  const double step = r.value(x, best) - r.value(x, best - 1);
  const double bend = a - 2 * b + c;
  const double off = bend < 0 ? 0.5 * (a - c) / bend : 0;
  return {r.value(x, best) + off * step, b - 0.25 * (a - c) * off};
}

double fallsThroughZero(const Recording& r, std::size_t x, std::size_t y) {
  for (std::size_t row = 1; row < r.rows(); ++row) {
    const double a = r.value(y, row - 1), b = r.value(y, row);
    if (a > 0 && b <= 0)
      return r.value(x, row - 1) + (r.value(x, row) - r.value(x, row - 1)) * a / (a - b);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace rotorbench
