// Marks on the time axis of a chart: an instant at which something happened to a run, as a thin
// dotted line with a flag at the top; the pointer on it says what. Lengths in pixels of the
// painter.
#pragma once

#include <QColor>
#include <QPainter>
#include <QString>
#include <vector>

#include "ui/charts/chart_frame.h"
#include "ui/charts/plot_painter.h"

namespace rotorbench {

struct PlotMark {
  double time = 0;  ///< s
  QString text;
  QColor color;  ///< that of its run
};

void paintMarks(QPainter& painter, const std::vector<PlotMark>& marks, const ChartFrame& frame,
                const PlotLayout& layout);

/// What the marks near a pixel say, a line each and no more than a person can read at once; empty
/// if there is none.
QString marksAt(QPointF pixel, const std::vector<PlotMark>& marks, const ChartFrame& frame,
                const PlotLayout& layout);

}  // namespace rotorbench
