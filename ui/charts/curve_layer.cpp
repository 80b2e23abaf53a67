#include "ui/charts/curve_layer.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLineSeries>
#include <QScatterSeries>
#include <QValueAxis>
#include <cmath>

namespace rotorbench {
namespace {

constexpr qreal kMarkerSize = 6;
constexpr qsizetype kMostMarkers = 400;
/// A curve whose line is longer than this many plot widths is a band: thin, solid and without smoothing, since
/// dashes cannot be seen and everything else costs time.
constexpr double kDenseWidths = 6;

struct Mapped {
  QList<QPointF> points;
  bool dense = false;
};

Mapped toPixels(const FrameCurve& curve, const AxisScale& x, const AxisScale& y, QSizeF size) {
  // Far outside the plot a line keeps its direction well enough, and the painter its precision.
  constexpr double kFar = 16;
  Mapped mapped;
  mapped.points.reserve(curve.points.size());
  double length = 0;
  for (const QPointF& point : curve.points) {
    const double unitX = x.toUnit(point.x());
    const double unitY = y.toUnit(point.y());
    if (!std::isfinite(unitX) || !std::isfinite(unitY)) continue;
    const QPointF pixel(std::clamp(unitX, -kFar, kFar) * size.width(),
                        std::clamp(unitY, -kFar, kFar) * size.height());
    if (!mapped.points.isEmpty()) length += std::abs(pixel.y() - mapped.points.last().y());
    mapped.points.append(pixel);
  }
  mapped.dense = length > kDenseWidths * size.width();
  return mapped;
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

void CurveLayer::setFrame(const ChartFrame& frame, QSizeF size, const ChartTheme& theme, qreal lineWidth) {
  impl_->resize(size);
  impl_->resizeSeries(frame.curves.size());
  impl_->smooth = true;
  for (std::size_t i = 0; i < frame.curves.size(); ++i) {
    const FrameCurve& curve = frame.curves[i];
    auto& pair = impl_->pairs[i];
    const Mapped mapped = toPixels(curve, frame.x.scale, frame.y[curve.axis].scale, size);
    if (mapped.dense) impl_->smooth = false;
    CurveStyle style = curve.style;
    if (mapped.dense) style.dash = 0;
    const QPen pen = curvePen(style, theme, mapped.dense ? 1 : lineWidth);
    if (pair.line->pen() != pen) pair.line->setPen(pen);
    if (!pair.line->points().isEmpty() || !mapped.points.isEmpty()) pair.line->replace(mapped.points);
    const bool marks = mapped.points.size() == 1 ||
                       (style.markers && mapped.points.size() <= kMostMarkers);
    impl_->setMarks(pair, marks ? mapped.points : QList<QPointF>(), theme.readable(style.color));
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
