// The curves inside the axes of a chart, drawn by Qt Charts. Its types stay inside curve_layer.cpp.
// Series hold points in pixels of the plot: the decimator makes points per pixel column anyway, so
// a pan, a zoom or new data cost one replace() per curve and never a new layout of axes; series on
// a GPU are not used because they are missing from exported figures.
#pragma once

#include <QPainter>
#include <QRectF>
#include <memory>

#include "ui/charts/chart_frame.h"
#include "ui/charts/chart_theme.h"

namespace rotorbench {

class CurveLayer {
 public:
  CurveLayer();
  ~CurveLayer();
  CurveLayer(const CurveLayer&) = delete;
  CurveLayer& operator=(const CurveLayer&) = delete;

  /// Takes over the points of `frame` for a plot of `size` pixels. `lineWidth` in pixels is for
  /// curves that are not dense.
  void setFrame(const ChartFrame& frame, QSizeF size, const ChartTheme& theme, qreal lineWidth);
  /// Paints the curves into `plot`, clipped to it.
  void paint(QPainter& painter, const QRectF& plot);

  /// Points drawn, for measurements.
  [[nodiscard]] qsizetype pointCount() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rotorbench
