// One state of a chart, ready to be painted on a screen or a page: scales, ticks and few points per
// curve.
#pragma once

#include <QList>
#include <QLocale>
#include <QPointF>
#include <QSizeF>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/charts/axis_scale.h"
#include "ui/charts/curves.h"
#include "ui/charts/decimate.h"

namespace rotorbench {

/// What a person chose to see; an axis without a range shows all that is there.
struct ChartView {
  std::optional<Span> x;
  std::map<std::string, Span> y;  ///< by unit
  bool operator==(const ChartView&) const = default;
};

struct FrameAxis {
  std::string unit;
  QString title;
  AxisScale scale;
  Ticks ticks;
};

struct FrameCurve {
  QString label;
  CurveStyle style;
  std::size_t axis = 0;
  bool hidden = false;
  QList<QPointF> points;  ///< data units
};

struct ChartFrame {
  FrameAxis x;
  std::vector<FrameAxis> y;  ///< left, right, outer left, outer right, ...
  std::vector<FrameCurve> curves;
};

/// Whether any part of the curve lies between the axes.
bool isInView(const FrameCurve& curve, const ChartFrame& frame);

struct FrameRequest {
  const ChartSpec& spec;
  const CurveList& list;
  const ChartView& view;
  QSizeF plotSize;        ///< in device-independent pixels
  double pixelRatio = 1;  ///< device pixels per pixel: sets the number of columns
  QLocale locale;
};

/// Builds frames of one chart; remembers the traces of its curves, so that a frame reads new rows
/// only.
class FrameBuilder {
 public:
  /// Reads at most `rowBudget` rows that were not read before (and counts it down); `complete`
  /// tells whether all published rows are in.
  ChartFrame build(const FrameRequest& request, SummaryCache& summaries, std::size_t& rowBudget);
  [[nodiscard]] bool complete() const { return complete_; }
  /// Call when the curves have changed.
  void forgetTraces();

 private:
  void addTimeCurves(const FrameRequest& request, SummaryCache& summaries, std::size_t& rowBudget,
                     ChartFrame& frame);
  void addXyCurves(const FrameRequest& request, SummaryCache& summaries, std::size_t& rowBudget,
                   ChartFrame& frame);

  std::vector<XyTrace> xyTraces_;
  std::vector<TimeTrace> timeTraces_;
  std::map<const Recording*, ColumnBounds> bounds_;
  bool complete_ = true;
};

}  // namespace rotorbench
