#include "ui/charts/figure_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart_pane.h"
#include "ui/charts/curve_layer.h"
#include "ui/charts/wrapped_text.h"

namespace rotorbench {
namespace {

constexpr QSizeF kUsualSize{840, 520};
constexpr qreal kLeastPlotHeight = 300;
constexpr qreal kLeastArea = kLeastPlotHeight + 60;  // with labels and title of the horizontal axis
constexpr qreal kMargin = 12;
constexpr qreal kLegendGap = 4;
constexpr qreal kTitleLine = 1.4;  // of the height of the font
constexpr qreal kLineWidth = 1.5;
constexpr int kFontPixels = 13;
constexpr double kColumnsPerPixel = 2;

/// Without hinting a text is equally wide on the screen, at any scale, and on the page.
QFont figureFont(bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setStyleHint(QFont::SansSerif);
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setPixelSize(kFontPixels);
  font.setBold(bold);
  return font;
}

qreal titleLine() {
  return kTitleLine * QFontMetricsF(figureFont(true)).height();
}

}  // namespace

// Labels, ticks and lines of text hang on the size of the plot, and it on them: three steps do.
ChartFigure::ChartFigure(const ChartPane& pane)
    : size_(kUsualSize), legend_(ChartFrame{}, figureFont(false), kUsualSize.width()) {
  QSizeF plotSize = kUsualSize - QSizeF(100, 110);
  for (int step = 0; step < 3; ++step) {
    frame_ = pane.frameFor(plotSize, kColumnsPerPixel, QLocale::c());
    layOut(pane);
    layOut(pane);  // now that the width of the plot is known
    if (const qreal missing = kLeastPlotHeight - layout_.plot.height(); missing > 0) {
      size_.rheight() = std::ceil(size_.height() + missing);
      layOut(pane);
    }
    if (plotSize == layout_.plot.size()) break;
    plotSize = layout_.plot.size();
  }
}

void ChartFigure::layOut(const ChartPane& pane) {
  const QFont font = figureFont(false);
  const bool known = !layout_.plot.isEmpty();  // from the step before
  const qreal left = known ? layout_.plot.left() : kMargin;
  const qreal width = known ? layout_.plot.width() : kUsualSize.width() - 2 * kMargin;
  const QString title = QString::fromStdString(pane.spec().title);
  title_ = title.isEmpty() ? QStringList() : wrappedText(title, figureFont(true), width);
  legend_ = FigureLegend(frame_, font, size_.width() - kMargin - left);
  const qreal top = kMargin + static_cast<qreal>(title_.size()) * titleLine();
  const qreal bottom = kMargin + (legend_.height() > 0 ? kLegendGap + legend_.height() : 0);
  // The plot keeps its height, whatever stands above and below it.
  size_.rheight() = std::ceil(std::max(size_.height(), top + bottom + kLeastArea));
  const QRectF area(kMargin, top, size_.width() - 2 * kMargin, size_.height() - top - bottom);
  LabelWidths widths;
  layout_ = layoutPlot(frame_, area, font, widths, TitleRoom::Lines);
}

void ChartFigure::paint(QPainter& painter) const {
  const ChartTheme theme = ChartTheme::paper();
  const QFont font = figureFont(false);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF({0, 0}, size_), theme.ground);
  painter.setFont(figureFont(true));
  painter.setPen(theme.text);
  QRectF row(layout_.plot.left(), kMargin, layout_.plot.width(), titleLine());
  for (const QString& line : title_) {
    painter.drawText(row, Qt::AlignHCenter | Qt::AlignTop, line);
    row.translate(0, titleLine());
  }
  paintGround(painter, frame_, layout_, theme);
  CurveLayer curves;
  curves.setFrame(frame_, layout_.plot.size(), theme, kLineWidth);
  curves.paint(painter, layout_.plot);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter, frame_, layout_, theme, font);
  legend_.paint(painter, {layout_.plot.left(), size_.height() - kMargin - legend_.height()},
                kLineWidth);
}

}  // namespace rotorbench
