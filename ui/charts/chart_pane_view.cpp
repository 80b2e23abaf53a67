// The view of a ChartPane: zoom, its history, and bringing a run into it.
#include <cmath>
#include <limits>

#include "ui/charts/chart_pane.h"

namespace rotorbench {
namespace {

constexpr int kGesturePauseMs = 700;  // a longer pause starts a new step of the zoom history
constexpr std::size_t kMostHistory = 50;

}  // namespace

ChartView ChartPane::view() const {
  return {spec_.kind == ChartKind::Time ? link_->timeRange() : x_, y_};
}

void ChartPane::setView(const ChartView& view) {
  if (spec_.kind == ChartKind::Time) {
    link_->setTimeRange(view.x);
  } else {
    x_ = view.x;
  }
  y_ = view.y;
  markStale();
}

void ChartPane::viewChosen(const ChartView& chosen, bool continuous) {
  const ChartView before = this->view();
  if (chosen == before) return;
  const bool goesOn =
      continuous && gestureClock_.isValid() && gestureClock_.elapsed() < kGesturePauseMs;
  if (!goesOn) history_.push_back(before);
  if (history_.size() > kMostHistory) history_.erase(history_.begin());
  if (continuous) {
    gestureClock_.restart();
  } else {
    gestureClock_.invalidate();
  }
  // Zooming by the wheel keeps following; another place in time does not.
  const bool sameWidth =
      chosen.x && before.x && std::abs(chosen.x->width() / before.x->width() - 1) < 1e-9;
  if (chosen.x != before.x && (!continuous || sameWidth)) link_->setFollows(false);
  setView(chosen);
}

void ChartPane::fit() {
  const ChartView before = this->view();
  if (before == ChartView{}) return;
  history_.push_back(before);
  gestureClock_.invalidate();
  setView({});
}

void ChartPane::resetView() {
  x_.reset();
  y_.clear();
  history_.clear();
  gestureClock_.invalidate();
  hidden_.clear();
  takeCurves();
}

bool ChartPane::sees(const Recording& recording, const ChartView& view) const {
  FrameBuilder builder;
  std::size_t budget = std::numeric_limits<std::size_t>::max();
  const ChartFrame frame = builder.build({spec_, curves_, view, plot_->plotSize(), 1, QLocale()},
                                         runs_->summaries(), budget);
  for (std::size_t i = 0; i < frame.curves.size(); ++i) {
    if (curves_.curves[i].recording.get() == &recording && isInView(frame.curves[i], frame))
      return true;
  }
  return false;
}

/// Of the view only what must go does: other charts keep the time, if this run is at that time.
void ChartPane::bringIn(const Recording& recording) {
  const ChartView before = view();
  if (before == ChartView{} || sees(recording, before)) return;
  const ChartView sameTime{before.x, {}};
  const bool inTime = spec_.kind == ChartKind::Time && sees(recording, sameTime);
  if (!inTime && !sees(recording, {})) return;  // it is not in this chart at all
  history_.push_back(before);
  gestureClock_.invalidate();
  setView(inTime ? sameTime : ChartView{});
}

bool ChartPane::back() {
  gestureClock_.invalidate();
  if (!history_.empty()) {
    const ChartView before = history_.back();
    history_.pop_back();
    setView(before);
    return true;
  }
  // The time was zoomed from another chart.
  if (spec_.kind != ChartKind::Time || !link_->timeRange()) return false;
  link_->setTimeRange(std::nullopt);
  return true;
}

}  // namespace rotorbench
