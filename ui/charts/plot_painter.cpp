#include "ui/charts/plot_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace rotorbench {
namespace {

/// The title of an axis in the room there is; the unit is the last to go.
QString fitted(const QString& title, const QFontMetricsF& metrics, qreal room) {
  if (metrics.horizontalAdvance(title) <= room) return title;
  const auto unit = title.lastIndexOf('[');
  if (unit <= 0) return metrics.elidedText(title, Qt::ElideRight, room);
  const QString tail = ' ' + title.mid(unit);
  const qreal left = room - metrics.horizontalAdvance(tail);
  const QString name = metrics.elidedText(title.left(unit).trimmed(), Qt::ElideRight, left);
  return name.size() > 2 ? name + tail : tail.trimmed();
}

constexpr qreal kTick = 4;
constexpr qreal kGap = 3;
constexpr qreal kOuter = 4;
const QString kLeastLabel = QStringLiteral("0.00");

/// Sharp one-pixel lines lie in the middle of a pixel.
qreal sharp(qreal v) {
  return std::floor(v) + 0.5;
}

bool isLeft(std::size_t axis) {
  return axis % 2 == 0;
}

qreal labelWidth(const FrameAxis& axis, const QFontMetricsF& metrics) {
  qreal width = metrics.horizontalAdvance(kLeastLabel);
  for (const auto& tick : axis.ticks.major)
    width = std::max(width, metrics.horizontalAdvance(tick.label));
  return std::ceil(width);
}

void paintXAxis(QPainter& painter, const ChartFrame& frame, const PlotLayout& layout,
                const ChartTheme& theme, const QFontMetricsF& metrics) {
  const QRectF& plot = layout.plot;
  qreal freeFrom = layout.xStrip.left();
  for (const auto& tick : frame.x.ticks.major) {
    const qreal x = plot.left() + frame.x.scale.toUnit(tick.value) * plot.width();
    painter.setPen(theme.frame);
    painter.drawLine(QPointF(sharp(x), plot.bottom()), QPointF(sharp(x), plot.bottom() + kTick));
    const qreal width = metrics.horizontalAdvance(tick.label);
    if (x - width / 2 < freeFrom || x + width / 2 > layout.xStrip.right()) continue;
    painter.setPen(theme.text);
    painter.drawText(QPointF(x - width / 2, plot.bottom() + kTick + kGap + metrics.ascent()),
                     tick.label);
    freeFrom = x + width / 2 + metrics.averageCharWidth();
  }
  painter.setPen(theme.text);
  const QRectF title(layout.xStrip.left(), layout.xStrip.bottom() - metrics.height(),
                     layout.xStrip.width(), metrics.height());
  const QRectF centred(plot.left(), title.top(), plot.width(), title.height());
  painter.drawText(centred, Qt::AlignCenter,
                   metrics.elidedText(frame.x.title, Qt::ElideRight, plot.width()));
}

void paintYAxis(QPainter& painter, const FrameAxis& axis, std::size_t index,
                const PlotLayout& layout, const ChartTheme& theme, const QFontMetricsF& metrics) {
  const QRectF& plot = layout.plot;
  const QRectF& strip = layout.yStrips[index];
  const bool left = isLeft(index);
  const qreal edge = left ? strip.right() : strip.left();
  const qreal out = left ? -1 : 1;
  painter.setPen(theme.frame);
  if (index >= 2)
    painter.drawLine(QPointF(sharp(edge), plot.top()), QPointF(sharp(edge), plot.bottom()));
  for (const auto& tick : axis.ticks.major) {
    const qreal y = plot.bottom() - axis.scale.toUnit(tick.value) * plot.height();
    painter.setPen(theme.frame);
    painter.drawLine(QPointF(edge, sharp(y)), QPointF(edge + out * kTick, sharp(y)));
    painter.setPen(theme.text);
    const qreal width = metrics.horizontalAdvance(tick.label);
    const qreal x = left ? edge - kTick - kGap - width : edge + kTick + kGap;
    const qreal baseline =
        std::clamp(y + metrics.capHeight() / 2, plot.top() + metrics.capHeight() - kOuter,
                   plot.bottom() + kOuter);
    painter.drawText(QPointF(x, baseline), tick.label);
  }
  painter.save();
  painter.translate(
      left ? strip.left() + metrics.height() / 2 : strip.right() - metrics.height() / 2,
      plot.center().y());
  painter.rotate(-90);
  const QRectF title(-plot.height() / 2, -metrics.height() / 2, plot.height(), metrics.height());
  painter.drawText(title, Qt::AlignCenter, fitted(axis.title, metrics, plot.height()));
  painter.restore();
}

}  // namespace

int PlotLayout::yAxisAt(QPointF point) const {
  for (std::size_t i = 0; i < yStrips.size(); ++i) {
    if (yStrips[i].contains(point)) return static_cast<int>(i);
  }
  return -1;
}

PlotLayout layoutPlot(const ChartFrame& frame, const QRectF& area, const QFont& font,
                      LabelWidths& widths) {
  const QFontMetricsF metrics(font);
  widths.resize(frame.y.size(), 0);
  qreal left = kOuter;
  qreal right = kOuter;
  std::vector<qreal> stripWidths;
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    widths[i] = std::max(widths[i], labelWidth(frame.y[i], metrics));
    const qreal apart = i >= 2 ? kOuter : 0;
    stripWidths.push_back(kTick + kGap + widths[i] + kGap + metrics.height() + apart);
    (isLeft(i) ? left : right) += stripWidths.back();
  }
  if (frame.y.empty()) left += kTick + metrics.horizontalAdvance(kLeastLabel);
  if (frame.y.size() < 2) right += metrics.horizontalAdvance(kLeastLabel) / 2;
  const qreal bottom = kTick + kGap + metrics.height() + kGap + metrics.height() + kGap;
  const qreal top = std::ceil(metrics.height() / 2);
  PlotLayout layout;
  layout.plot = QRectF(area.left() + std::round(left), area.top() + std::round(top),
                       std::max(10.0, std::floor(area.width() - std::round(left) - right)),
                       std::max(10.0, std::floor(area.height() - std::round(top) - bottom)));
  layout.xStrip = QRectF(area.left(), layout.plot.bottom(), area.width(),
                         area.bottom() - kGap - layout.plot.bottom());
  qreal fromLeft = layout.plot.left();
  qreal fromRight = layout.plot.right();
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    // An outer axis keeps its distance from the title of the inner one.
    const qreal apart = i >= 2 ? kOuter : 0;
    const qreal width = stripWidths[i] - apart;
    const qreal x = isLeft(i) ? (fromLeft -= width + apart) : (fromRight += width + apart) - width;
    layout.yStrips.emplace_back(x, layout.plot.top(), width, layout.plot.height());
  }
  return layout;
}

void paintGround(QPainter& painter, const ChartFrame& frame, const PlotLayout& layout,
                 const ChartTheme& theme) {
  const QRectF& plot = layout.plot;
  QColor faint = theme.grid;
  faint.setAlphaF(0.5F);
  const auto vertical = [&](double value) {
    const qreal x = sharp(plot.left() + frame.x.scale.toUnit(value) * plot.width());
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  };
  painter.setPen(faint);
  for (const double value : frame.x.ticks.minor) vertical(value);
  painter.setPen(theme.grid);
  for (const auto& tick : frame.x.ticks.major) vertical(tick.value);
  if (frame.y.empty()) return;
  const auto& y = frame.y.front();
  const auto horizontal = [&](double value) {
    const qreal at = sharp(plot.bottom() - y.scale.toUnit(value) * plot.height());
    painter.drawLine(QPointF(plot.left(), at), QPointF(plot.right(), at));
  };
  painter.setPen(faint);
  for (const double value : y.ticks.minor) horizontal(value);
  painter.setPen(theme.grid);
  for (const auto& tick : y.ticks.major) horizontal(tick.value);
}

void paintAxes(QPainter& painter, const ChartFrame& frame, const PlotLayout& layout,
               const ChartTheme& theme, const QFont& font) {
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  const QRectF& plot = layout.plot;
  painter.setPen(theme.frame);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(QPointF(sharp(plot.left()), sharp(plot.top())),
                          QPointF(sharp(plot.right()), sharp(plot.bottom()))));
  paintXAxis(painter, frame, layout, theme, metrics);
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    paintYAxis(painter, frame.y[i], i, layout, theme, metrics);
  }
}

}  // namespace rotorbench
