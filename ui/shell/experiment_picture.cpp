#include "ui/shell/experiment_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "sim/core/error.h"
#include "sim/scene/scene_model.h"
#include "ui/scene/scene_painter.h"

namespace rotorbench {

namespace {

std::optional<SceneModel> vehicleOf(const Experiment& experiment) {
  try {
    return sceneModel(experiment);
  } catch (const InputError&) {
    return std::nullopt;  // a vehicle that cannot be built has no picture; the form says why
  }
}

/// Axes and a decaying step response.
void paintChart(QPainter& painter, const QSizeF& size, const QPalette& palette) {
  painter.fillRect(QRectF({}, size), palette.color(QPalette::Base));
  const QRectF area = QRectF({}, size).adjusted(24, 18, -18, -20);
  painter.setPen(QPen(palette.color(QPalette::Mid), 1));
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  QPainterPath curve;
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0;
    const double y = 1 - std::exp(-5 * t) * std::cos(6 * std::numbers::pi * t);
    const QPointF point(area.left() + t * area.width(), area.bottom() - 0.6 * y * area.height());
    i == 0 ? curve.moveTo(point) : curve.lineTo(point);
  }
  painter.setPen(QPen(palette.color(QPalette::Highlight), 2));
  painter.drawPath(curve);
}

}  // namespace

QImage experimentPicture(const Experiment& experiment, const QSize& size, qreal scale,
                         const QPalette& palette) {
  QImage image(size * scale, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(scale);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  if (auto model = vehicleOf(experiment)) {
    SceneStage stage(MeshDetail::Low);
    stage.setColors(sceneColors(palette));
    stage.setModel(std::move(model));
    stage.resetCamera();
    stage.camera().zoom(0.75);
    paintScene(painter, size, stage);
  } else {
    paintChart(painter, size, palette);
  }
  return image;
}

}  // namespace rotorbench
