// The 3D view of a vehicle: an abstract widget with camera and switches, drawn either by Qt 3D or,
// where no OpenGL context can be made, by QPainter. createSceneView() chooses. GUI thread only;
// reads published rows.
//
// Mouse: drag turns, wheel zooms, double click resets. Keys: arrows turn, + and - zoom, Home
// resets, Space asks for play or pause.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "ui/scene/scene_stage.h"

namespace rotorbench {

class SceneView : public QWidget {
  Q_OBJECT
 public:
  SceneView(MeshDetail detail, QWidget* parent);

  /// Empty: a sentence instead of a vehicle.
  void setModel(std::optional<SceneModel> model);
  void setRecording(std::shared_ptr<const Recording> recording);
  /// Time in s; also call it again when the recording has grown.
  void setTime(double time);
  void setCameraMode(CameraMode mode);
  void resetCamera();
  /// Below 1: closer.
  void zoom(double factor);
  void setOptions(const SceneOptions& options);

  [[nodiscard]] double time() const { return stage_.time(); }
  [[nodiscard]] CameraMode cameraMode() const { return stage_.camera().mode(); }
  [[nodiscard]] SceneOptions options() const { return stage_.options(); }
  [[nodiscard]] const SceneStage& stage() const { return stage_; }

  /// The picture at this size in pixels, with its writing; waits until it is there. Works hidden.
  virtual QImage renderToImage(const QSize& size) = 0;
  /// "Qt 3D" or "drawn".
  [[nodiscard]] virtual QString rendererName() const = 0;

  [[nodiscard]] QSize sizeHint() const override { return {640, 420}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  /// A picture of the present time is on the widget.
  void frameRendered();
  void cameraModeChanged(CameraMode mode);
  void playPauseRequested();

 protected:
  /// The list of items is another one (model or colours).
  virtual void itemsChanged() = 0;
  /// Bring the picture up to date; called at most 30 times a second and only while visible.
  virtual void presentFrame() = 0;
  /// A sentence shown along the lower edge and told to screen readers, may be empty.
  [[nodiscard]] virtual QString notice() const { return {}; }
  void requestFrame();
  /// How long the last picture took, ms. The view leaves room for others when that is long.
  void tookToRender(qint64 milliseconds) { renderMs_ = milliseconds; }

  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void present();
  void updateColors();

  SceneStage stage_;
  QTimer frameTimer_;
  QElapsedTimer sinceFrame_;
  qint64 renderMs_ = 0;
  bool frameWanted_ = true;
  QPointF lastDrag_;
};

/// Qt 3D if an OpenGL 3.3 context can be made, else the drawn view. ROTORBENCH_SCENE=drawn or =qt3d
/// in the environment asks for one of them; qt3d without OpenGL still gives the drawn view.
SceneView* createSceneView(QWidget* parent);

}  // namespace rotorbench
