// Draws a stage with QPainter alone: flat-shaded, sorted back to front. The picture where there is
// no OpenGL.
#pragma once

#include <QPainter>

#include "ui/scene/scene_stage.h"

namespace rotorbench {

/// Fills the rectangle from (0, 0) of this size with background and scene, without the writing.
void paintScene(QPainter& painter, const QSizeF& size, const SceneStage& stage);

}  // namespace rotorbench
