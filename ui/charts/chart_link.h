// What all charts of a grid share: the time range in view, whether it follows the newest values,
// and the two cursors. Times in s of simulated time.
#pragma once

#include <QObject>
#include <optional>

#include "ui/charts/axis_scale.h"

namespace rotorbench {

enum class Cursor { A, B };

class ChartLink : public QObject {
  Q_OBJECT

 public:
  explicit ChartLink(QObject* parent = nullptr) : QObject(parent) {}

  /// Empty: every chart shows the whole time of its runs.
  [[nodiscard]] std::optional<Span> timeRange() const { return timeRange_; }
  void setTimeRange(std::optional<Span> range);

  /// While it follows, a chosen range keeps its width and moves with the newest value.
  [[nodiscard]] bool follows() const { return follows_; }
  void setFollows(bool follows);
  void newestTime(double time);
  /// Whether charts show what happened to their runs.
  [[nodiscard]] bool marksShown() const { return marksShown_; }
  void setMarksShown(bool shown);
  /// As at first: the whole time, not following, no cursors.
  void reset();

  [[nodiscard]] std::optional<double> cursor(Cursor which) const;
  /// Moves, sets or removes a cursor without telling others that a person did it.
  void setCursor(Cursor which, std::optional<double> time);
  /// As a person does it in a chart: also sends timeCursorMoved for cursor A.
  void moveCursor(Cursor which, std::optional<double> time);

 signals:
  void timeRangeChanged();
  void followsChanged(bool follows);
  void cursorsChanged();
  void marksShownChanged(bool shown);
  /// A person moved cursor A to this time.
  void timeCursorMoved(double time);

 private:
  std::optional<Span> timeRange_;
  bool follows_ = false;
  bool marksShown_ = true;
  std::optional<double> a_, b_;
};

}  // namespace rotorbench
