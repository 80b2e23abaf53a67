// A stage as a Qt 3D scene graph: one entity per item, made once per model; per frame only
// transforms, switches and the two changing meshes are written. Pure construction: needs no engine,
// so tests can count.
#pragma once

#include <QPointer>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QGeometryRenderer>
#include <vector>

#include "ui/scene/scene_stage.h"

namespace rotorbench {

/// The entities of one model. Owned by the parent entity given to buildSceneGraph().
struct SceneGraph {
  struct Node {
    Qt3DCore::QEntity* entity;
    Qt3DCore::QTransform* transform;
    Qt3DRender::QGeometryRenderer* renderer;
  };
  QPointer<Qt3DCore::QEntity> root;
  std::vector<Node> nodes;  ///< in the order of the stage's items, objectName = item name
};

SceneGraph buildSceneGraph(const std::vector<SceneItem>& items, Qt3DCore::QEntity* parent);
/// Moves everything to where the stage has it.
void updateSceneGraph(SceneGraph& graph, const SceneStage& stage);
void updateCamera(Qt3DRender::QCamera& camera, const CameraView& view, double aspect);

}  // namespace rotorbench
