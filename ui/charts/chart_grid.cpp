#include "ui/charts/chart_grid.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/charts/channel_mime.h"
#include "ui/charts/channel_pattern.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"

namespace rotorbench {
namespace {

constexpr int kFrameMs = 33;
constexpr int kRefreshBudgetMs = 20;  // the rest of a frame is for painting

}  // namespace

ChartGrid::ChartGrid(RunSet* runs, QWidget* parent) : QWidget(parent), runs_(runs) {
  setObjectName(QStringLiteral("chartGrid"));
  setAccessibleName(tr("Charts"));
  setAcceptDrops(true);
  pages_ = new QStackedLayout(this);
  buildEmptyState();
  area_ = new PaneArea(this);
  pages_->addWidget(empty_);
  pages_->addWidget(area_);
  clock_.setInterval(kFrameMs);
  connect(&clock_, &QTimer::timeout, this, &ChartGrid::refresh);
  connect(runs_, &RunSet::changed, this, &ChartGrid::startClock);
  connect(&link_, &ChartLink::timeCursorMoved, this, &ChartGrid::timeCursorMoved);
}

ChartGrid::~ChartGrid() {
  // Panes refer to the link, which as a member goes before the children.
  qDeleteAll(panes_);
}

void ChartGrid::buildEmptyState() {
  empty_ = new QWidget(this);
  auto* column = new QVBoxLayout(empty_);
  auto* text =
      new QLabel(tr("No charts yet. Add one, or drag channels here from the signal tree."), empty_);
  text->setObjectName(QStringLiteral("chartGridEmptyText"));
  text->setAlignment(Qt::AlignCenter);
  text->setWordWrap(true);
  text->setForegroundRole(QPalette::PlaceholderText);
  auto* add = new QPushButton(tr("Add chart"), empty_);
  add->setObjectName(QStringLiteral("addFirstChart"));
  add->setAccessibleName(add->text());
  connect(add, &QPushButton::clicked, this, [this] {
    addPane();
    setEdited();
  });
  column->addStretch();
  column->addWidget(text);
  column->addWidget(add, 0, Qt::AlignHCenter);
  column->addStretch();
}

ChartPane* ChartGrid::makePane(const ChartSpec& spec) {
  auto* pane = new ChartPane(runs_, &link_, this);
  pane->setSpec(spec);
  connect(pane, &ChartPane::specChanged, this, &ChartGrid::setEdited);
  connect(pane, &ChartPane::activated, this, [this, pane] { setCurrentPane(pane); });
  connect(pane, &ChartPane::maximizeAsked, this,
          [this, pane] { maximize(maximized_ == pane ? nullptr : pane); });
  // Later, since the pane's own menu is still open while it asks.
  connect(
      pane, &ChartPane::closeAsked, this,
      [this, pane] {
        removePane(pane);
        setEdited();
      },
      Qt::QueuedConnection);
  connect(pane, &ChartPane::splitAsked, this, [this, pane](Qt::Orientation orientation) {
    splitPane(pane, orientation);
    setEdited();
  });
  connect(pane, &ChartPane::exportAsked, this, [this, pane] { exportByDialog(pane); });
  connect(pane, &ChartPane::copyAsked, this, [this, pane] { emit message(copyPane(*pane)); });
  return pane;
}

void ChartGrid::setSpecs(const std::vector<ChartSpec>& wanted) {
  if (wanted == specs()) return;
  maximize(nullptr);
  const bool sameCount = wanted.size() == panes_.size();
  auto panes = panes_;
  while (panes.size() > wanted.size()) {
    if (current_ == panes.back()) current_ = nullptr;
    delete panes.back();
    panes.pop_back();
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i < panes.size()) {
      panes[i]->setSpec(wanted[i]);
    } else {
      panes.push_back(makePane(wanted[i]));
    }
  }
  if (!sameCount) place(usualRows(panes));
}

void ChartGrid::resetView() {
  maximize(nullptr);
  link_.reset();
  for (auto* pane : panes_) pane->resetView();
  place(usualRows(panes_));
  const auto toFirst = [this] {
    if (panes_.empty()) return setCurrentPane(nullptr);
    if (isAncestorOf(QApplication::focusWidget())) panes_.front()->plot()->setFocus();
    setCurrentPane(panes_.front());
  };
  toFirst();
  // And once more when the page is there: the keyboard then comes to whichever chart Qt finds
  // first.
  QMetaObject::invokeMethod(this, toFirst, Qt::QueuedConnection);
}

std::vector<ChartSpec> ChartGrid::specs() const {
  std::vector<ChartSpec> all;
  for (const auto* pane : panes_) all.push_back(pane->spec());
  return all;
}

void ChartGrid::place(const PaneRows& rows) {
  rows_ = rows;
  panes_.clear();
  for (const auto& row : rows_) panes_.insert(panes_.end(), row.begin(), row.end());
  area_->place(rows_);
  pages_->setCurrentWidget(panes_.empty() ? empty_ : area_);
  if (!current_ && !panes_.empty()) setCurrentPane(panes_.front());
}

void ChartGrid::setCurrentPane(ChartPane* pane) {
  if (pane == current_) return;
  if (current_) current_->setCurrent(false);
  current_ = pane;
  if (current_) current_->setCurrent(panes_.size() > 1);
}

ChartPane* ChartGrid::addPane(const ChartSpec& spec) {
  maximize(nullptr);
  auto* pane = makePane(spec);
  PaneRows rows = rows_;
  const std::size_t columns = usualColumns(panes_.size() + 1);
  if (rows.empty() || rows.back().size() >= columns) rows.emplace_back();
  rows.back().push_back(pane);
  place(rows);
  setCurrentPane(pane);
  area_->reveal(pane);
  return pane;
}

ChartPane* ChartGrid::splitPane(ChartPane* pane, Qt::Orientation orientation) {
  maximize(nullptr);
  auto* added = makePane({});
  PaneRows rows = rows_;
  for (auto row = rows.begin(); row != rows.end(); ++row) {
    const auto at = std::find(row->begin(), row->end(), pane);
    if (at == row->end()) continue;
    if (orientation == Qt::Horizontal) {
      row->insert(at + 1, added);
    } else {
      rows.insert(row + 1, {added});
    }
    break;
  }
  place(rows);
  setCurrentPane(added);
  area_->reveal(added);
  return added;
}

void ChartGrid::removePane(ChartPane* pane) {
  maximize(nullptr);
  PaneRows rows = rows_;
  for (auto& row : rows) std::erase(row, pane);
  std::erase_if(rows, [](const auto& row) { return row.empty(); });
  if (current_ == pane) current_ = nullptr;
  delete pane;
  place(rows);
}

void ChartGrid::maximize(ChartPane* pane) {
  if (pane == maximized_) return;
  maximized_ = pane;
  area_->showOnly(pane);
  for (auto* other : panes_) other->setMaximized(other == pane);
}

void ChartGrid::addChannels(const QStringList& channels) {
  if (!current_) addPane();
  ChartSpec spec = current_->spec();
  for (const QString& channel : channels) spec = withChannel(spec, channel.toStdString());
  if (spec == current_->spec()) return;
  current_->setSpec(spec);
  setEdited();
}

void ChartGrid::refresh() {
  const bool growing =
      runs_->growing();  // asked first: the end of a run is seen below or at the next turn
  double newest = -std::numeric_limits<double>::infinity();
  for (const auto& run : runs_->runs()) {
    const std::size_t rows = run.recording->rows();
    if (run.visible && rows > 0) newest = std::max(newest, run.recording->value(0, rows - 1));
  }
  if (std::isfinite(newest)) link_.newestTime(newest);
  for (const auto& recording : arrivals_.take(*runs_)) {
    for (auto* pane : panes_) pane->bringIn(*recording);
  }
  // In turn, so that a slow pane does not starve the others.
  QElapsedTimer elapsed;
  elapsed.start();
  std::size_t rowBudget = ChartPane::kRowsPerRefresh;
  bool drawn = false;
  for (std::size_t i = 0; i < panes_.size() && elapsed.elapsed() < kRefreshBudgetMs; ++i) {
    ChartPane* pane = panes_[nextToRefresh_++ % panes_.size()];
    if (pane->isVisible()) drawn = pane->refresh(rowBudget) || drawn;
  }
  if (!drawn && !growing) clock_.stop();
}

void ChartGrid::startClock() {
  if (isVisible() && !clock_.isActive()) clock_.start();
}

void ChartGrid::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  startClock();
}

void ChartGrid::setTimeCursor(std::optional<double> time) {
  link_.setCursor(Cursor::A, time);
}

void ChartGrid::setEdited() {
  emit specsChanged();
}

void ChartGrid::dragEnterEvent(QDragEnterEvent* event) {
  if (!channelsIn(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ChartGrid::dropEvent(QDropEvent* event) {
  addPane();
  addChannels(channelsIn(event->mimeData()));
  event->acceptProposedAction();
}

void ChartGrid::exportByDialog(ChartPane* pane) {
  const QString title = QString::fromStdString(pane->spec().title);
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export chart"), (title.isEmpty() ? tr("chart") : title) + QStringLiteral(".png"),
      tr("Picture (*.png);;Drawing (*.svg);;Page (*.pdf);;Table of the visible range (*.csv)"));
  if (path.isEmpty()) return;
  const QString error = exportPane(*pane, path);
  if (error.isEmpty()) {
    emit message(tr("The chart was saved as %1.").arg(path));
  } else {
    QMessageBox::warning(this, tr("Export chart"), error);
  }
}

}  // namespace rotorbench
