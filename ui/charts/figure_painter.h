// A chart as a figure on paper: title, plot and legend on white, for any paint device.
#pragma once

#include <QPainter>
#include <QSizeF>

namespace rotorbench {

class ChartPane;

void paintFigure(QPainter& painter, const ChartPane& pane, QSizeF size);

}  // namespace rotorbench
