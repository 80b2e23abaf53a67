#include "ui/scene/qt3d_renderer.h"

#include <QOffscreenSurface>
#include <QSurfaceFormat>
#include <Qt3DCore/QAspectEngine>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QMultiSampleAntiAliasing>
#include <Qt3DRender/QRenderAspect>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderStateSet>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QViewport>
#include <utility>

#include "ui/scene/scene_graph.h"

namespace rotorbench {
namespace {

constexpr int kSamples = 4;
/// How often an empty picture is asked for again after the entities were replaced.
constexpr int kWarmUpFrames = 8;

bool isEmpty(const QImage& image, const QColor& background) {
  constexpr int kStep = 3;
  for (int y = 0; y < image.height(); y += kStep) {
    for (int x = 0; x < image.width(); x += kStep) {
      if ((image.pixel(x, y) & 0xffffffU) != (background.rgb() & 0xffffffU)) return false;
    }
  }
  return true;
}

/// Adds a multisampled texture to the target.
Qt3DRender::QAbstractTexture* attach(Qt3DRender::QRenderTarget* target,
                                     Qt3DRender::QRenderTargetOutput::AttachmentPoint point,
                                     Qt3DRender::QAbstractTexture::TextureFormat format) {
  auto* output = new Qt3DRender::QRenderTargetOutput(target);
  output->setAttachmentPoint(point);
  auto* texture = new Qt3DRender::QTexture2DMultisample(output);
  texture->setSamples(kSamples);
  texture->setFormat(format);
  texture->setGenerateMipMaps(false);
  texture->setSize(16, 16);
  output->setTexture(texture);
  target->addOutput(output);
  return texture;
}

}  // namespace

struct Qt3dRenderer::Parts {
  QOffscreenSurface surface;
  std::unique_ptr<Qt3DCore::QAspectEngine> engine;
  Qt3DCore::QEntityPtr root;
  Qt3DRender::QRenderSurfaceSelector* surfaceSelector = nullptr;
  Qt3DRender::QAbstractTexture* colorTexture = nullptr;
  Qt3DRender::QAbstractTexture* depthTexture = nullptr;
  Qt3DRender::QClearBuffers* clear = nullptr;
  Qt3DRender::QCamera* camera = nullptr;
  Qt3DRender::QRenderCapture* capture = nullptr;
  Qt3DRender::QRenderCaptureReply* reply = nullptr;
  SceneGraph graph;
  QSize size;
  QColor background;
  int warmUp = 0;

  Parts();
  ~Parts();
  void buildFrameGraph();
  void resize(const QSize& wanted);
};

Qt3dRenderer::Parts::Parts() {
  surface.setFormat(QSurfaceFormat::defaultFormat());
  surface.create();
  engine = std::make_unique<Qt3DCore::QAspectEngine>();
  engine->registerAspect(new Qt3DRender::QRenderAspect(Qt3DRender::QRenderAspect::Automatic));
  root.reset(new Qt3DCore::QEntity);
  camera = new Qt3DRender::QCamera(root.get());
  buildFrameGraph();
  auto* settings = new Qt3DRender::QRenderSettings(root.get());
  settings->setRenderPolicy(Qt3DRender::QRenderSettings::OnDemand);
  settings->setActiveFrameGraph(surfaceSelector);
  root->addComponent(settings);
  engine->setRootEntity(root);
}

Qt3dRenderer::Parts::~Parts() {
  // Scene, then engine, then surface: the render thread must let go before its surface goes.
  engine->setRootEntity({});
  root.reset();
  engine.reset();
  surface.destroy();
}

void Qt3dRenderer::Parts::buildFrameGraph() {
  surfaceSelector = new Qt3DRender::QRenderSurfaceSelector(root.get());
  surfaceSelector->setSurface(&surface);
  auto* target = new Qt3DRender::QRenderTarget(root.get());
  using Output = Qt3DRender::QRenderTargetOutput;
  using Texture = Qt3DRender::QAbstractTexture;
  colorTexture = attach(target, Output::Color0, Texture::RGBA8_UNorm);
  depthTexture = attach(target, Output::DepthStencil, Texture::D24S8);
  auto* selector = new Qt3DRender::QRenderTargetSelector(surfaceSelector);
  selector->setTarget(target);
  auto* viewport = new Qt3DRender::QViewport(selector);
  auto* states = new Qt3DRender::QRenderStateSet(viewport);
  auto* depth = new Qt3DRender::QDepthTest(states);
  depth->setDepthFunction(Qt3DRender::QDepthTest::LessOrEqual);
  states->addRenderState(depth);
  states->addRenderState(new Qt3DRender::QMultiSampleAntiAliasing(states));
  clear = new Qt3DRender::QClearBuffers(states);
  clear->setBuffers(Qt3DRender::QClearBuffers::ColorDepthBuffer);
  auto* cameraSelector = new Qt3DRender::QCameraSelector(clear);
  cameraSelector->setCamera(camera);
  // Resolves the samples while reading back.
  capture = new Qt3DRender::QRenderCapture(cameraSelector);
}

void Qt3dRenderer::Parts::resize(const QSize& wanted) {
  if (size == wanted) return;
  size = wanted;
  surfaceSelector->setExternalRenderTargetSize(size);
  colorTexture->setSize(size.width(), size.height());
  depthTexture->setSize(size.width(), size.height());
}

Qt3dRenderer::Qt3dRenderer() : parts_(std::make_unique<Parts>()) {}

Qt3dRenderer::~Qt3dRenderer() = default;

void Qt3dRenderer::setItems(const SceneStage& stage) {
  delete parts_->graph.root.data();
  parts_->graph = buildSceneGraph(stage.items(), parts_->root.get());
  parts_->warmUp = kWarmUpFrames;
}

bool Qt3dRenderer::busy() const {
  return parts_->reply != nullptr;
}

void Qt3dRenderer::render(const SceneStage& stage, const QSize& size) {
  parts_->resize(size);
  parts_->background = stage.colors().background;
  parts_->clear->setClearColor(parts_->background);
  const double aspect = static_cast<double>(size.width()) / size.height();
  updateCamera(*parts_->camera, stage.camera().view(aspect), aspect);
  updateSceneGraph(parts_->graph, stage);
  requestCapture();
}

void Qt3dRenderer::requestCapture() {
  parts_->reply = parts_->capture->requestCapture();
  connect(parts_->reply, &Qt3DRender::QRenderCaptureReply::completed, this,
          &Qt3dRenderer::takeCapture);
}

void Qt3dRenderer::takeCapture() {
  Qt3DRender::QRenderCaptureReply* reply = std::exchange(parts_->reply, nullptr);
  const QImage image = reply->image();
  reply->deleteLater();
  // New entities need a frame or two until shaders and buffers are loaded; an empty picture is not
  // shown.
  if (parts_->warmUp > 0) {
    const bool first = parts_->warmUp == kWarmUpFrames;
    --parts_->warmUp;
    if (first || isEmpty(image, parts_->background)) {
      requestCapture();
      return;
    }
    parts_->warmUp = 0;
  }
  emit imageReady(image);
}

}  // namespace rotorbench
