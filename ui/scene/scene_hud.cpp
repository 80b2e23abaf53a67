#include "ui/scene/scene_hud.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace rotorbench {
namespace {

constexpr double kMargin = 10;

QString tr(const char* text) {
  return QCoreApplication::translate("SceneHud", text);
}

QString number(double value, int decimals) {
  // Locale numbers with a true minus and no "-0.00".
  const double shown = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  return QLocale().toString(shown, 'f', decimals);
}

void addAxes(SceneHud& hud, const SceneStage& stage, const CameraView& view) {
  const Eigen::Vector3d forward = (view.target - view.eye).normalized();
  const Eigen::Vector3d right = forward.cross(view.up).normalized();
  const Eigen::Vector3d up = right.cross(forward);
  const SceneColors& c = stage.colors();
  const std::pair<const char*, Vec3f> axes[] = {{"x", c.axisX}, {"y", c.axisY}, {"z", c.axisZ}};
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return forward[a] > forward[b]; });
  for (const int i : order) {
    const auto& [letter, color] = axes[i];
    hud.axes.push_back({{right[i], -up[i]}, letter, toQColor(color)});
  }
}

/// Numbers along the two major grid lines nearest to the vehicle.
void addGridNumbers(SceneHud& hud, const SceneStage& stage, const Projector& project) {
  const double step = stage.size().gridCell * kGridMajor;
  const Eigen::Vector3d middle = gridMiddle(stage.pose().position, stage.size().gridCell);
  const int decimals = step < 0.1 ? 2 : step < 1 ? 1 : 0;
  for (int axis = 0; axis < 2; ++axis) {
    for (int k = -3; k <= 3; ++k) {
      Eigen::Vector3d p = middle;
      p[axis] += k * step;
      const auto at = project(p);
      if (!at || project.scaleAt(at->depth) * step < 60) continue;
      const QString name = axis == 0 ? QStringLiteral("x") : QStringLiteral("y");
      if (k == 0 && axis == 1) continue;
      hud.labels.push_back({{at->x, at->y},
                            name + QLatin1Char(' ') + number(p[axis], decimals),
                            stage.colors().dimText});
    }
  }
}

/// The speed of the wind above its arrow.
void addWind(SceneHud& hud, const SceneStage& stage, const Projector& project) {
  const WindArrow arrow = windArrow(*stage.model(), stage.pose());
  if (!(arrow.length > 0)) return;
  const Eigen::Vector3d middle = arrow.tail + 0.5 * arrow.length * arrow.direction;
  const auto at = project(middle + Eigen::Vector3d(0, 0, 0.2 * stage.size().radius));
  if (!at) return;
  hud.labels.push_back({{at->x, at->y},
                        tr("wind %1 m/s").arg(number(arrow.speed, 1)),
                        toQColor(stage.colors().wind)});
}

/// The corners belong to the fixed writing.
bool inCorner(const QRectF& place, const QRectF& area) {
  const bool high = place.top() < area.top() + 40;
  const bool low = place.bottom() > area.bottom() - 40;
  const bool aside = place.left() < area.left() + 110 || place.right() > area.right() - 90;
  return (high || low) && aside;
}

void paintAxes(QPainter& painter, const QRectF& area, const SceneHud& hud) {
  constexpr double kArm = 24;
  const QPointF centre = area.bottomRight() - QPointF(kArm + 12, kArm + 12);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const SceneHud::Axis& axis : hud.axes) {
    painter.setPen(QPen(axis.color, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(centre, centre + kArm * axis.direction);
    const QPointF at = centre + (kArm + 8) * axis.direction;
    painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, axis.letter);
  }
}

}  // namespace

QString cameraName(CameraMode mode) {
  switch (mode) {
    case CameraMode::Orbit:
      return tr("Orbit");
    case CameraMode::Chase:
      return tr("Chase");
    case CameraMode::Top:
      return tr("Top");
  }
  return {};
}

SceneHud sceneHud(const SceneStage& stage, const QSizeF& size) {
  SceneHud hud;
  if (!stage.model() || !stage.options().writing) return hud;
  const CameraView view = stage.camera().view(size.width() / std::max(size.height(), 1.0));
  const Projector project(view, size.width(), size.height());
  if (stage.flies()) {
    hud.topLeft = tr("t  %1 s").arg(number(stage.time(), 2)) + QLatin1Char('\n') +
                  tr("z  %1 m").arg(number(stage.pose().position.z(), 2));
  } else {
    hud.topLeft = tr("Run the experiment to see it move.");
  }
  hud.topRight = cameraName(stage.camera().mode());
  if (stage.options().grid) {
    const double cell = stage.size().gridCell;
    hud.bottomLeft = tr("Grid %1 m").arg(number(cell, cell < 0.1 ? 2 : cell < 1 ? 1 : 0));
    addGridNumbers(hud, stage, project);
  }
  if (stage.options().axes) addAxes(hud, stage, view);
  if (stage.options().setPoint && stage.pose().setPoint && stage.pose().setPoint->allFinite()) {
    const Eigen::Vector3d beside =
        *stage.pose().setPoint + Eigen::Vector3d(0, 0, 0.34 * stage.size().radius);
    if (const auto at = project(beside)) {
      hud.labels.push_back({{at->x, at->y}, tr("set-point"), toQColor(stage.colors().setPoint)});
    }
  }
  if (stage.options().wind) addWind(hud, stage, project);
  return hud;
}

QString describeScene(const SceneStage& stage) {
  if (!stage.model()) return tr("This experiment has no vehicle to show.");
  if (!stage.flies()) return tr("The vehicle at rest. Run the experiment to see it move.");
  const Eigen::Vector3d& p = stage.pose().position;
  return tr("Time %1 s, position x %2 m, y %3 m, z %4 m, %5 camera.")
      .arg(number(stage.time(), 2), number(p.x(), 2), number(p.y(), 2), number(p.z(), 2),
           cameraName(stage.camera().mode()).toLower());
}

void paintHud(QPainter& painter, const QSizeF& size, const SceneHud& hud, const SceneColors& colors,
              const QString& notice) {
  painter.save();
  const QRectF area = QRectF(QPointF(0, 0), size).adjusted(kMargin, kMargin, -kMargin, -kMargin);
  const QFont font = painter.font();
  QFont small = font;
  small.setPointSizeF(std::max(6.5, 0.85 * font.pointSizeF()));
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  for (const SceneHud::Label& label : hud.labels) {
    const QSizeF box(metrics.horizontalAdvance(label.text) + 2, metrics.height());
    const QRectF place(label.place - QPointF(box.width() / 2, box.height() / 2), box);
    if (!area.contains(place) || inCorner(place, area)) continue;
    painter.setPen(label.color);
    painter.drawText(place, Qt::AlignCenter, label.text);
  }
  paintAxes(painter, area, hud);
  painter.setPen(colors.dimText);
  painter.drawText(area, Qt::AlignRight | Qt::AlignTop, hud.topRight);
  QRectF bottom = area;
  if (!notice.isEmpty()) {
    const int flags = Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap;
    const QRectF place = area.adjusted(0, 0, hud.axes.empty() ? 0 : -80, 0);
    const QRectF used = painter.boundingRect(place, flags, notice);
    painter.setPen(colors.notice);
    painter.drawText(place, flags, notice);
    bottom.setBottom(used.top() - 4);
  }
  painter.setPen(colors.dimText);
  painter.drawText(bottom, Qt::AlignLeft | Qt::AlignBottom, hud.bottomLeft);
  painter.setFont(font);
  painter.setPen(colors.text);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, hud.topLeft);
  painter.restore();
}

}  // namespace rotorbench
