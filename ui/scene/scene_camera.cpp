#include "ui/scene/scene_camera.h"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"

namespace rotorbench {
namespace {

constexpr double kFov = 34.0 * kDegree;
constexpr double kFlattest = -85.0 * kDegree;
constexpr double kSteepest = 88.0 * kDegree;
/// Distance in vehicle radii at which the vehicle fills a good part of the picture.
constexpr double kComfortable = 4.6;
/// Share of the half picture height in which the vehicle moves before the orbit camera follows.
constexpr double kFreeShare = 0.45;

}  // namespace

Eigen::Matrix4d CameraView::viewProjection(double aspect) const {
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  const Eigen::Vector3d top = right.cross(forward);
  Eigen::Matrix4d look = Eigen::Matrix4d::Identity();
  look.block<1, 3>(0, 0) = right.transpose();
  look.block<1, 3>(1, 0) = top.transpose();
  look.block<1, 3>(2, 0) = -forward.transpose();
  look.block<3, 1>(0, 3) = -look.block<3, 3>(0, 0) * eye;
  const double focal = 1.0 / std::tan(0.5 * verticalFov);
  Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
  lens(0, 0) = focal / aspect;
  lens(1, 1) = focal;
  lens(2, 2) = (far + near) / (near - far);
  lens(2, 3) = 2.0 * far * near / (near - far);
  lens(3, 2) = -1.0;
  return lens * look;
}

Projector::Projector(const CameraView& view, double width, double height)
    : eye_(view.eye),
      forward_((view.target - view.eye).normalized()),
      focal_(0.5 * height / std::tan(0.5 * view.verticalFov)),
      centreX_(0.5 * width),
      centreY_(0.5 * height),
      near_(view.near) {
  right_ = forward_.cross(view.up).normalized();
  up_ = right_.cross(forward_);
}

std::optional<Projected> Projector::operator()(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d from = point - eye_;
  const double depth = from.dot(forward_);
  if (!(depth > near_)) return std::nullopt;
  return Projected{centreX_ + focal_ * from.dot(right_) / depth,
                   centreY_ - focal_ * from.dot(up_) / depth, depth};
}

void SceneCamera::reset(double radius, bool planar) {
  radius_ = radius;
  const double distance = kComfortable * radius;
  places_[static_cast<std::size_t>(CameraMode::Orbit)] =
      planar ? Place{14.0 * kDegree, 12.0 * kDegree, distance}
             : Place{218.0 * kDegree, 26.0 * kDegree, distance};
  // Chase adds the heading: 180 degrees is behind the vehicle.
  places_[static_cast<std::size_t>(CameraMode::Chase)] = {180.0 * kDegree, 20.0 * kDegree,
                                                          distance};
  places_[static_cast<std::size_t>(CameraMode::Top)] = {180.0 * kDegree, 90.0 * kDegree,
                                                        1.15 * distance};
  anchor_ = vehicle_;
}

void SceneCamera::turn(double azimuth, double elevation) {
  place().azimuth = std::remainder(place().azimuth + azimuth, 2.0 * kPi);
  if (mode_ == CameraMode::Top) return;
  place().elevation = std::clamp(place().elevation + elevation, kFlattest, kSteepest);
}

void SceneCamera::zoom(double factor) {
  place().distance = std::clamp(place().distance * factor, 1.3 * radius_, 200.0 * radius_);
}

void SceneCamera::follow(const ScenePose& pose) {
  vehicle_ = pose.position;
  const Eigen::Vector3d ahead = pose.attitude * Eigen::Vector3d::UnitX();
  // Pitched straight up or down there is no heading; keep the last one.
  if (std::hypot(ahead.x(), ahead.y()) > 0.05) heading_ = std::atan2(ahead.y(), ahead.x());
  const double freeRadius = kFreeShare * place().distance * std::tan(0.5 * kFov);
  const Eigen::Vector3d offset = vehicle_ - anchor_;
  if (offset.norm() > freeRadius) anchor_ = vehicle_ - freeRadius * offset.normalized();
}

CameraView SceneCamera::view(double aspect) const {
  const Place& p = place();
  const double azimuth = p.azimuth + (mode_ == CameraMode::Chase ? heading_ : 0.0);
  const double distance = p.distance * std::max(1.0, 1.15 / std::max(aspect, 0.05));
  const Eigen::Vector3d outward(std::cos(p.elevation) * std::cos(azimuth),
                                std::cos(p.elevation) * std::sin(azimuth), std::sin(p.elevation));
  CameraView view;
  view.target = mode_ == CameraMode::Chase ? vehicle_ : anchor_;
  view.eye = view.target + distance * outward;
  // Derivative of `outward` by the elevation: defined in the top view too, where "up" is forward.
  view.up = {-std::sin(p.elevation) * std::cos(azimuth), -std::sin(p.elevation) * std::sin(azimuth),
             std::cos(p.elevation)};
  view.verticalFov = kFov;
  view.near = 0.02 * distance;
  view.far = distance + 400.0 * radius_;
  return view;
}

}  // namespace rotorbench
