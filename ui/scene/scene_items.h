// The things a 3D scene is made of, without a renderer: a fixed list of named meshes per model
// (itemsOf) and, per instant, where each of them stands (placeItems). Both views are built from
// these two functions, so they show the same vehicle. Inertial frame, metres, radians.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "sim/scene/scene_model.h"
#include "ui/scene/scene_colors.h"
#include "ui/scene/scene_mesh.h"

namespace rotorbench {

/// What can be switched on and off in the picture.
struct SceneOptions {
  bool trail = true;
  bool thrust = true;
  bool grid = true;
  bool axes = true;
  bool setPoint = true;
  bool wind = true;
  bool writing = true;  ///< time, height, camera
  bool operator==(const SceneOptions&) const = default;
};

enum class ItemRole {
  Grid,
  Axes,
  Shadow,  ///< mesh changes every frame: shadowMesh()
  DropLine,
  Trail,  ///< mesh changes every frame, each view draws it its own way
  SetPoint,
  Hub,
  Nose,
  Arm,
  Motor,
  Disc,
  Blade,
  ThrustShaft,
  ThrustHead,
  WindShaft,
  WindHead,
};

/// `rotor` and `blade` count from 0 where they apply. Names: "rotor2.blade1" and the like, from 1.
struct SceneItem {
  ItemRole role;
  std::string name;
  Mesh mesh;
  std::size_t rotor = 0;
  int blade = 0;
};

/// Sizes that follow from the model.
struct SceneSize {
  double radius = 1;    ///< of the sphere round the vehicle, m
  double gridCell = 1;  ///< m: 1, 2 or 5 times a power of ten
  bool planar = false;  ///< all rotors in the y-z plane
};
SceneSize sceneSize(const SceneModel& model);

/// Cells of the ground grid to each side of its middle.
inline constexpr int kGridCells = 20;
/// Every how many lines one is darker and carries a number.
inline constexpr int kGridMajor = 5;

std::vector<SceneItem> itemsOf(const SceneModel& model, const SceneColors& colors,
                               MeshDetail detail);

/// Position, rotation and scale of a mesh in the inertial frame (scale first).
struct Placement {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  bool visible = true;
};

/// Where every item stands. `angles`: how far each rotor has turned about its axis as shown, rad.
std::vector<Placement> placeItems(const std::vector<SceneItem>& items, const SceneModel& model,
                                  const ScenePose& pose, const std::vector<double>& angles,
                                  const SceneOptions& options);

/// The vehicle's shadow on the ground, lit from straight above, in the inertial frame.
Mesh shadowMesh(const SceneModel& model, const ScenePose& pose, const SceneColors& colors);
/// Middle of the ground grid below this position, on a major line.
Eigen::Vector3d gridMiddle(const Eigen::Vector3d& position, double gridCell);
/// Hub of a rotor in the body frame: from the pose where arms bend, else from the model.
Eigen::Vector3d hubOf(const SceneModel& model, const ScenePose& pose, std::size_t rotor);
/// The wind's arrow: from upwind towards the vehicle, longer in stronger wind. No direction: none.
struct WindArrow {
  Eigen::Vector3d tail, direction = Eigen::Vector3d::Zero();
  double length = 0;  ///< m
  double speed = 0;   ///< m/s
};
WindArrow windArrow(const SceneModel& model, const ScenePose& pose);
/// Length of the thrust arrow in m, negative for negative thrust.
double arrowLength(const SceneModel& model, const ScenePose& pose, std::size_t rotor);

}  // namespace rotorbench
