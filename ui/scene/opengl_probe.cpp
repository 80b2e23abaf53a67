#include "ui/scene/opengl_probe.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace rotorbench {
namespace {

bool probe() {
  setSceneSurfaceFormat();
  QOpenGLContext context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  if (!context.create()) return false;
  // A surface says it is valid even where no context can use it; only makeCurrent() tells.
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return false;
  const bool recent = context.format().version() >= std::pair(3, 3);
  context.doneCurrent();
  return recent && !context.isOpenGLES();
}

}  // namespace

void setSceneSurfaceFormat() {
  QSurfaceFormat format = QSurfaceFormat::defaultFormat();
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  QSurfaceFormat::setDefaultFormat(format);
}

bool openGlWorks() {
  static const bool works = probe();
  return works;
}

}  // namespace rotorbench
