// From the rows of a recording to the few points a chart draws: per pixel column the smallest and
// the largest value, in the order in which they occur. Every extreme of the rows in view is kept
// exactly.
#pragma once

#include <QList>
#include <QPointF>
#include <vector>

#include "sim/core/recording.h"
#include "ui/charts/axis_scale.h"
#include "ui/charts/column_summary.h"

namespace rotorbench {

/// Bounds of the rows in each pixel column over a growing abscissa: column i holds rows [bounds[i],
/// bounds[i+1]). Rows before or after the visible range are in no column. While the scale stays,
/// only columns that new rows may fall into are looked up again.
class ColumnBounds {
 public:
  const std::vector<std::size_t>& update(const Recording& recording, std::size_t rows,
                                         const AxisScale& x, int columns);

 private:
  AxisScale x_;
  std::size_t rows_ = 0;
  std::vector<std::size_t> bounds_;
};

/// A curve over the abscissa, reduced to the smallest and the largest value of each pixel column.
class TimeTrace {
 public:
  /// Points (abscissa, value) of the rows in the columns, at most two per column, and the
  /// neighbours just outside so that lines run to the edge. Rows that `summary` has not taken in
  /// yet are left out. Columns that were complete at the last call with the same scale are not read
  /// again.
  QList<QPointF> update(const Recording& recording, const ColumnSummary& summary,
                        const AxisScale& x, const std::vector<std::size_t>& bounds);

 private:
  AxisScale x_;
  std::size_t columns_ = 0;
  std::size_t doneColumns_ = 0;
  QList<QPointF> donePoints_;
};

/// A curve of one channel over another, reduced to the points that lie in another pixel than the
/// point before. Remembers what it has seen: while the scales stay, only new rows are read. A curve
/// that fills more than kMostPoints pixels is reduced by coarser cells.
class XyTrace {
 public:
  static constexpr qsizetype kMostPoints = 12000;

  /// Takes in further rows, at most `mostRows`; returns how many it took. `widthPx` and `heightPx`
  /// are the plot's.
  std::size_t update(const Recording& recording, std::size_t xChannel, std::size_t yChannel,
                     const AxisScale& x, const AxisScale& y, double widthPx, double heightPx,
                     std::size_t mostRows);
  /// True if `update` has taken in all rows published by now.
  [[nodiscard]] bool complete(const Recording& recording) const {
    return rows_ == recording.rows();
  }
  [[nodiscard]] const QList<QPointF>& points() const { return points_; }

 private:
  void restartIfChanged(const AxisScale& x, const AxisScale& y, double widthPx, double heightPx);
  void restart();
  void add(QPointF point, double cellX, double cellY);

  QList<QPointF> points_;
  std::size_t rows_ = 0;
  AxisScale x_, y_;
  double width_ = 0, height_ = 0;
  double cell_ = 1;  ///< px
  double lastCellX_ = 0, lastCellY_ = 0;
  bool lastIsLoose_ = false;  ///< the last point is only there because it is the newest
};

}  // namespace rotorbench
