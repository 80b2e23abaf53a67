#include "ui/charts/curve_layer.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLineSeries>
#include <QScatterSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rotorbench {
namespace {

constexpr qreal kMarkerSize = 6;
constexpr qsizetype kMostMarkers = 400;
/// So many marks of a curve without a line are drawn; of more, every second, third, ...
constexpr qsizetype kMostLooseMarkers = 2000;
/// A curve whose line is longer than this many plot widths is a band: thin, solid and without
/// smoothing, since dashes cannot be seen and everything else costs time.
constexpr double kDenseWidths = 6;

struct Mapped {
  QList<QPointF> points;
  bool dense = false;
};

/// Leaves out points that a straight line between the kept ones passes within kStraight pixels: a
/// smooth curve needs few points, and both the series and the painter cost time per point. Lines
/// that go backwards are kept.
class Straightener {
 public:
  explicit Straightener(QList<QPointF>& points) : points_(points) {}

  void add(QPointF point) {
    if (points_.isEmpty()) return start(point);
    const double dx = point.x() - points_.last().x();
    if (waiting_) {
      const double slope = (point.y() - points_.last().y()) / dx;
      if (!(point.x() > next_.x()) || !(slope >= low_ && slope <= high_)) start(next_);
    }
    narrow(point);
  }
  void finish() {
    if (waiting_) points_.append(next_);
  }

 private:
  static constexpr double kStraight = 0.2;

  void start(QPointF point) {
    points_.append(point);
    waiting_ = false;
    low_ = -std::numeric_limits<double>::infinity();
    high_ = std::numeric_limits<double>::infinity();
  }
  /// Narrows the directions in which a line from the last kept point passes all points since.
  void narrow(QPointF point) {
    const QPointF from = points_.last();
    const double dx = point.x() - from.x();
    if (!(dx > 0)) return start(point);
    low_ = std::max(low_, (point.y() - kStraight - from.y()) / dx);
    high_ = std::min(high_, (point.y() + kStraight - from.y()) / dx);
    next_ = point;
    waiting_ = true;
  }

  QList<QPointF>& points_;
  QPointF next_;
  bool waiting_ = false;
  double low_ = 0, high_ = 0;
};

Mapped toPixels(const FrameCurve& curve, const AxisScale& x, const AxisScale& y, QSizeF size) {
  // Far outside the plot a line keeps its direction well enough, and the painter its precision.
  constexpr double kFar = 16;
  Mapped mapped;
  mapped.points.reserve(curve.points.size());
  Straightener straightener(mapped.points);
  double length = 0;
  QPointF last;
  bool first = true;
  for (const QPointF& point : curve.points) {
    const double unitX = x.toUnit(point.x());
    const double unitY = y.toUnit(point.y());
    if (!std::isfinite(unitX) || !std::isfinite(unitY)) continue;
    const QPointF pixel(std::clamp(unitX, -kFar, kFar) * size.width(),
                        std::clamp(unitY, -kFar, kFar) * size.height());
    if (!first) length += std::abs(pixel.y() - last.y());
    first = false;
    last = pixel;
    if (curve.style.markers) {
      mapped.points.append(pixel);
    } else {
      straightener.add(pixel);
    }
  }
  straightener.finish();
  mapped.dense = length > kDenseWidths * size.width();
  return mapped;
}

QList<QPointF> thinned(const QList<QPointF>& points) {
  const qsizetype step = points.size() / kMostLooseMarkers + 1;
  if (step == 1) return points;
  QList<QPointF> kept;
  for (qsizetype i = 0; i < points.size(); i += step) kept.append(points[i]);
  return kept;
}

}  // namespace

struct CurveLayer::Impl {
  struct Pair {
    QLineSeries* line = nullptr;
    QScatterSeries* marks = nullptr;
  };

  Impl() {
    scene.setItemIndexMethod(QGraphicsScene::NoIndex);
    scene.addItem(chart);
    chart->setAnimationOptions(QChart::NoAnimation);
    chart->setBackgroundVisible(false);
    chart->setPlotAreaBackgroundVisible(false);
    chart->legend()->hide();
    chart->setMargins({});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    for (auto* axis : {x, y}) axis->setVisible(false);
    chart->addAxis(x, Qt::AlignBottom);
    chart->addAxis(y, Qt::AlignLeft);
  }

  void resize(QSizeF size) {
    if (size == plotSize) return;
    plotSize = size;
    chart->resize(size);
    chart->setPlotArea(QRectF({0, 0}, size));
    chart->layout()->activate();
    x->setRange(0, size.width());
    y->setRange(0, size.height());
    scene.setSceneRect(QRectF({0, 0}, size));
  }

  template <class Series>
  Series* add() {
    auto* series = new Series;
    chart->addSeries(series);
    series->attachAxis(x);
    series->attachAxis(y);
    return series;
  }

  void resizeSeries(std::size_t count) {
    while (pairs.size() > count) {
      chart->removeSeries(pairs.back().line);
      delete pairs.back().line;
      if (pairs.back().marks) chart->removeSeries(pairs.back().marks);
      delete pairs.back().marks;
      pairs.pop_back();
    }
    while (pairs.size() < count) pairs.push_back({add<QLineSeries>(), nullptr});
  }

  void setMarks(Pair& pair, const QList<QPointF>& points, const QColor& color) {
    if (points.isEmpty() && !pair.marks) return;
    if (!pair.marks) pair.marks = add<QScatterSeries>();
    pair.marks->setMarkerSize(kMarkerSize);
    pair.marks->setColor(color);
    pair.marks->setBorderColor(Qt::transparent);
    pair.marks->replace(points);
  }

  QGraphicsScene scene;
  QChart* chart = new QChart;
  QValueAxis* x = new QValueAxis(chart);
  QValueAxis* y = new QValueAxis(chart);
  std::vector<Pair> pairs;
  QSizeF plotSize;
  bool smooth = true;
};

CurveLayer::CurveLayer() : impl_(std::make_unique<Impl>()) {}
CurveLayer::~CurveLayer() = default;

void CurveLayer::setFrame(const ChartFrame& frame, QSizeF size, const ChartTheme& theme,
                          qreal lineWidth) {
  impl_->resize(size);
  impl_->resizeSeries(frame.curves.size());
  impl_->smooth = true;
  for (std::size_t i = 0; i < frame.curves.size(); ++i) {
    const FrameCurve& curve = frame.curves[i];
    auto& pair = impl_->pairs[i];
    const Mapped mapped = toPixels(curve, frame.x.scale, frame.y[curve.axis].scale, size);
    if (mapped.dense && curve.style.line) impl_->smooth = false;
    CurveStyle style = curve.style;
    if (mapped.dense) style.dash = 0;
    const QPen pen = curvePen(style, theme, mapped.dense ? 1 : lineWidth);
    if (pair.line->pen() != pen) pair.line->setPen(pen);
    if (!pair.line->points().isEmpty() || !mapped.points.isEmpty())
      pair.line->replace(mapped.points);
    const bool marks =
        mapped.points.size() == 1 || (style.markers && mapped.points.size() <= kMostMarkers);
    impl_->setMarks(pair,
                    !style.line ? thinned(mapped.points)
                    : marks     ? mapped.points
                                : QList<QPointF>(),
                    theme.readable(style.color));
  }
}

void CurveLayer::paint(QPainter& painter, const QRectF& plot) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, impl_->smooth);
  impl_->scene.render(&painter, plot, impl_->scene.sceneRect(), Qt::IgnoreAspectRatio);
  painter.restore();
}

qsizetype CurveLayer::pointCount() const {
  qsizetype count = 0;
  for (const auto& pair : impl_->pairs) count += pair.line->points().size();
  return count;
}

}  // namespace rotorbench
