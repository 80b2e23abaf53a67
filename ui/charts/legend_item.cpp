#include "ui/charts/legend_item.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/charts/wrapped_text.h"

namespace rotorbench {
namespace {

constexpr int kSample = 26;
constexpr int kPadding = 4;

}  // namespace

LegendItem::LegendItem(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::TabFocus);
  setCheckable(true);
  setCursor(Qt::PointingHandCursor);
}

void LegendItem::setEntry(const LegendEntry& entry) {
  entry_ = entry;
  setChecked(!entry.hidden);
  setText(entry.label);
  setObjectName(QStringLiteral("legend:") + entry.label);
  setAccessibleName(entry.hidden ? tr("%1, hidden").arg(entry.label) : entry.label);
  updateTip();
  update();
}

void LegendItem::setCells(const QStringList& heads, const QStringList& cells) {
  if (heads == heads_ && cells == cells_) return;
  heads_ = heads;
  cells_ = cells;
  setAccessibleDescription(cells.join(QStringLiteral("; ")));
  updateTip();
  update();
}

void LegendItem::setPlace(const LegendPlace& place) {
  if (place == place_) return;
  place_ = place;
  update();
}

/// The whole name and all read-outs, whatever there is room for.
void LegendItem::updateTip() {
  QStringList lines{entry_.label};
  if (!entry_.tip.isEmpty()) lines << entry_.tip;
  for (qsizetype i = 0; i < cells_.size(); ++i)
    lines << heads_.value(i) + QStringLiteral(":  ") + cells_[i];
  setToolTip(lines.join(u'\n'));
}

int LegendItem::lineHeight() const {
  return QFontMetrics(font()).height() + 2;
}

QSize LegendItem::sizeHint() const {
  return {widthOf(text()), lineHeight()};
}

int LegendItem::widthOf(const QString& name) const {
  return kSample + 2 * kPadding +
         static_cast<int>(std::ceil(QFontMetricsF(font()).horizontalAdvance(name))) + 1;
}

int LegendItem::heightOf(const LegendPlace& place) const {
  const auto lines = std::max<qsizetype>(1, place.lines.size()) + (place.cellsBelow ? 1 : 0);
  return static_cast<int>(lines) * lineHeight();
}

QStringList LegendItem::wrapped(const QString& name, int width) const {
  return wrappedText(name, font(), width - kSample - 2 * kPadding);
}

void LegendItem::paintSample(QPainter& painter, const ChartTheme& theme) const {
  if (entry_.hidden) return;
  const int middle = lineHeight() / 2;
  painter.setPen(curvePen(entry_.style, theme, 2));
  painter.drawLine(kPadding, middle, kSample - kPadding, middle);
  if (entry_.style.line) return;
  constexpr int kMarkRadius = 3;  // as in the plot
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(theme.readable(entry_.style.color));
  painter.drawEllipse(QPoint(kSample / 2, middle), kMarkRadius, kMarkRadius);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void LegendItem::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ChartTheme theme = ChartTheme::of(palette());
  if (underMouse() || hasFocus()) painter.fillRect(rect(), theme.grid);
  paintSample(painter, theme);
  QFont face = font();
  face.setStrikeOut(entry_.hidden);
  painter.setFont(face);
  painter.setPen(entry_.hidden ? theme.dimText : theme.text);
  const int step = lineHeight();
  QRect line(kSample, 0, width() - kSample, step);
  for (const QString& part : place_.lines) {
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, part);
    line.translate(0, step);
  }
  painter.setFont(font());
  const QFontMetrics metrics(font());
  const int cells = std::min(place_.cells, static_cast<int>(cells_.size()));
  const int top = place_.cellsBelow ? height() - step : 0;
  for (int i = 0; i < cells; ++i) {
    const QRect cell(width() - (cells - i) * place_.cellWidth, top, place_.cellWidth - kPadding,
                     step);
    painter.drawText(cell, Qt::AlignVCenter | Qt::AlignRight,
                     metrics.elidedText(cells_[i], Qt::ElideRight, cell.width()));
  }
}

void LegendItem::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete) return emit removeAsked();
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

void LegendItem::contextMenuEvent(QContextMenuEvent* event) {
  emit menuAsked(event->globalPos());
  event->accept();
}

}  // namespace rotorbench
