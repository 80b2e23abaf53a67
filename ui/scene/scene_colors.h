// The colours of a 3D scene for a light or a dark window. The hues are those of Okabe and Ito
// (2008), which people with colour-blindness tell apart; axes keep the customary red, green, blue.
#pragma once

#include <QColor>
#include <QPalette>

#include "ui/scene/scene_mesh.h"

namespace rotorbench {

struct SceneColors {
  QColor background, text, dimText, notice;
  Vec3f grid, gridMajor, shadow, dropLine;
  Vec3f frame, hub, frontArm, motor, blade, bladeTip, disc;
  Vec3f thrust, trail, setPoint, wind;
  Vec3f axisX, axisY, axisZ;
  bool dark = false;
};

SceneColors sceneColors(const QPalette& palette);
Vec3f toVec3f(const QColor& color);
QColor toQColor(const Vec3f& color);
/// (1 - share) a + share b.
Vec3f mix(const Vec3f& a, const Vec3f& b, float share);
/// How light falls on a surface with this outward normal (inertial frame): a sky above, a lamp high
/// on the left behind the default camera. A zero normal keeps its colour. The graphics card's
/// shader is the same.
Vec3f lit(const Vec3f& color, const Vec3f& normal);
/// Direction towards that lamp.
Vec3f lampDirection();

}  // namespace rotorbench
