#include "ui/charts/plot_widget.h"

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

namespace rotorbench {
namespace {

constexpr qreal kLineWidth = 1.4;

}  // namespace

PlotWidget::PlotWidget(ChartLink* link, QWidget* parent) : QWidget(parent), link_(link) {
  setObjectName(QStringLiteral("plot"));
  setAccessibleName(tr("Plot"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(link_, &ChartLink::cursorsChanged, this, qOverload<>(&QWidget::update));
}

void PlotWidget::setContent(Content content) {
  content_ = std::move(content);
  takeContent();
}

void PlotWidget::setRings(std::vector<Ring> rings) {
  content_.rings = std::move(rings);
  update();
}

void PlotWidget::setMarks(std::vector<PlotMark> marks) {
  if (marks.empty() && marks_.empty()) return;
  marks_ = std::move(marks);
  update();
}

bool PlotWidget::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && !marks_.empty()) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = marksAt(help->pos(), marks_, content_.frame, layout_);
    if (text.isEmpty()) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(help->globalPos(), text, this);
    }
    return true;
  }
  return QWidget::event(event);
}

void PlotWidget::takeContent() {
  stale_ = true;
  layout_ = layoutPlot(content_.frame, rect(), font(), labelWidths_);
  layer_.setFrame(content_.frame, layout_.plot.size(), ChartTheme::of(palette()), kLineWidth);
  update();
}

void PlotWidget::setHint(const QString& hint) {
  if (hint == hint_) return;
  hint_ = hint;
  update();
}

QSizeF PlotWidget::plotSize() const {
  return layout_.plot.isEmpty() ? QSizeF(std::max(10, width() - 90), std::max(10, height() - 50))
                                : layout_.plot.size();
}

void PlotWidget::relayout() {
  labelWidths_.clear();
}

void PlotWidget::renderStatic() {
  const qreal ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  if (pixmap_.size() != pixels) pixmap_ = QPixmap(pixels);
  pixmap_.setDevicePixelRatio(ratio);
  const ChartTheme theme = ChartTheme::of(palette());
  QPainter painter(&pixmap_);
  painter.fillRect(rect(), theme.ground);
  paintGround(painter, content_.frame, layout_, theme);
  layer_.paint(painter, layout_.plot);
  paintAxes(painter, content_.frame, layout_, theme, font());
  stale_ = false;
}

void PlotWidget::paintEvent(QPaintEvent*) {
  if (stale_ || pixmap_.devicePixelRatio() != devicePixelRatioF()) renderStatic();
  QPainter painter(this);
  painter.drawPixmap(0, 0, pixmap_);
  if (content_.kind == ChartKind::Time) paintMarks(painter, marks_, content_.frame, layout_);
  paintCursors(painter);
  if (!hint_.isEmpty()) paintHint(painter);
  if (gesture_ == Gesture::Band && moved_) {
    const QColor accent = ChartTheme::of(palette()).accent;
    painter.setPen(accent);
    painter.setBrush(QColor(accent.red(), accent.green(), accent.blue(), 40));
    painter.drawRect(QRectF(press_, last_).normalized() & layout_.plot);
  }
  if (hasFocus()) {
    painter.setPen(ChartTheme::of(palette()).accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(layout_.plot.adjusted(0.5, 0.5, 0.5, 0.5));
  }
}

void PlotWidget::paintHint(QPainter& painter) {
  painter.setPen(ChartTheme::of(palette()).dimText);
  painter.setFont(font());
  painter.drawText(layout_.plot.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                   hint_);
}

void PlotWidget::paintCursors(QPainter& painter) {
  const ChartTheme theme = ChartTheme::of(palette());
  const QRectF& plot = layout_.plot;
  const QFontMetricsF metrics(font());
  painter.setFont(font());
  for (const Cursor which : {Cursor::A, Cursor::B}) {
    const auto time = link_->cursor(which);
    if (!time || content_.kind != ChartKind::Time) continue;
    const double unit = content_.frame.x.scale.toUnit(*time);
    if (!(unit >= 0 && unit <= 1)) continue;
    const qreal x = std::floor(plot.left() + unit * plot.width()) + 0.5;
    painter.setPen(QPen(theme.text, 1, which == Cursor::A ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    const QRectF tag(x - metrics.height() / 2, plot.top() - 2, metrics.height(), metrics.height());
    painter.fillRect(tag, theme.text);
    painter.setPen(theme.ground);
    painter.drawText(tag, Qt::AlignCenter,
                     which == Cursor::A ? QStringLiteral("A") : QStringLiteral("B"));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.text, 1.5));
  for (const Ring& ring : content_.rings) {
    // Rings are taken with the curves, the frame may already be that of other data.
    if (ring.axis >= content_.frame.y.size()) continue;
    const double unitX = content_.frame.x.scale.toUnit(ring.place.x());
    const double unitY = content_.frame.y[ring.axis].scale.toUnit(ring.place.y());
    if (!std::isfinite(unitX) || !std::isfinite(unitY)) continue;  // not measured there
    const QPointF pixel(plot.left() + unitX * plot.width(), plot.bottom() - unitY * plot.height());
    if (plot.contains(pixel)) painter.drawEllipse(pixel, 5, 5);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PlotWidget::resizeEvent(QResizeEvent*) {
  labelWidths_.clear();
  takeContent();
}

void PlotWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    labelWidths_.clear();
    takeContent();
  }
}

}  // namespace rotorbench
