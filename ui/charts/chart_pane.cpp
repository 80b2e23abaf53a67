#include "ui/charts/chart_pane.h"

#include <QBoxLayout>
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "sim/core/unit_text.h"
#include "ui/charts/channel_mime.h"
#include "ui/charts/channel_pattern.h"
#include "ui/charts/chart_legend.h"
#include "ui/charts/readouts.h"

namespace rotorbench {
namespace {

constexpr double kLegendShare = 0.35;
constexpr int kReadable = 190;  // px, with the legend beside the plot
constexpr int kReadableOverLegend = 250;
constexpr int kLowPane = 280;           // px; below this the legend stands beside the plot,
constexpr double kLegendColumns = 1.5;  // if the pane is this much wider than high

}  // namespace

ChartPane::ChartPane(RunSet* runs, ChartLink* link, QWidget* parent)
    : QFrame(parent), runs_(runs), link_(link) {
  build();
  pending_.setSingleShot(true);
  pending_.setInterval(0);
  connect(&pending_, &QTimer::timeout, this, [this] { refresh(); });
  connect(runs_, &RunSet::changed, this, &ChartPane::takeCurves);
  connect(runs_, &RunSet::marksChanged, this, &ChartPane::updateMarks);
  connect(link_, &ChartLink::marksShownChanged, this, &ChartPane::updateMarks);
  connect(link_, &ChartLink::timeRangeChanged, this, &ChartPane::markStale);
  connect(link_, &ChartLink::cursorsChanged, this, [this] {
    updateReadouts();
    if (spec_.kind == ChartKind::XY) plot_->setRings(rings());
  });
  connect(plot_, &PlotWidget::viewChosen, this, &ChartPane::viewChosen);
  connect(plot_, &PlotWidget::fitAsked, this, &ChartPane::fit);
  connect(plot_, &PlotWidget::menuAsked, this, [this](QPoint at) { menu_->popup(at); });
  connect(plot_, &PlotWidget::rightClicked, this, [this](QPoint at) {
    if (!back()) menu_->popup(at);
  });
  connect(legend_, &ChartLegend::toggled, this, [this](std::size_t i) {
    hidden_.toggle(curves_.curves.at(i), curves_.curves);
    takeCurves();
  });
  connect(legend_, &ChartLegend::removeAsked, this, &ChartPane::removeChannel);
  takeCurves();
}

ChartPane::~ChartPane() {
  // The title loses the focus while it is destroyed, and would report an edit to a pane that is no
  // more.
  title_->disconnect(this);
}

void ChartPane::setSpec(const ChartSpec& spec) {
  if (spec == spec_) return;
  const bool otherAxes = spec.kind != spec_.kind || spec.logX != spec_.logX ||
                         spec.logY != spec_.logY || spec.x != spec_.x;
  spec_ = spec;
  if (otherAxes) {
    x_.reset();
    y_.clear();
    history_.clear();
  }
  if (title_->text() != QString::fromStdString(spec.title)) {
    title_->setText(QString::fromStdString(spec.title));
    title_->setCursorPosition(0);  // a long title shows its beginning
  }
  setAccessibleName(spec.title.empty() ? tr("Chart") : tr("Chart %1").arg(title_->text()));
  takeCurves();
}

void ChartPane::edit(const ChartSpec& spec) {
  if (spec == spec_) return;
  setSpec(spec);
  emit specChanged();
}

void ChartPane::addChannel(const QString& channel) {
  edit(withChannel(spec_, channel.toStdString()));
}

void ChartPane::removeChannel(const QString& channel) {
  edit(withoutChannel(spec_, channel.toStdString(), runs_->channels()));
}

void ChartPane::takeCurves() {
  curves_ = chartCurves(spec_, *runs_, hidden_);
  builder_.forgetTraces();
  plot_->relayout();
  std::vector<LegendEntry> entries;
  for (const auto& curve : curves_.curves) {
    const QString unit = QString::fromStdString(prettyUnit(curve.y().unit));
    QString tip = QString::fromStdString(curve.y().description);
    if (!unit.isEmpty()) tip += QStringLiteral(" [%1]").arg(unit);
    entries.push_back({curve.label, curve.shortLabel, tip.trimmed(), curve.style, curve.hidden,
                       QString::fromStdString(curve.y().name)});
  }
  legend_->setEntries(entries);
  updateHint();
  updateReadouts();
  updateMarks();
  markStale();
}

void ChartPane::updateMarks() {
  std::vector<PlotMark> marks;
  for (const ChartRun& run : runs_->runs()) {
    if (!run.visible || !link_->marksShown()) continue;
    for (const RunMark& mark : run.marks) marks.push_back({mark.time, mark.text, run.color});
  }
  plot_->setMarks(std::move(marks));
}

void ChartPane::updateHint() {
  const bool anyVisible = std::any_of(runs_->runs().begin(), runs_->runs().end(),
                                      [](const ChartRun& run) { return run.visible; });
  QString hint;
  if (splitPatterns(spec_.channels).empty()) {
    hint = tr("Drag channels here from the signal tree, or double-click one there.");
  } else if (!anyVisible) {
    hint = tr("Press Run (F5) to fill this chart.");
  } else if (curves_.curves.empty()) {
    hint = tr("The shown runs have no channel %1.").arg(QString::fromStdString(spec_.channels));
    const QString reason = runs_->reasonOfAbsence(splitPatterns(spec_.channels));
    if (!reason.isEmpty()) hint += u' ' + reason;
  }
  plot_->setHint(hint);
}

void ChartPane::markStale() {
  stale_ = true;
  if (isVisible()) pending_.start();
}

std::size_t ChartPane::publishedRows() const {
  std::size_t rows = 0;
  for (const auto& curve : curves_.curves) rows += curve.recording->rows();
  return rows;
}

bool ChartPane::refresh() {
  std::size_t budget = kRowsPerRefresh;
  return refresh(budget);
}

bool ChartPane::refresh(std::size_t& rowBudget) {
  const std::size_t rows = publishedRows();
  const bool growing = runs_->growing();
  if (!stale_ && rows == rowsShown_ && growing == growingShown_) return false;
  const FrameRequest request{spec_,    curves_, view(), plot_->plotSize(), devicePixelRatioF(),
                             QLocale()};
  ChartFrame frame = builder_.build(request, runs_->summaries(), rowBudget);
  plot_->setContent({std::move(frame), spec_.kind, view(), rings()});
  rowsShown_ = rows;
  growingShown_ = growing;
  stale_ = !builder_.complete();
  if (stale_ && isVisible()) pending_.start();
  updateReadouts();
  return true;
}

ChartFrame ChartPane::frameFor(QSizeF plotSize, double pixelRatio, const QLocale& locale) const {
  FrameBuilder builder;
  std::size_t budget = std::numeric_limits<std::size_t>::max();
  return builder.build({spec_, curves_, view(), plotSize, pixelRatio, locale}, runs_->summaries(),
                       budget);
}

std::vector<PlotWidget::Ring> ChartPane::rings() const {
  std::vector<PlotWidget::Ring> rings;
  if (spec_.kind != ChartKind::XY) return rings;
  for (const Cursor which : {Cursor::A, Cursor::B}) {
    const auto time = link_->cursor(which);
    if (!time) continue;
    for (const auto& curve : curves_.curves) {
      if (curve.hidden || curve.recording->rows() == 0) continue;
      rings.push_back({{curve.recording->sampleAt(curve.xChannel, *time),
                        curve.recording->sampleAt(curve.yChannel, *time)},
                       curve.axis});
    }
  }
  return rings;
}

void ChartPane::updateReadouts() {
  const Readouts readouts = makeReadouts(curves_.curves, *link_, QLocale());
  legend_->setReadouts(readouts.heads, readouts.cells);
}

void ChartPane::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  placeLegend();
  markStale();
}

int ChartPane::readableHeight(int width) {
  return width > kLegendColumns * kReadable ? kReadable : kReadableOverLegend;
}

/// In a low, wide pane the legend stands beside the plot, which needs the height.
void ChartPane::placeLegend() {
  const bool beside = height() < kLowPane && width() > kLegendColumns * height();
  content_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  legend_->setMostWidth(beside ? std::clamp(width() * 9 / 20, 120, 260) : 0);
  legend_->setMostHeight(static_cast<int>(kLegendShare * height()));
}

void ChartPane::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  if (stale_) pending_.start();
}

void ChartPane::dragEnterEvent(QDragEnterEvent* event) {
  if (channelsIn(event->mimeData()).isEmpty()) return;
  event->acceptProposedAction();
  dropHere_ = true;
  update();
}

void ChartPane::dragLeaveEvent(QDragLeaveEvent*) {
  dropHere_ = false;
  update();
}

void ChartPane::dropEvent(QDropEvent* event) {
  dropHere_ = false;
  update();
  ChartSpec spec = spec_;
  for (const QString& channel : channelsIn(event->mimeData()))
    spec = withChannel(spec, channel.toStdString());
  event->acceptProposedAction();
  emit activated();
  edit(spec);
}

void ChartPane::setCurrent(bool current) {
  current_ = current;
  update();
}

bool ChartPane::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::MouseButtonPress)
    emit activated();
  return QFrame::eventFilter(watched, event);
}

void ChartPane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ChartTheme theme = ChartTheme::of(palette());
  painter.fillRect(rect(), theme.ground);
  painter.setPen(dropHere_ ? QPen(theme.accent, 3) : QPen(current_ ? theme.accent : theme.grid, 1));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace rotorbench
