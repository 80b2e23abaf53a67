#include "ui/charts/chart_legend.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <algorithm>

namespace rotorbench {
namespace {

constexpr int kSample = 26;
constexpr int kPadding = 4;
constexpr int kBetween = 6;
constexpr double kCellShare = 0.76;  // of a narrow legend; the rest is for the names

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
  setToolTip(entry.tip);
  update();
}

void LegendItem::setCells(const QStringList& cells, int width) {
  cells_ = cells;
  cellWidth_ = width;
  setAccessibleDescription(cells.join(QStringLiteral("; ")));
  update();
}

QSize LegendItem::sizeHint() const {
  const QFontMetrics metrics(font());
  return {kSample + 2 * kPadding + metrics.horizontalAdvance(text()), metrics.height() + 2};
}

void LegendItem::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ChartTheme theme = ChartTheme::of(palette());
  const int middle = height() / 2;
  if (underMouse() || hasFocus()) painter.fillRect(rect(), theme.grid);
  if (!entry_.hidden) {
    painter.setPen(curvePen(entry_.style, theme, 2));
    painter.drawLine(kPadding, middle, kSample - kPadding, middle);
    if (!entry_.style.line) {
      constexpr int kMark = 3;  // radius, as in the plot
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setBrush(theme.readable(entry_.style.color));
      painter.drawEllipse(QPoint(kSample / 2, middle), kMark, kMark);
      painter.setRenderHint(QPainter::Antialiasing, false);
    }
  }
  QFont face = font();
  face.setStrikeOut(entry_.hidden);
  painter.setFont(face);
  painter.setPen(entry_.hidden ? theme.dimText : theme.text);
  const int cells = static_cast<int>(cells_.size()) * cellWidth_;
  const QRect label(kSample, 0, width() - kSample - kPadding - cells, height());
  const QFontMetrics metrics(face);
  // The last part of a channel's name tells the curves of one chart apart.
  painter.drawText(label, Qt::AlignVCenter | Qt::AlignLeft,
                   metrics.elidedText(text(), Qt::ElideLeft, label.width()));
  painter.setFont(font());
  for (int i = 0; i < cells_.size(); ++i) {
    const QRect cell(width() - cells + i * cellWidth_, 0, cellWidth_ - kPadding, height());
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

ChartLegend::ChartLegend(QWidget* parent) : QScrollArea(parent), body_(new QWidget) {
  setObjectName(QStringLiteral("legend"));
  setAccessibleName(tr("Legend"));
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  setBackgroundRole(QPalette::Base);
  body_->setBackgroundRole(QPalette::Base);
  body_->setAutoFillBackground(true);
  body_->installEventFilter(this);
  setWidget(body_);
  setFixedHeight(0);
}

void ChartLegend::setEntries(const std::vector<LegendEntry>& entries) {
  while (items_.size() > entries.size()) {
    delete items_.back();
    items_.pop_back();
  }
  while (items_.size() < entries.size()) {
    auto* item = new LegendItem(body_);
    const std::size_t index = items_.size();
    connect(item, &QAbstractButton::clicked, this, [this, index] { emit toggled(index); });
    connect(item, &LegendItem::menuAsked, this, [this, item](QPoint at) { askMenu(item, at); });
    connect(item, &LegendItem::removeAsked, this, [this, item] {
      const QString channel = item->entry().channel;
      emit removeAsked(channel);
    });
    item->show();
    items_.push_back(item);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (items_[i]->entry() != entries[i]) items_[i]->setEntry(entries[i]);
  }
  arrange();
}

void ChartLegend::setReadouts(const QStringList& heads, const std::vector<QStringList>& cells) {
  const bool changed = heads.size() != heads_.size();
  heads_ = heads;
  if (changed) widestCell_ = 0;
  const QFontMetrics metrics(font());
  const auto measure = [&](const QStringList& texts) {
    for (const QString& text : texts)
      widestCell_ = std::max(widestCell_, metrics.horizontalAdvance(text) + 3 * kPadding);
  };
  measure(heads);
  for (const auto& row : cells) measure(row);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    items_[i]->setCells(i < cells.size() && !heads.isEmpty() ? cells[i] : QStringList(),
                        cellWidth());
  }
  if (changed) arrange();
  body_->update();
}

int ChartLegend::cellWidth() const {
  const auto columns = std::max<qsizetype>(1, heads_.size());
  return std::min(widestCell_, static_cast<int>(kCellShare * viewport()->width() /
                                                static_cast<double>(columns)));
}

void ChartLegend::setMostHeight(int height) {
  if (height == mostHeight_) return;
  mostHeight_ = height;
  arrange();
}

void ChartLegend::setColumnWidth(int width) {
  if (width == columnWidth_) return;
  columnWidth_ = width;
  arrange();
}

void ChartLegend::askMenu(LegendItem* item, QPoint globalPosition) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("legendMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(item->entry().hidden ? tr("Show this curve") : tr("Hide this curve"), item,
                  &LegendItem::click);
  menu->addAction(tr("Remove %1 from this chart").arg(item->entry().channel), item,
                  &LegendItem::removeAsked);
  menu->popup(globalPosition);
}

/// Entries flow in rows; as a table or column each has a row of its own, below the heads if there are any.
void ChartLegend::arrange() {
  const bool column = columnWidth_ > 0;
  if (column) {
    setFixedWidth(columnWidth_);
  } else {
    setMinimumWidth(0);
    setMaximumWidth(QWIDGETSIZE_MAX);
  }
  const int width = viewport()->width();
  const int rowHeight = QFontMetrics(font()).height() + 2;
  const bool table = !heads_.isEmpty();
  int x = kBetween;
  int y = table ? rowHeight : 0;
  for (auto* item : items_) {
    const bool ownRow = table || column;
    const int wanted =
        ownRow ? width - 2 * kBetween : std::min(item->sizeHint().width(), width - 2 * kBetween);
    if (x > kBetween && (ownRow || x + wanted > width)) {
      x = kBetween;
      y += rowHeight;
    }
    item->setGeometry(x, y, wanted, rowHeight);
    item->setCells(item->cells(), cellWidth());
    x += wanted + kBetween;
  }
  const int content = items_.empty() && !table ? 0 : y + rowHeight + 2;
  body_->resize(width, content);
  if (column) {
    setMinimumHeight(0);
    setMaximumHeight(QWIDGETSIZE_MAX);
  } else {
    setFixedHeight(std::min(content, std::max(mostHeight_, rowHeight + 2)));
  }
}

void ChartLegend::paintHeads() {
  QPainter painter(body_);
  const ChartTheme theme = ChartTheme::of(palette());
  const QFontMetrics metrics(font());
  painter.setPen(theme.dimText);
  const int cell = cellWidth();
  int x = body_->width() - kBetween - static_cast<int>(heads_.size()) * cell;
  for (const QString& head : heads_) {
    painter.drawText(QRect(x, 0, cell - kPadding, metrics.height() + 2),
                     Qt::AlignRight | Qt::AlignVCenter, head);
    x += cell;
  }
}

bool ChartLegend::eventFilter(QObject* watched, QEvent* event) {
  const bool seen = QScrollArea::eventFilter(watched, event);
  if (watched == body_ && event->type() == QEvent::Paint && !heads_.isEmpty()) paintHeads();
  return seen;
}

void ChartLegend::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  arrange();
}

}  // namespace rotorbench
