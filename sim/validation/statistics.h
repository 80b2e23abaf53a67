// Few numbers that stand for many.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace rotorbench::validation {

/// What a model gives more than was measured, %.
inline double apart(double model, double measured) {
  return 100 * (model / measured - 1);
}

/// NaN for none.
inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

inline std::optional<double> meanIfAny(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(mean(values));
}

/// Linear between order statistics; share 0 to 1. NaN for none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  const std::size_t k = std::min(i + 1, values.size() - 1);
  return values[i] + (place - static_cast<double>(i)) * (values[k] - values[i]);
}

/// Root of the mean square. NaN for none.
inline double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace rotorbench::validation
