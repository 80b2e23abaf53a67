// Triangle and line meshes of a 3D scene, and the solids they are put together from. Nothing here
// knows a renderer: the Qt 3D view uploads these meshes, the drawn view projects them. Metres;
// every solid stands on its own z axis. Outward normals; a zero normal marks what is drawn in its
// plain colour, without light.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/scene/scene_model.h"

namespace rotorbench {

using Vec3f = Eigen::Vector3f;

struct Mesh {
  enum class Kind { Triangles, Lines };
  Kind kind = Kind::Triangles;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;  ///< one per position, unit length, or zero for "no light"
  std::vector<Vec3f> colors;   ///< one per position, red, green, blue in 0..1
  std::vector<std::uint32_t> indices;

  std::uint32_t addVertex(const Vec3f& position, const Vec3f& normal, const Vec3f& color);
  /// Flat-shaded quad, corners counter-clockwise seen from outside.
  void addQuad(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, const Vec3f& color);
  void addTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& color);
  /// Line without light (Kind::Lines only).
  void addLine(const Vec3f& a, const Vec3f& b, const Vec3f& colorA, const Vec3f& colorB);
  /// Adds another mesh of the same kind, moved.
  void append(const Mesh& other, const Eigen::Isometry3f& move = Eigen::Isometry3f::Identity());
};

/// How finely round things are cut: High for the graphics card, Low for the painter.
enum class MeshDetail { Low, High };

/// Circular frustum from z0 (radius0) to z1 (radius1) with both caps. `pieces` cuts a long one
/// across, so that the painter can sort its parts by depth.
Mesh frustumMesh(float radius0, float radius1, float z0, float z1, int sides, const Vec3f& color,
                 int pieces = 1);
Mesh sphereMesh(float radius, int sides, const Vec3f& color);
Mesh ringMesh(float radius, float tube, int segments, int sides, const Vec3f& color);
/// Circle in the x-y plane as lines.
Mesh circleLines(float radius, int segments, const Vec3f& color);
/// Tube of the given radius along a polyline; empty with fewer than two different points.
Mesh tubeMesh(std::span<const Eigen::Vector3d> path, float radius, int sides, const Vec3f& color);

/// Points on the section outline of bladeMesh, in this order around every station.
enum BladePoint { kLeadingEdge, kUpperCrest, kTrailingEdge, kLowerCrest, kBladePoints };

/// One blade along +x in the rotor frame (z = thrust axis): a twisted surface through the stations
/// with the quarter-chord line on x, the leading edge towards spin * (+y) and raised by the twist.
/// `tip` colours the outer tenth. With fewer than two stations a plain blade of `radius` is drawn.
Mesh bladeMesh(std::span<const DrawnStation> stations, double radius, double spin,
               const Vec3f& color, const Vec3f& tip);
/// Outline point of one station, rotor frame, m.
Vec3f bladePoint(const DrawnStation& station, double spin, BladePoint point);

}  // namespace rotorbench
