#include "ui/charts/figure_legend.h"

#include <QFontMetricsF>
#include <algorithm>

#include "ui/charts/wrapped_text.h"

namespace rotorbench {
namespace {

constexpr qreal kSampleWidth = 32;
constexpr qreal kSampleLine = 26;
constexpr qreal kBetween = 18;
constexpr qreal kMark = 3;  // radius

}  // namespace

FigureLegend::FigureLegend(const ChartFrame& frame, const QFont& font, qreal width) : font_(font) {
  const QFontMetricsF metrics(font);
  const qreal line = metrics.height();
  qreal x = 0, y = 0, rowHeight = 0;
  for (const auto& curve : frame.curves) {
    if (curve.hidden) continue;
    Entry entry{curve.style,
                curve.style.markers || curve.points.size() == 1,
                wrappedText(curve.label, font, width - kSampleWidth),
                {}};
    qreal nameWidth = 0;
    for (const QString& part : entry.lines)
      nameWidth = std::max(nameWidth, metrics.horizontalAdvance(part));
    if (x > 0 && x + kSampleWidth + nameWidth > width) {
      x = 0;
      y += rowHeight;
      rowHeight = 0;
    }
    entry.at = {x, y + line / 2};
    x += kSampleWidth + nameWidth + kBetween;
    rowHeight = std::max(rowHeight, line * static_cast<qreal>(entry.lines.size()));
    entries_.push_back(std::move(entry));
  }
  height_ = y + rowHeight;
}

void FigureLegend::paint(QPainter& painter, QPointF at, qreal lineWidth) const {
  const ChartTheme theme = ChartTheme::paper();
  const QFontMetricsF metrics(font_);
  painter.setFont(font_);
  for (const Entry& entry : entries_) {
    const QPointF left = at + entry.at;
    painter.setPen(curvePen(entry.style, theme, lineWidth));
    painter.drawLine(left, left + QPointF(kSampleLine, 0));
    if (entry.mark) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme.readable(entry.style.color));
      painter.drawEllipse(left + QPointF(kSampleLine / 2, 0), kMark, kMark);
    }
    painter.setPen(theme.text);
    QPointF baseline = left + QPointF(kSampleWidth, metrics.capHeight() / 2);
    for (const QString& part : entry.lines) {
      painter.drawText(baseline, part);
      baseline.ry() += metrics.height();
    }
  }
}

}  // namespace rotorbench
