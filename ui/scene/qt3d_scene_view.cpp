#include "ui/scene/qt3d_scene_view.h"

#include <QEventLoop>
#include <QPainter>

#include "ui/scene/drawn_scene_view.h"
#include "ui/scene/qt3d_renderer.h"

namespace rotorbench {
namespace {

/// A picture takes some 20 ms; a driver that needs longer than this is broken.
constexpr int kPatienceMs = 5000;

}  // namespace

Qt3dSceneView::Qt3dSceneView(QWidget* parent) : SceneView(MeshDetail::High, parent) {}

Qt3dSceneView::~Qt3dSceneView() = default;

Qt3dRenderer& Qt3dSceneView::renderer() {
  if (!renderer_) {
    renderer_ = std::make_unique<Qt3dRenderer>();
    connect(renderer_.get(), &Qt3dRenderer::imageReady, this, &Qt3dSceneView::takeImage);
  }
  if (itemsStale_) {
    renderer_->setItems(stage());
    itemsStale_ = false;
  }
  return *renderer_;
}

void Qt3dSceneView::itemsChanged() {
  itemsStale_ = true;
}

void Qt3dSceneView::presentFrame() {
  if (!stage().model()) {
    image_ = {};
    update();
    emit frameRendered();
    return;
  }
  if (renderer_ && renderer_->busy()) {
    again_ = true;
    return;
  }
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  if (pixels.isEmpty()) return;
  nextHud_ = sceneHud(stage(), size());
  rendering_.start();
  renderer().render(stage(), pixels);
}

void Qt3dSceneView::takeImage(const QImage& image) {
  if (wantsSnapshot_) {
    snapshot_ = image;
    wantsSnapshot_ = false;
  } else {
    tookToRender(rendering_.elapsed());
    image_ = image;
    hud_ = nextHud_;
    update();
    if (stage().model()) emit frameRendered();
  }
  if (again_) {
    again_ = false;
    requestFrame();
  }
}

void Qt3dSceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!stage().model() || image_.isNull()) {
    // Until the first picture is there (a moment at the start) the drawn one stands in.
    paintStage(painter, size(), stage(), {});
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != size());
  painter.drawImage(rect(), image_);
  paintHud(painter, size(), hud_, stage().colors(), {});
}

void Qt3dSceneView::waitForImage() {
  QEventLoop loop;
  connect(renderer_.get(), &Qt3dRenderer::imageReady, &loop, &QEventLoop::quit);
  QTimer::singleShot(kPatienceMs, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
}

bool Qt3dSceneView::renderSnapshot(const QSize& size) {
  if (!stage().model()) return false;
  if (renderer().busy()) waitForImage();
  if (renderer().busy()) return false;
  wantsSnapshot_ = true;
  renderer().render(stage(), size);
  waitForImage();
  const bool rendered = !wantsSnapshot_;
  wantsSnapshot_ = false;
  return rendered;
}

QImage Qt3dSceneView::renderToImage(const QSize& size) {
  if (size.isEmpty()) return {};
  const bool rendered = renderSnapshot(size);
  QImage picture(size, QImage::Format_RGB32);
  QPainter painter(&picture);
  painter.setFont(font());
  if (!rendered) {
    paintStage(painter, size, stage(), {});
    return picture;
  }
  painter.drawImage(picture.rect(), snapshot_);
  paintHud(painter, size, sceneHud(stage(), size), stage().colors(), {});
  snapshot_ = {};
  return picture;
}

}  // namespace rotorbench
