#include "ui/charts/decimate.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {
namespace {

/// First row in [from, rows) with abscissa >= t: gallops from a guess, since columns follow one another.
std::size_t gallop(const Recording& recording, std::size_t from, std::size_t rows, double t,
                   std::size_t guess) {
  std::size_t low = from;  // every row before low is below t
  std::size_t step = std::max<std::size_t>(1, guess);
  std::size_t high = low;
  while (high < rows && recording.value(0, high) < t) {
    low = high + 1;
    high = std::min(rows, high + step);
    step *= 2;
  }
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (recording.value(0, middle) < t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

void addRow(const Recording& recording, const ColumnSummary& summary, std::size_t row, QList<QPointF>& points) {
  const double y = summary.value(row);
  const double x = recording.value(0, row);
  if (std::isfinite(y) && std::isfinite(x)) points.append({x, y});
}

}  // namespace

std::vector<std::size_t> columnBounds(const Recording& recording, std::size_t rows, const AxisScale& x,
                                      int columns) {
  std::vector<std::size_t> bounds;
  bounds.reserve(static_cast<std::size_t>(columns) + 1);
  std::size_t guess = 64;
  std::size_t row = gallop(recording, 0, rows, x.span.low, rows / 2);
  bounds.push_back(row);
  for (int i = 1; i < columns; ++i) {
    const std::size_t next = gallop(recording, row, rows, x.fromUnit(static_cast<double>(i) / columns), guess);
    guess = (next - row) / 2 + 1;
    bounds.push_back(row = next);
  }
  // The last column holds its right edge too.
  const double beyond = std::nextafter(x.span.high, std::numeric_limits<double>::infinity());
  bounds.push_back(gallop(recording, row, rows, beyond, guess));
  return bounds;
}

QList<QPointF> decimate(const Recording& recording, const ColumnSummary& summary,
                        const std::vector<std::size_t>& bounds) {
  QList<QPointF> points;
  const std::size_t rows = summary.rows();
  const std::size_t begin = std::min(bounds.front(), rows);
  const std::size_t end = std::min(bounds.back(), rows);
  points.reserve(static_cast<qsizetype>(2 * bounds.size() + 2));
  if (begin > 0) addRow(recording, summary, begin - 1, points);
  if (end - begin <= 2 * bounds.size()) {
    for (std::size_t row = begin; row < end; ++row) addRow(recording, summary, row, points);
  } else {
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const Extremes extremes = summary.extremes(std::min(bounds[i], rows), std::min(bounds[i + 1], rows));
      if (extremes.empty()) continue;
      const auto [first, second] = std::minmax(extremes.rowOfMin, extremes.rowOfMax);
      addRow(recording, summary, first, points);
      if (second != first) addRow(recording, summary, second, points);
    }
  }
  if (end < rows) addRow(recording, summary, end, points);
  return points;
}

void XyTrace::restartIfChanged(const AxisScale& x, const AxisScale& y, double widthPx, double heightPx) {
  if (x == x_ && y == y_ && widthPx == width_ && heightPx == height_) return;
  x_ = x;
  y_ = y;
  width_ = widthPx;
  height_ = heightPx;
  rows_ = 0;
  points_.clear();
  lastIsLoose_ = false;
}

std::size_t XyTrace::update(const Recording& recording, std::size_t xChannel, std::size_t yChannel,
                            const AxisScale& x, const AxisScale& y, double widthPx, double heightPx,
                            std::size_t mostRows) {
  restartIfChanged(x, y, widthPx, heightPx);
  const std::size_t before = rows_;
  const std::size_t goal = std::min(recording.rows(), rows_ + mostRows);
  while (rows_ < goal) {
    const auto xs = recording.column(xChannel, rows_);
    const auto ys = recording.column(yChannel, rows_);
    const std::size_t count = std::min({xs.size(), ys.size(), goal - rows_});
    for (std::size_t i = 0; i < count; ++i) {
      const double unitX = x.toUnit(xs[i]);
      const double unitY = y.toUnit(ys[i]);
      if (!std::isfinite(unitX) || !std::isfinite(unitY)) continue;
      // All that lies outside falls into one ring of cells.
      const double cellX = std::clamp(std::floor(unitX * widthPx), -1.0, widthPx + 1);
      const double cellY = std::clamp(std::floor(unitY * heightPx), -1.0, heightPx + 1);
      const bool here = !points_.isEmpty() && cellX == lastCellX_ && cellY == lastCellY_;
      if (here && !lastIsLoose_) {
        points_.append({xs[i], ys[i]});
        lastIsLoose_ = true;
      } else if (here) {
        points_.last() = {xs[i], ys[i]};
      } else {
        points_.append({xs[i], ys[i]});
        lastIsLoose_ = false;
        lastCellX_ = cellX;
        lastCellY_ = cellY;
      }
    }
    rows_ += count;
  }
  return rows_ - before;
}

}  // namespace rotorbench
