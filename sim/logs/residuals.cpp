#include "sim/logs/residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

using Point = std::pair<double, double>;

/// The finite points in rising x, the order of equal ones kept.
std::vector<Point> finitePoints(const Series& series) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
      points.emplace_back(series.x[i], series.y[i]);
  }
  std::ranges::stable_sort(points, {}, &Point::first);
  return points;
}

std::string rangeText(const std::vector<Point>& points) {
  return numberText(points.front().first) + " to " + numberText(points.back().first);
}

/// Precondition: x lies between the first and the last point.
double valueAt(const std::vector<Point>& points, double x) {
  const auto above = std::ranges::upper_bound(points, x, {}, &Point::first);
  if (above == points.end()) return points.back().second;
  const Point &a = *std::prev(above), &b = *above;
  return a.second + (x - a.first) / (b.first - a.first) * (b.second - a.second);
}

ResidualFigures figuresOf(const ResidualReport& report) {
  ResidualFigures f = report.figures;
  f.count = report.x.size();
  const auto n = static_cast<double>(f.count);
  double sum = 0, squares = 0, measuredSum = 0;
  for (std::size_t i = 0; i < f.count; ++i) {
    const double r = report.residual(i);
    sum += r, squares += r * r, measuredSum += report.measured[i];
    if (std::abs(r) >= f.mostApart) f.mostApart = std::abs(r), f.mostApartAt = report.x[i];
  }
  double spread = 0;
  for (const double m : report.measured) spread += std::pow(m - measuredSum / n, 2);
  const auto [low, high] = std::ranges::minmax(report.measured);
  f.rmse = std::sqrt(squares / n);
  f.mean = sum / n;
  f.rSquared = spread > 0 ? 1 - squares / spread : std::numeric_limits<double>::quiet_NaN();
  f.range = high - low;
  return f;
}

}  // namespace

ResidualReport compareSeries(const Series& measured, const Series& computed) {
  ResidualReport report;
  const std::vector<Point> m = finitePoints(measured), c = finitePoints(computed);
  if (m.empty() || c.empty()) {
    report.sentences.emplace_back(m.empty() ? "There are no measured numbers to compare."
                                            : "There are no computed numbers to compare with.");
    return report;
  }
  for (const auto& [x, y] : m) {
    if (x < c.front().first || x > c.back().first) {
      ++report.figures.outside;
      continue;
    }
    report.x.push_back(x);
    report.measured.push_back(y);
    report.computed.push_back(valueAt(c, x));
  }
  if (report.x.empty()) {
    report.sentences.push_back("The ranges do not overlap: measured " + rangeText(m) +
                               ", computed " + rangeText(c) + ".");
    return report;
  }
  if (report.figures.outside > 0) {
    report.sentences.push_back(
        std::to_string(report.figures.outside) + " of " + std::to_string(m.size()) +
        " measured points lie outside the computed range " + rangeText(c) + " and are left out.");
  }
  report.figures = figuresOf(report);
  return report;
}

}  // namespace rotorbench
