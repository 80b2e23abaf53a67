// Renders a stage with Qt 3D into images: an engine without a window, four-fold multisampling,
// frames on demand only. Pictures come back to the event loop; one is under way at a time. Needs
// openGlWorks().
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <memory>

#include "ui/scene/scene_stage.h"

namespace rotorbench {

class Qt3dRenderer : public QObject {
  Q_OBJECT
 public:
  Qt3dRenderer();
  ~Qt3dRenderer() override;

  /// Replaces all entities.
  void setItems(const SceneStage& stage);
  /// Starts a picture of the stage as it is now, size in pixels. Precondition: not busy().
  void render(const SceneStage& stage, const QSize& size);
  [[nodiscard]] bool busy() const;

 signals:
  void imageReady(const QImage& image);

 private:
  void requestCapture();
  void takeCapture();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotorbench
