#include "ui/charts/pane_area.h"

#include <QSplitter>
#include <QStyle>
#include <QTimer>
#include <algorithm>

#include "ui/charts/chart_pane.h"

namespace rotorbench {
namespace {

void shareEvenly(QSplitter* splitter) {
  QList<int> sizes;
  for (int i = 0; i < splitter->count(); ++i) sizes += 1000;
  splitter->setSizes(sizes);
}

void prepare(QSplitter* splitter) {
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(4);
}

/// Panes side by side, as high as they must be to be read.
class PaneRow : public QSplitter {
 public:
  explicit PaneRow(QWidget* parent) : QSplitter(Qt::Horizontal, parent) {
    prepare(this);
    connect(this, &QSplitter::splitterMoved, this, &QWidget::updateGeometry);
  }

  QSize minimumSizeHint() const override {
    QSize least = QSplitter::minimumSizeHint();
    for (int i = 0; i < count(); ++i) {
      if (!widget(i)->isHidden())
        least.setHeight(std::max(least.height(), ChartPane::readableHeight(widget(i)->width())));
    }
    return least;
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QSplitter::resizeEvent(event);
    updateGeometry();
  }
};

}  // namespace

std::size_t usualColumns(std::size_t panes) {
  if (panes <= 3) return 1;
  return panes <= 8 ? 2 : 3;
}

PaneRows usualRows(const std::vector<ChartPane*>& panes) {
  PaneRows rows;
  const std::size_t columns = usualColumns(panes.size());
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (i % columns == 0) rows.emplace_back();
    rows.back().push_back(panes[i]);
  }
  return rows;
}

PaneArea::PaneArea(QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("chartArea"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
}

void PaneArea::place(const PaneRows& rows) {
  rows_ = rows;
  auto* column = new QSplitter(Qt::Vertical, this);
  prepare(column);
  column->setObjectName(QStringLiteral("chartColumn"));
  for (const auto& row : rows_) {
    auto* line = new PaneRow(column);
    for (auto* pane : row) {
      line->addWidget(pane);
      pane->show();
    }
    column->addWidget(line);
    shareEvenly(line);
  }
  setWidget(column);  // the old one goes, without panes
  column->show();
  shareEvenly(column);
  updateGeometry();
}

void PaneArea::showOnly(ChartPane* pane) {
  const auto* column = qobject_cast<QSplitter*>(widget());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto& row = rows_[i];
    for (auto* other : row) other->setVisible(!pane || other == pane);
    column->widget(static_cast<int>(i))
        ->setVisible(!pane || std::find(row.begin(), row.end(), pane) != row.end());
  }
}

void PaneArea::reveal(ChartPane* pane) {
  QTimer::singleShot(0, pane, [this, pane] { ensureWidgetVisible(pane, 0, 0); });
}

/// One pane at its least and a scroll bar.
QSize PaneArea::minimumSizeHint() const {
  QSize least(0, 0);
  for (const auto& row : rows_)
    for (const auto* pane : row) least = least.expandedTo(pane->minimumSize());
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
  return least + QSize(bar, bar);
}

}  // namespace rotorbench
