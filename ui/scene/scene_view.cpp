#include "ui/scene/scene_view.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <numbers>

#include "ui/scene/drawn_scene_view.h"
#include "ui/scene/opengl_probe.h"
#include "ui/scene/qt3d_scene_view.h"
#include "ui/scene/scene_hud.h"

namespace rotorbench {
namespace {

constexpr int kFrameMs = 33;
constexpr double kDragTurn = 0.008;  // rad per pixel
constexpr double kKeyTurn = std::numbers::pi / 36;

}  // namespace

SceneView::SceneView(MeshDetail detail, QWidget* parent) : QWidget(parent), stage_(detail) {
  setObjectName(QStringLiteral("sceneView"));
  setAccessibleName(tr("3D view"));
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setToolTip(tr("Drag or arrow keys turn, wheel or + and - zoom, double click or Home resets."));
  frameTimer_.setSingleShot(true);
  connect(&frameTimer_, &QTimer::timeout, this, &SceneView::present);
  stage_.setColors(sceneColors(palette()));
}

void SceneView::setModel(std::optional<SceneModel> model) {
  stage_.setModel(std::move(model));
  itemsChanged();
  requestFrame();
}

void SceneView::setRecording(std::shared_ptr<const Recording> recording) {
  stage_.setRecording(std::move(recording));
  requestFrame();
}

void SceneView::setTime(double time) {
  stage_.setTime(time);
  requestFrame();
}

void SceneView::setCameraMode(CameraMode mode) {
  if (mode == cameraMode()) return;
  stage_.camera().setMode(mode);
  emit cameraModeChanged(mode);
  requestFrame();
}

void SceneView::resetCamera() {
  stage_.resetCamera();
  requestFrame();
}

void SceneView::setOptions(const SceneOptions& options) {
  stage_.setOptions(options);
  requestFrame();
}

void SceneView::requestFrame() {
  frameWanted_ = true;
  if (!isVisible() || frameTimer_.isActive()) return;
  // A software renderer takes long for large pictures; a third of the time stays free for the
  // simulation.
  const qint64 interval = std::max<qint64>(kFrameMs, renderMs_ * 3 / 2);
  const qint64 waited = sinceFrame_.isValid() ? sinceFrame_.elapsed() : interval;
  frameTimer_.start(static_cast<int>(std::clamp<qint64>(interval - waited, 0, interval)));
}

void SceneView::present() {
  if (!frameWanted_ || !isVisible()) return;
  frameWanted_ = false;
  sinceFrame_.restart();
  const QString said = notice().isEmpty() ? describeScene(stage_)
                                          : notice() + QLatin1Char(' ') + describeScene(stage_);
  setAccessibleDescription(said);
  presentFrame();
}

void SceneView::updateColors() {
  stage_.setColors(sceneColors(palette()));
  itemsChanged();
  requestFrame();
}

void SceneView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  requestFrame();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  requestFrame();
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) updateColors();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  lastDrag_ = event->position();
  event->accept();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & (Qt::LeftButton | Qt::RightButton | Qt::MiddleButton))) return;
  const QPointF moved = event->position() - lastDrag_;
  lastDrag_ = event->position();
  stage_.camera().turn(-kDragTurn * moved.x(), kDragTurn * moved.y());
  requestFrame();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  resetCamera();
  event->accept();
}

void SceneView::zoom(double factor) {
  stage_.camera().zoom(factor);
  requestFrame();
}

void SceneView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(0.85, event->angleDelta().y() / 120.0));
  event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  SceneCamera& camera = stage_.camera();
  switch (event->key()) {
    case Qt::Key_Left:
      camera.turn(-kKeyTurn, 0);
      break;
    case Qt::Key_Right:
      camera.turn(kKeyTurn, 0);
      break;
    case Qt::Key_Up:
      camera.turn(0, kKeyTurn);
      break;
    case Qt::Key_Down:
      camera.turn(0, -kKeyTurn);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera.zoom(0.85);
      break;
    case Qt::Key_Minus:
      camera.zoom(1.0 / 0.85);
      break;
    case Qt::Key_Home:
      resetCamera();
      break;
    case Qt::Key_Space:
      emit playPauseRequested();
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  requestFrame();
}

SceneView* createSceneView(QWidget* parent) {
  const QByteArray wish = qgetenv("ROTORBENCH_SCENE");
  if (wish == "drawn")
    return new DrawnSceneView(DrawnSceneView::tr("Drawn view, as asked for by ROTORBENCH_SCENE."),
                              parent);
  if (openGlWorks()) return new Qt3dSceneView(parent);
  return new DrawnSceneView(
      DrawnSceneView::tr("OpenGL is not available, so the view is drawn without it. Install the "
                         "graphics driver (package libgl1-mesa-dri) and start again for the full "
                         "picture."),
      parent);
}

}  // namespace rotorbench
