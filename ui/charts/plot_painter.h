// Where the parts of a plot lie and how its axes are painted: thin grid, ticks, labels, titles with
// units. Used by the window and by exported figures alike; lengths in pixels of the painter.
#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QStringList>
#include <vector>

#include "ui/charts/chart_frame.h"
#include "ui/charts/chart_theme.h"

namespace rotorbench {

struct PlotLayout {
  QRectF plot;                  ///< inside the axes
  QRectF xStrip;                ///< labels and title below
  std::vector<QRectF> yStrips;  ///< labels and title of each y axis, left and right in turn
  QStringList xTitle;           ///< in lines
  std::vector<QStringList> yTitles;

  /// Index of the y axis whose strip holds the point, or -1.
  [[nodiscard]] int yAxisAt(QPointF point) const;
};

/// Widths of the y labels so far: an axis may widen but does not shrink while values change, so
/// that nothing moves under the pointer.
using LabelWidths = std::vector<qreal>;

/// What becomes of an axis' title that is longer than the axis: one line with the name cut short
/// (on the screen), or further lines (on paper, where nobody can look closer).
enum class TitleRoom { OneLine, Lines };

PlotLayout layoutPlot(const ChartFrame& frame, const QRectF& area, const QFont& font,
                      LabelWidths& widths, TitleRoom titles = TitleRoom::OneLine);

void paintGround(QPainter& painter, const ChartFrame& frame, const PlotLayout& layout,
                 const ChartTheme& theme);
void paintAxes(QPainter& painter, const ChartFrame& frame, const PlotLayout& layout,
               const ChartTheme& theme, const QFont& font);

}  // namespace rotorbench
