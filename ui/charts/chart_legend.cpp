#include "ui/charts/chart_legend.h"

#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QStyle>
#include <algorithm>

namespace rotorbench {
namespace {

constexpr int kPadding = 4;
constexpr int kBetween = 6;

}  // namespace

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
  const bool otherColumns = heads.size() != heads_.size();
  heads_ = heads;
  if (otherColumns) widestCell_ = 0;
  const int widest = widestCell_;
  const QFontMetrics metrics(font());
  const auto measure = [&](const QStringList& texts) {
    for (const QString& text : texts)
      widestCell_ = std::max(widestCell_, metrics.horizontalAdvance(text) + 3 * kPadding);
  };
  measure(heads);
  for (const auto& row : cells) measure(row);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const bool any = i < cells.size() && !heads.isEmpty();
    items_[i]->setCells(any ? heads : QStringList(), any ? cells[i] : QStringList());
  }
  if (otherColumns || widestCell_ != widest) arrange();
  body_->update();
}

void ChartLegend::setMostHeight(int height) {
  if (height == mostHeight_) return;
  mostHeight_ = height;
  arrange();
}

void ChartLegend::setMostWidth(int width) {
  if (width == mostWidth_) return;
  mostWidth_ = width;
  arrange();
}

/// The first of the arrangements of choosePlaces() that the most width has room for. Full names are
/// worth two thirds of it.
int ChartLegend::columnWidth(int rowHeight) const {
  const auto widest = [&](QString LegendEntry::*name) {
    int width = 0;
    for (const LegendItem* item : items_)
      width = std::max(width, item->widthOf(item->entry().*name));
    return width;
  };
  const int label = widest(&LegendEntry::label), shortLabel = widest(&LegendEntry::shortLabel);
  const int cells = static_cast<int>(heads_.size()) * widestCell_;
  const auto withBar = [&](int names, int linesEach) {
    const int lines = linesEach * static_cast<int>(items_.size()) + (heads_.isEmpty() ? 0 : 1);
    const bool scrolls = lines * rowHeight + 2 > height();
    return names + 2 * kBetween +
           (scrolls ? style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this) : 0);
  };
  const int full = 2 * mostWidth_ / 3;
  if (const int w = withBar(label + cells, 1); w <= (cells > 0 ? mostWidth_ : full)) return w;
  if (const int w = withBar(shortLabel + cells, 1); w <= mostWidth_) return w;
  if (cells == 0) return mostWidth_;
  if (const int w = withBar(std::max(label, widestCell_), 2); w <= full) return w;
  return std::min(mostWidth_, withBar(std::max(shortLabel, widestCell_), 2));
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

/// In this order: the full names with the read-outs beside them; shorter names; the read-outs on a
/// line of their own, as many columns of them as there is room for; shorter names there too, on as
/// many lines as they take.
void ChartLegend::choosePlaces(int room) {
  const auto fit = [&](QString LegendEntry::*name, int width) {
    return std::ranges::all_of(items_, [&](const LegendItem* item) {
      return item->widthOf(item->entry().*name) <= width;
    });
  };
  const int columns = static_cast<int>(heads_.size());
  const int beside = room - columns * widestCell_;
  cells_ = {{}, columns, widestCell_, false};
  shortNames_ = !fit(&LegendEntry::label, beside);
  if (!shortNames_ || fit(&LegendEntry::shortLabel, beside) || columns == 0) return;
  cells_.cellsBelow = true;
  cells_.cellWidth = std::min(widestCell_, room);
  cells_.cells = std::clamp(room / std::max(1, cells_.cellWidth), 1, columns);
  shortNames_ = !fit(&LegendEntry::label, room);
}

LegendPlace ChartLegend::placeOf(const LegendItem& item, int room) const {
  LegendPlace place = cells_;
  const QString& name = shortNames_ ? item.entry().shortLabel : item.entry().label;
  const int taken = place.cellsBelow ? 0 : place.cells * place.cellWidth;
  place.lines = item.wrapped(name, room - taken);
  return place;
}

/// Entries flow in rows; as a table or column each has a row of its own, below the heads if there
/// are any.
void ChartLegend::arrange() {
  const bool column = mostWidth_ > 0;
  const int rowHeight = QFontMetrics(font()).height() + 2;
  if (column) {
    setFixedWidth(columnWidth(rowHeight));
  } else {
    setMinimumWidth(0);
    setMaximumWidth(QWIDGETSIZE_MAX);
  }
  const int width = viewport()->width(), room = width - 2 * kBetween;
  const bool table = !heads_.isEmpty(), ownRow = table || column;
  choosePlaces(room);
  int x = kBetween, y = table ? rowHeight : 0, high = 0;
  for (auto* item : items_) {
    const LegendPlace place = placeOf(*item, room);
    const QString& name = shortNames_ ? item->entry().shortLabel : item->entry().label;
    const int wanted = ownRow ? room : std::min(item->widthOf(name), room);
    if (x > kBetween && (ownRow || x + wanted > width)) {
      x = kBetween;
      y += high;
      high = 0;
    }
    item->setPlace(place);
    item->setGeometry(x, y, wanted, item->heightOf(place));
    high = std::max(high, item->height());
    x += wanted + kBetween;
  }
  const int content = items_.empty() && !table ? 0 : y + std::max(high, rowHeight) + 2;
  body_->resize(width, content);
  fixSize(content, rowHeight);
}

void ChartLegend::fixSize(int content, int rowHeight) {
  if (mostWidth_ > 0) {
    setMinimumHeight(0);
    setMaximumHeight(QWIDGETSIZE_MAX);
  } else {
    // Whole rows, so that none is cut at its half.
    setFixedHeight(std::min(content, std::max(1, mostHeight_ / rowHeight) * rowHeight + 2));
  }
}

void ChartLegend::paintHeads() {
  QPainter painter(body_);
  const ChartTheme theme = ChartTheme::of(palette());
  const QFontMetrics metrics(font());
  painter.setPen(theme.dimText);
  const int cell = cells_.cellWidth;
  int x = body_->width() - kBetween - cells_.cells * cell;
  for (const QString& head : heads_.mid(0, cells_.cells)) {
    const QRect place(x, 0, cell - kPadding, metrics.height() + 2);
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(head, Qt::ElideRight, place.width()));
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
