// Where the eye stands: orbit (fixed in the room, drifting after a vehicle that leaves the middle
// of the picture), chase (behind the vehicle, turning with its heading) and top (from above,
// forward is up). Inertial frame x forward, y left, z up; metres and radians. Both views draw
// through the same camera.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "sim/scene/scene_model.h"

namespace rotorbench {

enum class CameraMode { Orbit, Chase, Top };

/// A camera at rest: everything a renderer needs.
struct CameraView {
  Eigen::Vector3d eye, target, up;
  double verticalFov;  ///< rad
  double near, far;    ///< m along the line of sight

  [[nodiscard]] Eigen::Matrix4d viewProjection(double aspect) const;
};

/// A point in the picture: pixels from the top left corner, depth in m along the line of sight.
struct Projected {
  double x, y, depth;
};

/// Projects points into a picture of the given size; nothing for points nearer than the near plane.
class Projector {
 public:
  Projector(const CameraView& view, double width, double height);
  [[nodiscard]] std::optional<Projected> operator()(const Eigen::Vector3d& point) const;
  /// Pixels that one metre at this depth covers.
  [[nodiscard]] double scaleAt(double depth) const { return focal_ / depth; }

 private:
  Eigen::Vector3d eye_, right_, up_, forward_;
  double focal_, centreX_, centreY_, near_;
};

class SceneCamera {
 public:
  /// Default place for a vehicle of this size (radius of the sphere round it, m); `planar` looks
  /// square on at the y-z plane.
  void reset(double radius, bool planar);
  void setMode(CameraMode mode) { mode_ = mode; }
  [[nodiscard]] CameraMode mode() const { return mode_; }

  /// Turns the eye round the vehicle, rad; the top view only turns about the vertical.
  void turn(double azimuth, double elevation);
  /// Multiplies the distance; kept between touching the vehicle and losing it.
  void zoom(double factor);
  /// Puts the middle of the picture on this point.
  void centre(const Eigen::Vector3d& position) { anchor_ = position; }
  /// Lets the middle of the picture drift so that the vehicle stays within the inner part.
  void follow(const ScenePose& pose);

  /// `aspect` is width / height; tall pictures step back so that the vehicle still fits.
  [[nodiscard]] CameraView view(double aspect) const;

 private:
  struct Place {
    double azimuth, elevation, distance;
  };
  [[nodiscard]] Place& place() { return places_[static_cast<std::size_t>(mode_)]; }
  [[nodiscard]] const Place& place() const { return places_[static_cast<std::size_t>(mode_)]; }

  CameraMode mode_ = CameraMode::Orbit;
  std::array<Place, 3> places_{};
  double radius_ = 1;
  double heading_ = 0;
  Eigen::Vector3d anchor_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d vehicle_ = Eigen::Vector3d::Zero();
};

}  // namespace rotorbench
