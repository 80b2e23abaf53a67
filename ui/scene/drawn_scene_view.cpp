#include "ui/scene/drawn_scene_view.h"

#include <QPainter>

#include "ui/scene/scene_hud.h"
#include "ui/scene/scene_painter.h"

namespace rotorbench {

void paintStage(QPainter& painter, const QSizeF& size, const SceneStage& stage,
                const QString& notice) {
  if (!stage.model()) {
    painter.fillRect(QRectF(QPointF(0, 0), size), stage.colors().background);
    painter.setPen(stage.colors().dimText);
    painter.drawText(QRectF(QPointF(0, 0), size), Qt::AlignCenter | Qt::TextWordWrap,
                     describeScene(stage));
    return;
  }
  paintScene(painter, size, stage);
  paintHud(painter, size, sceneHud(stage, size), stage.colors(), notice);
}

DrawnSceneView::DrawnSceneView(QString notice, QWidget* parent)
    : SceneView(MeshDetail::Low, parent), notice_(std::move(notice)) {
  setAccessibleDescription(notice_);
}

QImage DrawnSceneView::renderToImage(const QSize& size) {
  if (size.isEmpty()) return {};
  QImage image(size, QImage::Format_RGB32);
  QPainter painter(&image);
  painter.setFont(font());
  paintStage(painter, size, stage(), {});
  return image;
}

void DrawnSceneView::presentFrame() {
  update();
  emit frameRendered();
}

void DrawnSceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintStage(painter, size(), stage(), notice_);
}

}  // namespace rotorbench
