#include "ui/charts/chart_link.h"

namespace rotorbench {

void ChartLink::setTimeRange(std::optional<Span> range) {
  if (range == timeRange_) return;
  timeRange_ = range;
  emit timeRangeChanged();
}

void ChartLink::setFollows(bool follows) {
  if (follows == follows_) return;
  follows_ = follows;
  emit followsChanged(follows);
}

void ChartLink::setMarksShown(bool shown) {
  if (shown == marksShown_) return;
  marksShown_ = shown;
  emit marksShownChanged(shown);
}

void ChartLink::newestTime(double time) {
  if (!follows_ || !timeRange_ || time == timeRange_->high) return;
  setTimeRange(Span{time - timeRange_->width(), time});
}

void ChartLink::reset() {
  setFollows(false);
  setTimeRange(std::nullopt);
  setCursor(Cursor::A, std::nullopt);
  setCursor(Cursor::B, std::nullopt);
}

std::optional<double> ChartLink::cursor(Cursor which) const {
  return which == Cursor::A ? a_ : b_;
}

void ChartLink::setCursor(Cursor which, std::optional<double> time) {
  auto& cursor = which == Cursor::A ? a_ : b_;
  if (cursor == time) return;
  cursor = time;
  emit cursorsChanged();
}

void ChartLink::moveCursor(Cursor which, std::optional<double> time) {
  setCursor(which, time);
  if (which == Cursor::A && time) emit timeCursorMoved(*time);
}

}  // namespace rotorbench
