#include "ui/scene/scene_items.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotorbench {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kShaft = 0.024;  // thickness of an arrow, of the arms' length

float toFloat(double v) {
  return static_cast<float>(v);
}

double niceStep(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= rough) return step * power;
  }
  return 10.0 * power;
}

/// Ground lines that fade into the background towards the edge.
Mesh gridMesh(double cell, const SceneColors& colors) {
  Mesh mesh;
  mesh.kind = Mesh::Kind::Lines;
  const Vec3f background = toVec3f(colors.background);
  const auto shade = [&](int i, int j, bool major) {
    const double r = std::hypot(i, j) / kGridCells;
    const float fade = toFloat(std::clamp(1.25 - 1.3 * r, 0.0, 1.0));
    return mix(background, major ? colors.gridMajor : colors.grid, fade);
  };
  for (int i = -kGridCells; i <= kGridCells; ++i) {
    const bool major = i % kGridMajor == 0;
    for (int j = -kGridCells; j < kGridCells; ++j) {
      if (std::min(std::hypot(i, j), std::hypot(i, j + 1)) > 0.97 * kGridCells) continue;
      const Vec3f a = toFloat(cell) * Vec3f(toFloat(i), toFloat(j), 0);
      const Vec3f b = toFloat(cell) * Vec3f(toFloat(i), toFloat(j + 1), 0);
      mesh.addLine(a, b, shade(i, j, major), shade(i, j + 1, major));
      mesh.addLine({a.y(), a.x(), 0}, {b.y(), b.x(), 0}, shade(i, j, major),
                   shade(i, j + 1, major));
    }
  }
  return mesh;
}

/// The inertial axes as lines from the origin, one major step of the grid long.
Mesh axesMesh(double length, const SceneColors& colors) {
  Mesh mesh;
  mesh.kind = Mesh::Kind::Lines;
  const float l = toFloat(length);
  mesh.addLine(Vec3f::Zero(), l * Vec3f::UnitX(), colors.axisX, colors.axisX);
  mesh.addLine(Vec3f::Zero(), l * Vec3f::UnitY(), colors.axisY, colors.axisY);
  mesh.addLine(Vec3f::Zero(), l * Vec3f::UnitZ(), colors.axisZ, colors.axisZ);
  return mesh;
}

/// Two crossing rings: where the vehicle ought to be.
Mesh setPointMesh(double radius, int sides, const Vec3f& color) {
  Mesh mesh = ringMesh(toFloat(radius), toFloat(0.035 * radius), 4 * sides, 6, color);
  Eigen::Isometry3f upright = Eigen::Isometry3f::Identity();
  upright.linear() = Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vec3f::UnitX()).matrix();
  mesh.append(ringMesh(toFloat(radius), toFloat(0.035 * radius), 4 * sides, 6, color), upright);
  return mesh;
}

bool isFront(const SceneModel& model, const SceneRotor& rotor) {
  double furthest = 0;
  for (const SceneRotor& r : model.rotors) furthest = std::max(furthest, r.position.x());
  return furthest > 1e-9 && rotor.position.x() > 0.8 * furthest;
}

double armSpan(const SceneModel& model) {
  double span = 0;
  for (const SceneRotor& rotor : model.rotors) span = std::max(span, rotor.position.norm());
  return span > 0 ? span : std::max(model.bodyRadius, 0.1);
}

void addRotor(std::vector<SceneItem>& items, const SceneModel& model, std::size_t index,
              const SceneColors& colors, MeshDetail detail) {
  const SceneRotor& rotor = model.rotors[index];
  const bool high = detail == MeshDetail::High;
  const int sides = high ? 20 : 10;
  const std::string name = "rotor" + std::to_string(index + 1) + ".";
  const double span = armSpan(model);
  const Vec3f arm = isFront(model, rotor) ? colors.frontArm : colors.frame;
  const float height = toFloat(rotor.motorHeight);
  const float radius = toFloat(rotor.motorRadius);
  // The arm stands on the body centre, length 1 along z; placeItems() stretches it to the hub.
  items.push_back({ItemRole::Arm, name + "arm",
                   frustumMesh(toFloat(0.05 * span), toFloat(0.032 * span), 0, 1, high ? 14 : 6,
                               arm, high ? 1 : 5),
                   index});
  Mesh motor = frustumMesh(radius, radius, -0.6F * height, 0.4F * height, sides, colors.motor);
  motor.append(frustumMesh(0.35F * radius, 0.2F * radius, 0.4F * height, 0.75F * height, sides / 2,
                           colors.frame));
  items.push_back({ItemRole::Motor, name + "motor", std::move(motor), index});
  items.push_back({ItemRole::Disc, name + "disc",
                   circleLines(toFloat(rotor.radius), high ? 72 : 40, colors.disc), index});
  for (int blade = 0; blade < rotor.blades; ++blade) {
    items.push_back(
        {ItemRole::Blade, name + "blade" + std::to_string(blade + 1),
         bladeMesh(rotor.stations, rotor.radius, rotor.spin, colors.blade, colors.bladeTip), index,
         blade});
  }
  const float shaft = toFloat(kShaft * span);
  items.push_back({ItemRole::ThrustShaft, name + "thrust.shaft",
                   frustumMesh(shaft, shaft, 0, 1, high ? 14 : 6, colors.thrust), index});
  items.push_back({ItemRole::ThrustHead, name + "thrust.head",
                   frustumMesh(2.6F * shaft, 0, 0, 7.0F * shaft, high ? 18 : 8, colors.thrust),
                   index});
}

/// Length of an arrow head drawn at full size, as built in addRotor() and itemsOf().
double headLength(const SceneModel& model) {
  return 7.0 * kShaft * armSpan(model);
}

Quaterniond alongZ(const Vector3d& direction) {
  return Quaterniond::FromTwoVectors(Vector3d::UnitZ(), direction);
}

Placement placeWind(ItemRole role, const SceneModel& model, const ScenePose& pose, bool wanted) {
  const WindArrow arrow = windArrow(model, pose);
  Placement p;
  p.visible = wanted && arrow.length > 0;
  if (!p.visible) return p;
  p.rotation = alongZ(arrow.direction);
  const double head = std::min(headLength(model), 0.6 * arrow.length);
  if (role == ItemRole::WindShaft) {
    p.position = arrow.tail;
    p.scale = {1, 1, arrow.length - head};
  } else {
    p.position = arrow.tail + (arrow.length - head) * arrow.direction;
    p.scale = Vector3d::Constant(head / headLength(model));
  }
  return p;
}

Placement placeVehiclePart(const SceneItem& item, const SceneModel& model, const ScenePose& pose,
                           const std::vector<double>& angles, const SceneOptions& options) {
  const SceneRotor& rotor = model.rotors[item.rotor];
  const Vector3d hub = hubOf(model, pose, item.rotor);
  const Quaterniond axis = pose.attitude * alongZ(rotor.axis);
  Placement p;
  p.position = pose.position + pose.attitude * hub;
  p.rotation = axis;
  // The propeller sits on top of the motor.
  const Vector3d mast = axis * Vector3d(0, 0, 0.55 * rotor.motorHeight);
  const double length = arrowLength(model, pose, item.rotor);
  const double head = std::min(headLength(model), 0.6 * std::abs(length));
  const bool shown = options.thrust && std::abs(length) > 1e-3 * armSpan(model);
  const Quaterniond flip = length < 0 ? alongZ(-Vector3d::UnitZ()) : Quaterniond::Identity();
  switch (item.role) {
    case ItemRole::Arm: {
      const double reach = hub.norm();
      p.position = pose.position;
      p.visible = reach > 1e-9;
      if (p.visible) p.rotation = pose.attitude * alongZ(hub);
      p.scale = {1, 1, std::max(reach, 1e-9)};
      break;
    }
    case ItemRole::Disc:
      p.position += mast;
      break;
    case ItemRole::Blade: {
      const double share = static_cast<double>(item.blade) / std::max(rotor.blades, 1);
      p.position += mast;
      p.rotation = axis * Eigen::AngleAxisd(angles[item.rotor] + 2 * std::numbers::pi * share,
                                            Vector3d::UnitZ());
      break;
    }
    case ItemRole::ThrustShaft:
      p.position += mast;
      p.rotation = axis * flip;
      p.visible = shown;
      p.scale = {1, 1, std::max(std::abs(length) - head, 1e-9)};
      break;
    case ItemRole::ThrustHead:
      p.position += mast + axis * Vector3d(0, 0, length - std::copysign(head, length));
      p.rotation = axis * flip;
      p.visible = shown;
      p.scale = Vector3d::Constant(std::max(head / headLength(model), 1e-9));
      break;
    default:
      break;
  }
  return p;
}

}  // namespace

SceneSize sceneSize(const SceneModel& model) {
  SceneSize size;
  double reach = model.bodyRadius;
  size.planar = model.rotors.size() > 1;
  for (const SceneRotor& rotor : model.rotors) {
    reach = std::max(reach, rotor.position.norm() + rotor.radius);
    if (std::abs(rotor.position.x()) > 1e-9) size.planar = false;
  }
  size.radius = reach > 0 ? reach : 1.0;
  size.gridCell = niceStep(0.3 * size.radius);
  return size;
}

std::vector<SceneItem> itemsOf(const SceneModel& model, const SceneColors& colors,
                               MeshDetail detail) {
  const SceneSize size = sceneSize(model);
  const int sides = detail == MeshDetail::High ? 24 : 12;
  std::vector<SceneItem> items;
  items.push_back({ItemRole::Grid, "grid", gridMesh(size.gridCell, colors)});
  items.push_back({ItemRole::Axes, "axes", axesMesh(kGridMajor * size.gridCell, colors)});
  items.push_back({ItemRole::Shadow, "shadow", {}});
  Mesh drop;
  drop.kind = Mesh::Kind::Lines;
  drop.addLine(Vec3f::Zero(), Vec3f::UnitZ(), colors.dropLine, colors.dropLine);
  items.push_back({ItemRole::DropLine, "dropLine", std::move(drop)});
  items.push_back({ItemRole::Trail, "trail", {}});
  items.push_back({ItemRole::SetPoint, "setPoint",
                   setPointMesh(0.22 * size.radius, sides / 2, colors.setPoint)});
  if (model.bodyRadius > 0) {
    items.push_back(
        {ItemRole::Hub, "hub", sphereMesh(toFloat(model.bodyRadius), sides, colors.hub)});
    if (!size.planar) {
      const float r = toFloat(model.bodyRadius);
      items.push_back(
          {ItemRole::Nose, "nose",
           frustumMesh(0.3F * r, 0.1F * r, 0.85F * r, 1.5F * r, sides, colors.frontArm)});
    }
  }
  for (std::size_t i = 0; i < model.rotors.size(); ++i) addRotor(items, model, i, colors, detail);
  if (!model.onStand) {
    const float shaft = toFloat(kShaft * armSpan(model));
    items.push_back({ItemRole::WindShaft, "wind.shaft",
                     frustumMesh(shaft, shaft, 0, 1, sides / 2, colors.wind)});
    items.push_back({ItemRole::WindHead, "wind.head",
                     frustumMesh(2.6F * shaft, 0, 0, 7.0F * shaft, sides / 2, colors.wind)});
  }
  return items;
}

std::vector<Placement> placeItems(const std::vector<SceneItem>& items, const SceneModel& model,
                                  const ScenePose& pose, const std::vector<double>& angles,
                                  const SceneOptions& options) {
  const SceneSize size = sceneSize(model);
  std::vector<Placement> places;
  places.reserve(items.size());
  for (const SceneItem& item : items) {
    Placement p;
    switch (item.role) {
      case ItemRole::Grid:
        p.position = gridMiddle(pose.position, size.gridCell);
        p.visible = options.grid;
        break;
      case ItemRole::Axes:
        // A hair over the grid lines that run along the same places.
        p.position.z() = 1e-3 * size.radius;
        p.visible = options.axes;
        break;
      case ItemRole::Shadow:
        // A vehicle that fell through the ground (a birotor without one) casts none on it.
        p.visible = options.grid && pose.position.z() > -0.02 * size.radius;
        break;
      case ItemRole::DropLine:
        p.position = {pose.position.x(), pose.position.y(), 0};
        p.scale.z() = std::abs(pose.position.z()) > 1e-9 ? pose.position.z() : 1e-9;
        p.visible = options.grid;
        break;
      case ItemRole::Trail:
        p.visible = options.trail;
        break;
      case ItemRole::SetPoint:
        p.position = pose.setPoint.value_or(Vector3d::Zero());
        p.visible = options.setPoint && pose.setPoint && pose.setPoint->allFinite();
        break;
      case ItemRole::WindShaft:
      case ItemRole::WindHead:
        p = placeWind(item.role, model, pose, options.wind);
        break;
      case ItemRole::Hub:
        p.position = pose.position;
        p.rotation = pose.attitude;
        p.scale.z() = 0.6;
        break;
      case ItemRole::Nose:
        p.position = pose.position;
        p.rotation = pose.attitude * alongZ(Vector3d::UnitX());
        break;
      default:
        p = placeVehiclePart(item, model, pose, angles, options);
    }
    places.push_back(p);
  }
  return places;
}

Mesh shadowMesh(const SceneModel& model, const ScenePose& pose, const SceneColors& colors) {
  constexpr int kSegments = 28;
  Mesh mesh;
  // Just under the ground plane, so that the grid lines stay visible on it.
  const float z = toFloat(-2e-3 * sceneSize(model).radius);
  const auto flat = [&](const Vector3d& body) {
    const Vector3d p = pose.position + pose.attitude * body;
    return mesh.addVertex({toFloat(p.x()), toFloat(p.y()), z}, Vec3f::Zero(), colors.shadow);
  };
  const auto disc = [&](const Vector3d& centre, const Quaterniond& axis, double radius) {
    const std::uint32_t middle = flat(centre);
    for (int i = 0; i < kSegments; ++i) {
      const double a = 2 * std::numbers::pi * i / kSegments;
      flat(centre + axis * Vector3d(radius * std::cos(a), radius * std::sin(a), 0));
    }
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      mesh.indices.insert(mesh.indices.end(),
                          {middle, middle + 1 + i, middle + 1 + (i + 1) % kSegments});
    }
  };
  if (model.bodyRadius > 0) disc(Vector3d::Zero(), Quaterniond::Identity(), model.bodyRadius);
  for (std::size_t i = 0; i < model.rotors.size(); ++i) {
    const Vector3d hub = hubOf(model, pose, i);
    disc(hub, alongZ(model.rotors[i].axis), model.rotors[i].radius);
    const Vector3d side =
        0.05 * armSpan(model) * hub.cross(model.rotors[i].axis).stableNormalized();
    const std::uint32_t a = flat(side);
    flat(hub + side);
    flat(hub - side);
    flat(-side);
    mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 2, a, a + 2, a + 3});
  }
  return mesh;
}

Vector3d gridMiddle(const Vector3d& position, double gridCell) {
  const double step = gridCell * kGridMajor;
  return {step * std::round(position.x() / step), step * std::round(position.y() / step), 0};
}

Vector3d hubOf(const SceneModel& model, const ScenePose& pose, std::size_t rotor) {
  if (model.elasticArms && rotor < pose.hubs.size()) return pose.hubs[rotor];
  return model.rotors[rotor].position;
}

WindArrow windArrow(const SceneModel& model, const ScenePose& pose) {
  constexpr double kFull = 10;  // m/s for an arrow as long as the vehicle is wide
  WindArrow arrow;
  const Vector3d wind = pose.wind.value_or(model.wind.value_or(Vector3d::Zero()));
  const double speed = wind.norm();
  if (!(speed > 1e-3) || !std::isfinite(speed)) return arrow;
  const double radius = sceneSize(model).radius;
  arrow.speed = speed;
  arrow.direction = wind / speed;
  arrow.length = 2 * radius * std::clamp(speed / kFull, 0.2, 2.0);
  arrow.tail = pose.position - (1.2 * radius + arrow.length) * arrow.direction;
  return arrow;
}

double arrowLength(const SceneModel& model, const ScenePose& pose, std::size_t rotor) {
  if (rotor >= pose.rotorThrust.size() || !std::isfinite(pose.rotorThrust[rotor])) return 0;
  const double share = pose.rotorThrust[rotor] / std::max(model.fullThrust, 1e-12);
  return std::clamp(share, -1.5, 1.5) * 1.1 * armSpan(model);
}

}  // namespace rotorbench
