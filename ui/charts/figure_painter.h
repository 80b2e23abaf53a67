// A chart as a figure on paper: title, plot and legend on white, for any paint device. No text is
// cut: titles and names go on in further lines, and where the legend takes many rows the figure
// becomes taller, not the plot smaller.
#pragma once

#include <QPainter>
#include <QSizeF>
#include <QStringList>

#include "ui/charts/chart_frame.h"
#include "ui/charts/figure_legend.h"
#include "ui/charts/plot_painter.h"

namespace rotorbench {

class ChartPane;

class ChartFigure {
 public:
  explicit ChartFigure(const ChartPane& pane);
  /// In units of which a figure is always equally many wide; both whole numbers.
  [[nodiscard]] QSizeF size() const { return size_; }
  /// Inside the axes.
  [[nodiscard]] QRectF plot() const { return layout_.plot; }
  void paint(QPainter& painter) const;

 private:
  void layOut(const ChartPane& pane);

  QSizeF size_;
  QStringList title_;
  ChartFrame frame_;
  PlotLayout layout_;
  FigureLegend legend_;
};

}  // namespace rotorbench
