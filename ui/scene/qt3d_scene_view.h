// The 3D view by Qt 3D: pictures rendered without a window and painted into the widget, so that it
// docks, floats, grabs and carries writing like any other widget. The engine is made when the first
// picture is wanted. Needs openGlWorks().
#pragma once

#include <memory>

#include "ui/scene/scene_hud.h"
#include "ui/scene/scene_view.h"

namespace rotorbench {

class Qt3dRenderer;

class Qt3dSceneView final : public SceneView {
  Q_OBJECT
 public:
  explicit Qt3dSceneView(QWidget* parent);
  ~Qt3dSceneView() override;

  QImage renderToImage(const QSize& size) override;
  [[nodiscard]] QString rendererName() const override { return QStringLiteral("Qt 3D"); }

 protected:
  void itemsChanged() override;
  void presentFrame() override;
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt3dRenderer& renderer();
  void takeImage(const QImage& image);
  /// Runs the event loop until a picture is there or a few seconds have passed.
  void waitForImage();
  bool renderSnapshot(const QSize& size);

  std::unique_ptr<Qt3dRenderer> renderer_;
  QImage image_;
  SceneHud hud_;
  SceneHud nextHud_;  ///< of the picture under way
  QElapsedTimer rendering_;
  bool itemsStale_ = true;
  bool again_ = false;  ///< the stage moved while a picture was under way
  QImage snapshot_;
  bool wantsSnapshot_ = false;
};

}  // namespace rotorbench
