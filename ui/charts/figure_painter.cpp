#include "ui/charts/figure_painter.h"

#include <QFontMetricsF>
#include <algorithm>

#include "ui/charts/chart_pane.h"
#include "ui/charts/curve_layer.h"
#include "ui/charts/plot_painter.h"

namespace rotorbench {
namespace {

constexpr qreal kMargin = 12;
constexpr qreal kSample = 32;
constexpr qreal kBetween = 18;
constexpr qreal kLineWidth = 1.5;
constexpr int kFontPixels = 13;
constexpr double kColumnsPerPixel = 2;

QFont figureFont(bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(kFontPixels);
  font.setBold(bold);
  return font;
}

struct PlacedEntry {
  const FrameCurve* curve;
  QPointF at;  ///< left end of the sample, middle of the row
};

/// Shown curves in rows of the given width, from (0, 0) down; `height` is set to what they take.
std::vector<PlacedEntry> placeLegend(const ChartFrame& frame, qreal width,
                                     const QFontMetricsF& metrics, qreal& height) {
  std::vector<PlacedEntry> placed;
  QPointF at(0, metrics.height() / 2);
  for (const auto& curve : frame.curves) {
    if (curve.hidden) continue;
    const qreal wanted = kSample + kBetween + metrics.horizontalAdvance(curve.label);
    if (at.x() > 0 && at.x() + wanted > width) at = {0, at.y() + metrics.height()};
    placed.push_back({&curve, at});
    at.rx() += wanted;
  }
  height = placed.empty() ? 0 : at.y() + metrics.height() / 2;
  return placed;
}

void paintLegend(QPainter& painter, const std::vector<PlacedEntry>& entries, QPointF origin,
                 const QFont& font) {
  const ChartTheme theme = ChartTheme::paper();
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  for (const auto& entry : entries) {
    const QPointF at = origin + entry.at;
    painter.setPen(curvePen(entry.curve->style, theme, kLineWidth));
    painter.drawLine(at, at + QPointF(kSample - 6, 0));
    if (entry.curve->style.markers || entry.curve->points.size() == 1) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme.readable(entry.curve->style.color));
      painter.drawEllipse(at + QPointF((kSample - 6) / 2, 0), 3, 3);
    }
    painter.setPen(theme.text);
    painter.drawText(at + QPointF(kSample, metrics.capHeight() / 2), entry.curve->label);
  }
}

}  // namespace

void paintFigure(QPainter& painter, const ChartPane& pane, QSizeF size) {
  const ChartTheme theme = ChartTheme::paper();
  const QFont font = figureFont(false);
  const QFontMetricsF metrics(font);
  const QString title = QString::fromStdString(pane.spec().title);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF({0, 0}, size), theme.ground);

  // Labels and ticks hang on the size of the plot and the other way round: two steps settle it.
  QSizeF plotSize = size - QSizeF(100, 110);
  ChartFrame frame;
  PlotLayout layout;
  std::vector<PlacedEntry> legend;
  const qreal top = kMargin + (title.isEmpty() ? 0 : metrics.height() * 1.4);
  QRectF area;
  for (int step = 0; step < 2; ++step) {
    frame = pane.frameFor(plotSize, kColumnsPerPixel, QLocale::c());
    qreal legendHeight = 0;
    legend = placeLegend(frame, size.width() - 2 * kMargin, metrics, legendHeight);
    area = QRectF(kMargin, top, size.width() - 2 * kMargin,
                  size.height() - top - kMargin - legendHeight - 4);
    LabelWidths widths;
    layout = layoutPlot(frame, area, font, widths);
    plotSize = layout.plot.size();
  }
  if (!title.isEmpty()) {
    painter.setFont(figureFont(true));
    painter.setPen(theme.text);
    const QRectF row(layout.plot.left(), kMargin, layout.plot.width(), metrics.height() * 1.4);
    painter.drawText(row, Qt::AlignHCenter | Qt::AlignTop, title);
  }
  paintGround(painter, frame, layout, theme);
  CurveLayer curves;
  curves.setFrame(frame, plotSize, theme, kLineWidth);
  curves.paint(painter, layout.plot);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter, frame, layout, theme, font);
  paintLegend(painter, legend, QPointF(layout.plot.left(), area.bottom() + 4), font);
}

}  // namespace rotorbench
