// From the rows of a recording to the few points a chart draws: per pixel column the smallest and the largest
// value, in the order in which they occur. Every extreme of the rows in view is kept exactly.
#pragma once

#include <QList>
#include <QPointF>
#include <vector>

#include "sim/core/recording.h"
#include "ui/charts/axis_scale.h"
#include "ui/charts/column_summary.h"

namespace rotorbench {

/// Bounds of the rows in each pixel column over a growing abscissa: column i holds rows [bounds[i],
/// bounds[i+1]). Rows before or after the visible range are in no column.
std::vector<std::size_t> columnBounds(const Recording& recording, std::size_t rows, const AxisScale& x,
                                      int columns);

/// Points (abscissa, value) of the rows in the columns, at most two per column, and the neighbours just outside
/// so that lines run to the edge. Rows that `summary` has not taken in yet are left out.
QList<QPointF> decimate(const Recording& recording, const ColumnSummary& summary,
                        const std::vector<std::size_t>& bounds);

/// A curve of one channel over another, reduced to the points that lie in another pixel than the point before.
/// Remembers what it has seen: while the scales stay, only new rows are read.
class XyTrace {
 public:
  /// Takes in further rows, at most `mostRows`; returns how many it took. `widthPx` and `heightPx` are the plot's.
  std::size_t update(const Recording& recording, std::size_t xChannel, std::size_t yChannel,
                     const AxisScale& x, const AxisScale& y, double widthPx, double heightPx,
                     std::size_t mostRows);
  /// True if `update` has taken in all rows published by now.
  [[nodiscard]] bool complete(const Recording& recording) const { return rows_ == recording.rows(); }
  [[nodiscard]] const QList<QPointF>& points() const { return points_; }

 private:
  void restartIfChanged(const AxisScale& x, const AxisScale& y, double widthPx, double heightPx);

  QList<QPointF> points_;
  std::size_t rows_ = 0;
  AxisScale x_, y_;
  double width_ = 0, height_ = 0;
  double lastCellX_ = 0, lastCellY_ = 0;
  bool lastIsLoose_ = false;  ///< the last point is only there because it is the newest
};

}  // namespace rotorbench
