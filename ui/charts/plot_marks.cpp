#include "ui/charts/plot_marks.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <cmath>
#include <optional>

namespace rotorbench {
namespace {

constexpr qreal kFlag = 5;
constexpr qreal kNear = 4;
constexpr qsizetype kMostLines = 8;

std::optional<qreal> xOf(const PlotMark& mark, const ChartFrame& frame, const PlotLayout& layout) {
  const double unit = frame.x.scale.toUnit(mark.time);
  if (!(unit >= 0 && unit <= 1)) return std::nullopt;
  return layout.plot.left() + unit * layout.plot.width();
}

}  // namespace

void paintMarks(QPainter& painter, const std::vector<PlotMark>& marks, const ChartFrame& frame,
                const PlotLayout& layout) {
  const QRectF& plot = layout.plot;
  std::optional<qreal> lastLine;
  for (const PlotMark& mark : marks) {
    const auto at = xOf(mark, frame, layout);
    if (!at) continue;
    const qreal x = std::floor(*at) + 0.5;
    // Many in one place are one line, not a wall.
    if (lastLine && std::abs(x - *lastLine) < kNear) continue;
    lastLine = x;
    painter.setPen(QPen(mark.color, 1, Qt::DotLine));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark.color);
    const QPointF flag[] = {{x - kFlag, plot.top() + 1},
                            {x + kFlag, plot.top() + 1},
                            {x, plot.top() + 1 + kFlag * 1.5}};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPolygon(flag, 3);
    painter.setRenderHint(QPainter::Antialiasing, false);
  }
  painter.setBrush(Qt::NoBrush);
}

QString marksAt(QPointF pixel, const std::vector<PlotMark>& marks, const ChartFrame& frame,
                const PlotLayout& layout) {
  QStringList lines;
  qsizetype more = 0;
  for (const PlotMark& mark : marks) {
    const auto x = xOf(mark, frame, layout);
    if (!x || std::abs(*x - pixel.x()) > kNear) continue;
    if (lines.size() == kMostLines) {
      ++more;
      continue;
    }
    lines << QCoreApplication::translate("PlotMarks", "%1 s: %2")
                 .arg(QLocale().toString(mark.time, 'f', 3), mark.text);
  }
  if (more > 0) lines << QCoreApplication::translate("PlotMarks", "and %1 more").arg(more);
  return lines.join('\n');
}

}  // namespace rotorbench
