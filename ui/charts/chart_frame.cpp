#include "ui/charts/chart_frame.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {
namespace {

constexpr double kPixelsPerXTick = 80;
constexpr double kPixelsPerYTick = 34;
constexpr Span kNothing{std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};

int tickCount(double pixels, double perTick) {
  return std::clamp(static_cast<int>(pixels / perTick), 2, 12);
}

void include(Span& span, double value) {
  span.low = std::min(span.low, value);
  span.high = std::max(span.high, value);
}

/// A usable range around the data, rounded to half the distance of ticks so that little room is
/// lost.
Span fitted(Span data, bool log, int ticks) {
  const Span nice = niceSpan(data, log, 2 * ticks);
  return isUsable(nice, log) ? nice : niceSpan(kNothing, log, ticks);
}

/// The whole time span of the recordings; while one grows, with room so that the axis seldom moves.
Span timeSpan(const CurveList& list, bool log) {
  Span span = kNothing;
  bool growing = false;
  const Recording* last = nullptr;
  for (const auto& curve : list.curves) {
    const Recording& recording = *curve.recording;
    const std::size_t rows = recording.rows();
    if (&recording == last || rows == 0) continue;
    last = &recording;
    growing = growing || !recording.finished();
    const double end = recording.value(0, rows - 1);
    const double zero = recording.value(0, 0);
    const std::size_t firstPositive = recording.lowerBound(std::numeric_limits<double>::min());
    include(span,
            log && zero <= 0 && firstPositive < rows ? recording.value(0, firstPositive) : zero);
    include(span, end);
  }
  if (log) return fitted(span, true, 5);
  if (!(span.high >= span.low)) return {0, 1};
  if (growing) span.high = roomyEnd(span.low, span.high);
  return isUsable(span, false) ? span : fitted(span, false, 5);
}

ColumnSummary::Values counted(bool log) {
  return log ? ColumnSummary::Values::Positive : ColumnSummary::Values::All;
}

/// Smallest and largest value among points whose x lies in view.
Span extent(const ChartFrame& frame, std::size_t axis) {
  Span span = kNothing;
  for (const auto& curve : frame.curves) {
    if (curve.hidden || curve.axis != axis) continue;
    for (const QPointF& point : curve.points) {
      if (point.x() >= frame.x.scale.span.low && point.x() <= frame.x.scale.span.high)
        include(span, point.y());
    }
  }
  return span;
}

}  // namespace

bool isInView(const FrameCurve& curve, const ChartFrame& frame) {
  if (curve.hidden) return false;
  const Span x = frame.x.scale.span, y = frame.y[curve.axis].scale.span;
  const auto meets = [](Span range, double a, double b) {
    return std::min(a, b) <= range.high && std::max(a, b) >= range.low;
  };
  // A line may cross the view between two points; what passes its corner counts too.
  for (qsizetype i = 0; i < curve.points.size(); ++i) {
    const QPointF& point = curve.points[i];
    const QPointF& next = curve.points[std::min(i + 1, curve.points.size() - 1)];
    const QPointF& end = std::isfinite(next.y()) && curve.style.line ? next : point;
    if (meets(x, point.x(), end.x()) && meets(y, point.y(), end.y())) return true;
  }
  return false;
}

ChartFrame FrameBuilder::build(const FrameRequest& request, SummaryCache& summaries,
                               std::size_t& rowBudget) {
  complete_ = true;
  ChartFrame frame;
  const int xTicks = tickCount(request.plotSize.width(), kPixelsPerXTick);
  const int yTicks = tickCount(request.plotSize.height(), kPixelsPerYTick);
  for (std::size_t i = 0; i < request.list.units.size(); ++i) {
    FrameAxis axis;
    axis.unit = request.list.units[i];
    axis.scale.log = request.spec.logY;
    if (const auto at = request.view.y.find(axis.unit); at != request.view.y.end())
      axis.scale.span = at->second;
    frame.y.push_back(std::move(axis));
  }
  for (const auto& curve : request.list.curves) {
    frame.curves.push_back({curve.label, curve.style, curve.axis, curve.hidden, {}});
  }
  frame.x.scale.log = request.spec.logX;
  frame.x.unit = request.list.curves.empty() ? "s" : request.list.curves.front().x().unit;
  if (request.spec.kind == ChartKind::Time) {
    addTimeCurves(request, summaries, rowBudget, frame);
    for (std::size_t i = 0; i < frame.y.size(); ++i) {
      auto& axis = frame.y[i];
      if (!request.view.y.contains(axis.unit))
        axis.scale.span = fitted(extent(frame, i), axis.scale.log, yTicks);
    }
  } else {
    addXyCurves(request, summaries, rowBudget, frame);
  }
  frame.x.ticks = niceTicks(frame.x.scale, xTicks, request.locale);
  frame.x.title = axisTitle(abscissaQuantity(request.list), frame.x.unit, frame.x.ticks.exponent);
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    auto& axis = frame.y[i];
    axis.ticks = niceTicks(axis.scale, yTicks, request.locale);
    axis.title = axisTitle(axisQuantity(request.list, i), axis.unit, axis.ticks.exponent);
  }
  return frame;
}

void FrameBuilder::forgetTraces() {
  xyTraces_.clear();
  timeTraces_.clear();
  bounds_.clear();
}

void FrameBuilder::addTimeCurves(const FrameRequest& request, SummaryCache& summaries,
                                 std::size_t& rowBudget, ChartFrame& frame) {
  auto& x = frame.x.scale;
  x.span = request.view.x ? *request.view.x : timeSpan(request.list, x.log);
  if (!isUsable(x.span, x.log)) x.span = timeSpan(request.list, x.log);
  const int columns =
      std::clamp(static_cast<int>(request.plotSize.width() * request.pixelRatio), 16, 4096);
  timeTraces_.resize(frame.curves.size());
  std::map<const Recording*, std::size_t> rowsOf;  // of this frame, while the recordings grow
  for (std::size_t i = 0; i < frame.curves.size(); ++i) {
    const Curve& curve = request.list.curves[i];
    if (curve.hidden) continue;
    const Recording& recording = *curve.recording;
    const std::size_t rows = rowsOf.try_emplace(&recording, recording.rows()).first->second;
    const auto& bounds = bounds_[&recording].update(recording, rows, x, columns);
    auto& summary = summaries.summary(curve.recording, curve.yChannel, counted(request.spec.logY));
    rowBudget -= summary.extend(rowBudget);
    complete_ = complete_ && summary.rows() >= bounds.back();
    frame.curves[i].points = timeTraces_[i].update(recording, summary, x, bounds);
  }
}

void FrameBuilder::addXyCurves(const FrameRequest& request, SummaryCache& summaries,
                               std::size_t& rowBudget, ChartFrame& frame) {
  Span xData = kNothing;
  std::vector<Span> yData(frame.y.size(), kNothing);
  const auto whole = [&](const Curve& curve, std::size_t channel, bool log, Span& span) {
    auto& summary = summaries.summary(curve.recording, channel, counted(log));
    rowBudget -= summary.extend(rowBudget);
    complete_ = complete_ && summary.rows() == curve.recording->rows();
    const Extremes extremes = summary.extremes(0, summary.rows());
    if (extremes.empty()) return;
    include(span, extremes.min);
    include(span, extremes.max);
  };
  for (const auto& curve : request.list.curves) {
    if (curve.hidden) continue;
    whole(curve, curve.xChannel, request.spec.logX, xData);
    whole(curve, curve.yChannel, request.spec.logY, yData[curve.axis]);
  }
  const QSizeF size = request.plotSize;
  auto& x = frame.x.scale;
  x.span = request.view.x && isUsable(*request.view.x, x.log)
               ? *request.view.x
               : fitted(xData, x.log, tickCount(size.width(), kPixelsPerXTick));
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    auto& axis = frame.y[i];
    if (request.view.y.contains(axis.unit)) continue;
    axis.scale.span = fitted(yData[i], axis.scale.log, tickCount(size.height(), kPixelsPerYTick));
  }
  xyTraces_.resize(request.list.curves.size());
  for (std::size_t i = 0; i < request.list.curves.size(); ++i) {
    const Curve& curve = request.list.curves[i];
    if (curve.hidden) continue;
    rowBudget -= xyTraces_[i].update(*curve.recording, curve.xChannel, curve.yChannel, x,
                                     frame.y[curve.axis].scale, size.width() * request.pixelRatio,
                                     size.height() * request.pixelRatio, rowBudget);
    complete_ = complete_ && xyTraces_[i].complete(*curve.recording);
    frame.curves[i].points = xyTraces_[i].points();
  }
}

}  // namespace rotorbench
