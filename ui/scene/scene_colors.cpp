#include "ui/scene/scene_colors.h"

#include <algorithm>

namespace rotorbench {

Vec3f toVec3f(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

QColor toQColor(const Vec3f& color) {
  const auto bounded = [](float v) { return std::clamp(v, 0.0F, 1.0F); };
  return QColor::fromRgbF(bounded(color.x()), bounded(color.y()), bounded(color.z()));
}

Vec3f mix(const Vec3f& a, const Vec3f& b, float share) {
  return (1.0F - share) * a + share * b;
}

Vec3f lampDirection() {
  return Vec3f(-0.45F, 0.25F, 0.86F).normalized();
}

Vec3f lit(const Vec3f& color, const Vec3f& normal) {
  if (normal.squaredNorm() < 0.25F) return color;
  const float sky = 0.5F + 0.5F * normal.z();
  const float lamp = std::max(normal.dot(lampDirection()), 0.0F);
  return color * (0.42F + 0.26F * sky + 0.42F * lamp);
}

SceneColors sceneColors(const QPalette& palette) {
  SceneColors c;
  c.dark = palette.color(QPalette::Window).lightness() < 128;
  const Vec3f base = toVec3f(palette.color(QPalette::Base));
  const Vec3f window = toVec3f(palette.color(QPalette::Window));
  const Vec3f text = toVec3f(palette.color(QPalette::Text));
  const Vec3f ground = mix(base, window, 0.5F);
  c.background = toQColor(ground);
  c.text = palette.color(QPalette::Text);
  c.dimText = toQColor(mix(text, ground, 0.35F));
  c.notice = QColor(c.dark ? "#e69f00" : "#9a5b00");
  c.grid = mix(ground, text, c.dark ? 0.16F : 0.14F);
  c.gridMajor = mix(ground, text, c.dark ? 0.34F : 0.32F);
  c.shadow = mix(ground, Vec3f::Zero(), c.dark ? 0.35F : 0.14F);
  c.dropLine = mix(ground, text, 0.45F);
  const auto pick = [&](const char* onLight, const char* onDark) {
    return toVec3f(QColor(c.dark ? onDark : onLight));
  };
  c.frame = pick("#70777f", "#a9b1ba");
  c.hub = pick("#59616a", "#8b949e");
  c.frontArm = pick("#d55e00", "#f0762a");
  c.motor = pick("#3d434a", "#6d757e");
  c.blade = pick("#4a5159", "#c9d0d7");
  c.bladeTip = pick("#e69f00", "#f0b429");
  c.disc = mix(ground, text, 0.42F);
  c.thrust = pick("#009e73", "#1fc79a");
  c.trail = pick("#0072b2", "#56b4e9");
  c.setPoint = pick("#b8578f", "#e08cbd");
  c.wind = pick("#2f86bd", "#8fd0f5");
  c.axisX = pick("#c62f2f", "#ef5f5f");
  c.axisY = pick("#3d8b37", "#63b95c");
  c.axisZ = pick("#2a62c9", "#6f9bf0");
  return c;
}

}  // namespace rotorbench
