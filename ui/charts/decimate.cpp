#include "ui/charts/decimate.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {
namespace {

/// First row in [from, rows) with abscissa >= t: gallops from a guess, since columns follow one
/// another.
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

void addRow(const Recording& recording, const ColumnSummary& summary, std::size_t row,
            QList<QPointF>& points) {
  const double y = summary.value(row);
  const double x = recording.value(0, row);
  if (std::isfinite(y) && std::isfinite(x)) points.append({x, y});
}

void addColumn(const Recording& recording, const ColumnSummary& summary, std::size_t begin,
               std::size_t end, QList<QPointF>& points) {
  const Extremes extremes = summary.extremes(begin, end);
  if (extremes.empty()) return;
  const auto [first, second] = std::minmax(extremes.rowOfMin, extremes.rowOfMax);
  addRow(recording, summary, first, points);
  if (second != first) addRow(recording, summary, second, points);
}

}  // namespace

const std::vector<std::size_t>& ColumnBounds::update(const Recording& recording, std::size_t rows,
                                                     const AxisScale& x, int columns) {
  const auto size = static_cast<std::size_t>(columns) + 1;
  if (!(x == x_) || bounds_.size() != size || rows < rows_) bounds_.assign(size, rows_ = 0);
  // A bound that pointed behind the last row may lie further on now; all others stay.
  std::size_t i = 0;
  while (i < size && bounds_[i] < rows_) ++i;
  std::size_t row = i == 0 ? 0 : bounds_[i - 1];
  std::size_t guess = i == 0 ? rows / 2 : 64;
  for (; i < size; ++i) {
    // The last column holds its right edge too.
    const double edge = i == 0 ? x.span.low
                        : i + 1 == size
                            ? std::nextafter(x.span.high, std::numeric_limits<double>::infinity())
                            : x.fromUnit(static_cast<double>(i) / columns);
    const std::size_t next = gallop(recording, row, rows, edge, guess);
    guess = i == 0 ? 64 : (next - row) / 2 + 1;
    bounds_[i] = row = next;
  }
  x_ = x;
  rows_ = rows;
  return bounds_;
}

QList<QPointF> TimeTrace::update(const Recording& recording, const ColumnSummary& summary,
                                 const AxisScale& x, const std::vector<std::size_t>& bounds) {
  const std::size_t columns = bounds.size() - 1;
  if (!(x == x_) || columns != columns_) {
    x_ = x;
    columns_ = columns;
    doneColumns_ = 0;
    donePoints_.clear();
  }
  const std::size_t rows = summary.rows();
  const std::size_t begin = std::min(bounds.front(), rows);
  const std::size_t end = std::min(bounds.back(), rows);
  QList<QPointF> points;
  points.reserve(2 * static_cast<qsizetype>(columns) + 4);
  if (begin > 0) addRow(recording, summary, begin - 1, points);
  if (end - begin <= 2 * columns) {
    for (std::size_t row = begin; row < end; ++row) addRow(recording, summary, row, points);
  } else {
    // A column with a row behind it will get no further one.
    for (; doneColumns_ < columns && bounds[doneColumns_ + 1] < rows; ++doneColumns_) {
      addColumn(recording, summary, bounds[doneColumns_], bounds[doneColumns_ + 1], donePoints_);
    }
    points += donePoints_;
    for (std::size_t i = doneColumns_; i < columns; ++i) {
      addColumn(recording, summary, std::min(bounds[i], rows), std::min(bounds[i + 1], rows),
                points);
    }
  }
  if (end < rows) addRow(recording, summary, end, points);
  return points;
}

void XyTrace::restart() {
  rows_ = 0;
  points_.clear();
  lastIsLoose_ = false;
}

void XyTrace::restartIfChanged(const AxisScale& x, const AxisScale& y, double widthPx,
                               double heightPx) {
  if (x == x_ && y == y_ && widthPx == width_ && heightPx == height_) return;
  x_ = x;
  y_ = y;
  width_ = widthPx;
  height_ = heightPx;
  cell_ = 1;
  restart();
}

/// Of the points in one cell the first and the last stay, so that the line enters and leaves where
/// it should.
void XyTrace::add(QPointF point, double cellX, double cellY) {
  const bool here = !points_.isEmpty() && cellX == lastCellX_ && cellY == lastCellY_;
  if (here && lastIsLoose_) {
    points_.last() = point;
    return;
  }
  points_.append(point);
  lastIsLoose_ = here;
  lastCellX_ = cellX;
  lastCellY_ = cellY;
}

std::size_t XyTrace::update(const Recording& recording, std::size_t xChannel, std::size_t yChannel,
                            const AxisScale& x, const AxisScale& y, double widthPx, double heightPx,
                            std::size_t mostRows) {
  restartIfChanged(x, y, widthPx, heightPx);
  const std::size_t before = rows_;
  const std::size_t goal = rows_ + std::min(recording.rows() - rows_, mostRows);
  const double columns = widthPx / cell_;
  const double lines = heightPx / cell_;
  while (rows_ < goal) {
    const auto xs = recording.column(xChannel, rows_);
    const auto ys = recording.column(yChannel, rows_);
    const std::size_t count = std::min({xs.size(), ys.size(), goal - rows_});
    for (std::size_t i = 0; i < count; ++i) {
      const double unitX = x.toUnit(xs[i]);
      const double unitY = y.toUnit(ys[i]);
      if (!std::isfinite(unitX) || !std::isfinite(unitY)) continue;
      // All that lies outside falls into one ring of cells.
      add({xs[i], ys[i]}, std::clamp(std::floor(unitX * columns), -1.0, columns + 1),
          std::clamp(std::floor(unitY * lines), -1.0, lines + 1));
    }
    rows_ += count;
  }
  const std::size_t taken = rows_ - before;
  if (points_.size() > kMostPoints) {
    cell_ *= 2;
    restart();
  }
  return taken;
}

}  // namespace rotorbench
