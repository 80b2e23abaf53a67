#include "ui/charts/plot_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/charts/wrapped_text.h"

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

qreal stripWidth(std::size_t axis, const PlotLayout& layout, const LabelWidths& widths,
                 const QFontMetricsF& metrics) {
  const auto lines = std::max<qsizetype>(1, layout.yTitles[axis].size());
  return kTick + kGap + widths[axis] + kGap + static_cast<qreal>(lines) * metrics.height();
}

/// An outer axis keeps its distance from the title of the inner one.
qreal distanceBefore(std::size_t axis) {
  return axis >= 2 ? kOuter : 0;
}

/// What the strips, with the lines of the titles they hold, leave of the area.
QRectF plotRect(const QRectF& area, const PlotLayout& layout, const LabelWidths& widths,
                const QFontMetricsF& metrics) {
  qreal left = kOuter;
  qreal right = kOuter;
  for (std::size_t i = 0; i < widths.size(); ++i)
    (isLeft(i) ? left : right) += stripWidth(i, layout, widths, metrics) + distanceBefore(i);
  if (widths.empty()) left += kTick + metrics.horizontalAdvance(kLeastLabel);
  if (widths.size() < 2) right += metrics.horizontalAdvance(kLeastLabel) / 2;
  const qreal xTitle =
      metrics.height() * static_cast<qreal>(std::max<qsizetype>(1, layout.xTitle.size()));
  const qreal bottom = kTick + kGap + metrics.height() + kGap + xTitle + kGap;
  const qreal top = std::ceil(metrics.height() / 2);
  return {area.left() + std::round(left), area.top() + std::round(top),
          std::max(10.0, std::floor(area.width() - std::round(left) - right)),
          std::max(10.0, std::floor(area.height() - std::round(top) - bottom))};
}

void placeStrips(const QRectF& area, const LabelWidths& widths, const QFontMetricsF& metrics,
                 PlotLayout& layout) {
  const QRectF& plot = layout.plot;
  layout.xStrip =
      QRectF(area.left(), plot.bottom(), area.width(), area.bottom() - kGap - plot.bottom());
  qreal fromLeft = plot.left();
  qreal fromRight = plot.right();
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const qreal width = stripWidth(i, layout, widths, metrics);
    const qreal taken = width + distanceBefore(i);
    const qreal x = isLeft(i) ? (fromLeft -= taken) : (fromRight += taken) - width;
    layout.yStrips.emplace_back(x, plot.top(), width, plot.height());
  }
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
  const qreal height = metrics.height() * static_cast<qreal>(layout.xTitle.size());
  QRectF line(plot.left(), layout.xStrip.bottom() - height, plot.width(), metrics.height());
  for (const QString& part : layout.xTitle) {
    painter.drawText(line, Qt::AlignCenter, part);
    line.translate(0, metrics.height());
  }
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
  // Turned by a quarter, so that lines go on from left to right of the picture.
  const qreal height = metrics.height() * static_cast<qreal>(layout.yTitles[index].size());
  painter.translate(left ? strip.left() : strip.right() - height, plot.center().y());
  painter.rotate(-90);
  QRectF line(-plot.height() / 2, 0, plot.height(), metrics.height());
  for (const QString& part : layout.yTitles[index]) {
    painter.drawText(line, Qt::AlignCenter, part);
    line.translate(0, metrics.height());
  }
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
                      LabelWidths& widths, TitleRoom titles) {
  const QFontMetricsF metrics(font);
  widths.resize(frame.y.size(), 0);
  for (std::size_t i = 0; i < frame.y.size(); ++i)
    widths[i] = std::max(widths[i], labelWidth(frame.y[i], metrics));
  PlotLayout layout;
  layout.xTitle = {QString()};
  layout.yTitles.assign(frame.y.size(), {QString()});
  layout.plot = plotRect(area, layout, widths, metrics);
  if (titles == TitleRoom::OneLine) {
    layout.xTitle = {metrics.elidedText(frame.x.title, Qt::ElideRight, layout.plot.width())};
    for (std::size_t i = 0; i < frame.y.size(); ++i)
      layout.yTitles[i] = {fitted(frame.y[i].title, metrics, layout.plot.height())};
  } else {
    // Lines of one axis shorten the other: the second step sees those of the first.
    for (int step = 0; step < 2; ++step) {
      layout.xTitle = wrappedText(frame.x.title, font, layout.plot.width());
      for (std::size_t i = 0; i < frame.y.size(); ++i)
        layout.yTitles[i] = wrappedText(frame.y[i].title, font, layout.plot.height());
      layout.plot = plotRect(area, layout, widths, metrics);
    }
  }
  placeStrips(area, widths, metrics, layout);
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
