// The writing over a 3D picture: time, altitude, camera, scale of the grid, a cross of axes,
// numbers at the grid lines. Computed with the camera of a picture and painted with that picture,
// so that the writing never runs ahead of a picture that takes a while to render.
#pragma once

#include <QPainter>
#include <QString>
#include <vector>

#include "ui/scene/scene_stage.h"

namespace rotorbench {

struct SceneHud {
  struct Label {
    QPointF place;  ///< middle of the text, pixels
    QString text;
    QColor color;
  };
  QString topLeft, topRight, bottomLeft;
  std::vector<Label> labels;
  /// The inertial axes as seen, for the small cross in the corner; empty if switched off. Unit
  /// lengths, farthest first.
  struct Axis {
    QPointF direction;
    QString letter;
    QColor color;
  };
  std::vector<Axis> axes;
};

QString cameraName(CameraMode mode);
/// Writing for a picture of this size in (device-independent) pixels.
SceneHud sceneHud(const SceneStage& stage, const QSizeF& size);
/// One sentence for screen readers: what the picture shows.
QString describeScene(const SceneStage& stage);
/// `notice` is a sentence along the lower edge, may be empty.
void paintHud(QPainter& painter, const QSizeF& size, const SceneHud& hud, const SceneColors& colors,
              const QString& notice);

}  // namespace rotorbench
