#include "sim/core/axis_marks.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {

namespace {

constexpr double kMarkRounding = 1e-9;  // of a step

/// A product each, for sums of steps would drift; counted from 0, for far out an index has no next.
std::vector<double> multiples(double first, double last, double step) {
  std::vector<double> marks;
  for (double k = 0; k <= last - first; ++k) {
    const double i = first + k;
    marks.push_back(i == 0 ? 0 : i * step);
  }
  return marks;
}

double indexBelow(double low, double step) {
  return std::floor(low / step + kMarkRounding);
}
double indexAbove(double high, double step) {
  return std::ceil(high / step - kMarkRounding);
}

}  // namespace

double markStep(double width, int most) {
  const double rough = width / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= rough * (1 - kMarkRounding)) return digit * power;
  }
  return 10 * power;
}

std::vector<double> marksWithin(double low, double high, double step) {
  return multiples(std::ceil(low / step - kMarkRounding), std::floor(high / step + kMarkRounding),
                   step);
}

std::array<double, 2> marksBeyond(double low, double high, double step) {
  return {indexBelow(low, step) * step, indexAbove(high, step) * step};
}

std::vector<double> marksAround(double low, double high, double step) {
  const double first = indexBelow(low, step);
  return multiples(first, std::max(first + 1, indexAbove(high, step)), step);
}

int markDecimals(double step) {
  return std::max(0, -static_cast<int>(std::floor(std::log10(step) + kMarkRounding)));
}

}  // namespace rotorbench
