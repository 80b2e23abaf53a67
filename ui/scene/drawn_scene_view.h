// The 3D view without OpenGL: everything by QPainter, with a sentence saying so.
#pragma once

#include "ui/scene/scene_view.h"

namespace rotorbench {

class DrawnSceneView final : public SceneView {
  Q_OBJECT
 public:
  /// `notice`: why this view is used and what to do about it.
  DrawnSceneView(QString notice, QWidget* parent);

  QImage renderToImage(const QSize& size) override;
  [[nodiscard]] QString rendererName() const override { return QStringLiteral("drawn"); }

 protected:
  void itemsChanged() override {}
  void presentFrame() override;
  [[nodiscard]] QString notice() const override { return notice_; }
  void paintEvent(QPaintEvent* event) override;

 private:
  QString notice_;
};

/// Scene and writing by QPainter; without a model a sentence in the middle.
void paintStage(QPainter& painter, const QSizeF& size, const SceneStage& stage,
                const QString& notice);

}  // namespace rotorbench
