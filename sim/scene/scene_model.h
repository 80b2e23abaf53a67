// What a 3D view needs to draw a vehicle and move it, derived from an Experiment and a Recording;
// the window draws it and computes no physics. Inertial frame: x forward, y left, z up; body frame
// FLU; metres, radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/recording.h"

namespace rotorbench {

struct Experiment;

/// A blade section: radius and chord in m, twist against the rotor plane in rad.
struct DrawnStation {
  double radius, chord, twist;
};

struct SceneRotor {
  Eigen::Vector3d position;  ///< hub in the body frame
  Eigen::Vector3d axis;      ///< thrust direction in the body frame, unit length
  double spin;  ///< +1 counter-clockwise seen against `axis` (from above), -1 clockwise
  double radius;
  int blades;
  std::vector<DrawnStation> stations;  ///< root to tip
  double motorRadius, motorHeight;
};

/// A vehicle: a body sphere and rotors at the ends of arms. A birotor is the same with two rotors,
/// in the inertial y-z plane. `body` radius 0 draws no hub.
struct SceneModel {
  std::string title;
  double bodyRadius = 0;
  std::vector<SceneRotor> rotors;
  bool elasticArms = false;             ///< hubs move in the body frame: take them from the pose
  double fullThrust = 1;                ///< N, scales the thrust arrows
  std::optional<Eigen::Vector3d> wind;  ///< m/s at the start, where the air moves
  bool onStand = false;                 ///< stays where it is: one rotor that turns
};

/// Everything that moves, at one instant.
struct ScenePose {
  double time = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< body to inertial
  std::vector<double>
      rotorSpeed;  ///< rad/s, not signed by the spin; the view turns the rotors with it
  std::vector<double> rotorThrust;    ///< N along the rotor axis
  std::vector<Eigen::Vector3d> hubs;  ///< body frame, only with elasticArms
  std::optional<Eigen::Vector3d> setPoint;
  std::optional<Eigen::Vector3d> wind;  ///< m/s of the air over the ground, where it moves
};

/// The drawing of the experiment's vehicle; empty if the experiment has none.
std::optional<SceneModel> sceneModel(const Experiment& experiment);

/// Reads poses out of a recording by channel names; made once per recording.
class PoseReader {
 public:
  PoseReader(const SceneModel& model, const Recording& recording);
  /// False if the recording has no channels to place the vehicle.
  [[nodiscard]] bool valid() const { return valid_; }
  /// The pose at time t (the last sample not after t). Any thread.
  [[nodiscard]] ScenePose at(double t) const;
  /// Positions of the centre from t0 to t1 in at most `count` points.
  [[nodiscard]] std::vector<Eigen::Vector3d> trail(double t0, double t1, std::size_t count) const;

 private:
  const Recording* recording_;
  bool valid_ = false;
  bool planar_ = false;
  bool onStand_ = false;
  std::vector<std::size_t> position_, attitude_, setPoint_, speed_, thrust_, hub_, wind_;
};

}  // namespace rotorbench
