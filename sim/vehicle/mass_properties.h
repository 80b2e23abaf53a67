// Mass, centre of mass and inertia of a rigid vehicle. Body axes: x forward, y left, z up;
// positions in m from the origin of the body frame (the centre of the rotor layout), inertia about
// the actual centre of mass.
//   I = sum m_k (|d|^2 1 - d d^T) + (2/5) m r_s^2 1         (thesis 2014 (3.7)-(3.9), yz entries
//   corrected)
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/schema.h"

namespace rotorbench {

/// Entries of the inertia tensor in kg m^2; off the diagonal they are -integral(x y dm) and so on.
struct InertiaTensor {
  double xx = 0.0190, yy = 0.0190, zz = 0.0252, xy = 0, xz = 0, yz = 0;
  [[nodiscard]] Eigen::Matrix3d matrix() const;
  bool operator==(const InertiaTensor&) const = default;
};

/// The whole vehicle as measured, rotors included, payloads and deviations not. Defaults: DJI F450.
struct DirectMass {
  double mass = 1.4;                                       ///< kg
  Eigen::Vector3d centreOfMass = Eigen::Vector3d::Zero();  ///< m
  InertiaTensor inertia;                                   ///< about the centre of mass
  bool operator==(const DirectMass&) const = default;
};

/// A solid sphere in the middle and a point mass at each hub (RotorParameters::mass).
struct PartsMass {
  double bodyMass = 1.18;    ///< kg
  double bodyRadius = 0.09;  ///< m
  Eigen::Vector3d bodyPosition = Eigen::Vector3d::Zero();
  bool operator==(const PartsMass&) const = default;
};

using MassModel = std::variant<DirectMass, PartsMass>;

struct PointMass {
  double mass = 0.1;                                   ///< kg
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m, body frame
  bool operator==(const PointMass&) const = default;
};

struct MassProperties {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about `centre`
};

/// Joins a point mass (negative to take one away) by the parallel-axis theorem; total mass must
/// stay positive.
MassProperties withPointMass(const MassProperties& body, double mass,
                             const Eigen::Vector3d& position);

/// Why the properties cannot belong to a real body: mass not positive, inertia not positive
/// definite, or one principal moment above the sum of the others: a warning up to 2 %, which
/// rounding makes of a flat body. `path` leads the problems' paths.
std::vector<Problem> massProblems(const MassProperties& properties, const std::string& path);

template <>
struct Describe<InertiaTensor> {
  static void fields(schema::Builder<InertiaTensor>& b);
};
template <>
struct Describe<DirectMass> {
  static void fields(schema::Builder<DirectMass>& b);
};
template <>
struct Describe<PartsMass> {
  static void fields(schema::Builder<PartsMass>& b);
};
template <>
struct Describe<PointMass> {
  static void fields(schema::Builder<PointMass>& b);
};

}  // namespace rotorbench
