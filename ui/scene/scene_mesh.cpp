#include "ui/scene/scene_mesh.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rotorbench {
namespace {

constexpr float kWholeTurn = 2.0F * std::numbers::pi_v<float>;

Vec3f onCircle(float radius, int step, int steps, float z) {
  const float angle = kWholeTurn * static_cast<float>(step) / static_cast<float>(steps);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

void addCap(Mesh& mesh, float radius, float z, bool up, int sides, const Vec3f& color) {
  if (radius <= 0) return;
  const Vec3f normal(0, 0, up ? 1.0F : -1.0F);
  const std::uint32_t centre = mesh.addVertex({0, 0, z}, normal, color);
  for (int i = 0; i < sides; ++i) mesh.addVertex(onCircle(radius, i, sides, z), normal, color);
  for (int i = 0; i < sides; ++i) {
    const auto a = centre + 1 + static_cast<std::uint32_t>(i);
    const auto b = centre + 1 + static_cast<std::uint32_t>((i + 1) % sides);
    mesh.indices.insert(mesh.indices.end(), {centre, up ? a : b, up ? b : a});
  }
}

/// Two triangles between corresponding edges of neighbouring vertex rings.
void stitch(Mesh& mesh, std::uint32_t ring0, std::uint32_t ring1, int sides) {
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<std::uint32_t>(i);
    const auto b = static_cast<std::uint32_t>((i + 1) % sides);
    mesh.indices.insert(mesh.indices.end(), {ring0 + a, ring0 + b, ring1 + b});
    mesh.indices.insert(mesh.indices.end(), {ring0 + a, ring1 + b, ring1 + a});
  }
}

}  // namespace

std::uint32_t Mesh::addVertex(const Vec3f& position, const Vec3f& normal, const Vec3f& color) {
  positions.push_back(position);
  normals.push_back(normal);
  colors.push_back(color);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void Mesh::addQuad(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d,
                   const Vec3f& color) {
  const Vec3f normal = (c - a).cross(d - b).stableNormalized();
  const std::uint32_t first = addVertex(a, normal, color);
  addVertex(b, normal, color);
  addVertex(c, normal, color);
  addVertex(d, normal, color);
  indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

void Mesh::addTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& color) {
  const Vec3f normal = (b - a).cross(c - a).stableNormalized();
  const std::uint32_t first = addVertex(a, normal, color);
  addVertex(b, normal, color);
  addVertex(c, normal, color);
  indices.insert(indices.end(), {first, first + 1, first + 2});
}

void Mesh::addLine(const Vec3f& a, const Vec3f& b, const Vec3f& colorA, const Vec3f& colorB) {
  const std::uint32_t first = addVertex(a, Vec3f::Zero(), colorA);
  addVertex(b, Vec3f::Zero(), colorB);
  indices.insert(indices.end(), {first, first + 1});
}

void Mesh::append(const Mesh& other, const Eigen::Isometry3f& move) {
  const auto offset = static_cast<std::uint32_t>(positions.size());
  for (const Vec3f& p : other.positions) positions.emplace_back(move * p);
  for (const Vec3f& n : other.normals) normals.emplace_back(move.linear() * n);
  colors.insert(colors.end(), other.colors.begin(), other.colors.end());
  for (const std::uint32_t i : other.indices) indices.push_back(i + offset);
}

Mesh frustumMesh(float radius0, float radius1, float z0, float z1, int sides, const Vec3f& color,
                 int pieces) {
  Mesh mesh;
  const float slope = (radius0 - radius1) / (z1 - z0);
  for (int piece = 0; piece <= pieces; ++piece) {
    const float share = static_cast<float>(piece) / static_cast<float>(pieces);
    for (int i = 0; i < sides; ++i) {
      Vec3f normal = onCircle(1.0F, i, sides, 0);
      normal.z() = slope;
      const float radius = std::lerp(radius0, radius1, share);
      mesh.addVertex(onCircle(radius, i, sides, std::lerp(z0, z1, share)), normal.normalized(),
                     color);
    }
  }
  for (int piece = 0; piece < pieces; ++piece) {
    stitch(mesh, static_cast<std::uint32_t>(piece * sides),
           static_cast<std::uint32_t>((piece + 1) * sides), sides);
  }
  addCap(mesh, radius0, z0, false, sides, color);
  addCap(mesh, radius1, z1, true, sides, color);
  return mesh;
}

Mesh sphereMesh(float radius, int sides, const Vec3f& color) {
  Mesh mesh;
  const int rings = sides / 2;
  for (int r = 0; r <= rings; ++r) {
    const float latitude =
        kWholeTurn * (static_cast<float>(r) / static_cast<float>(rings) - 0.5F) / 2;
    for (int i = 0; i < sides; ++i) {
      const Vec3f normal = onCircle(std::cos(latitude), i, sides, std::sin(latitude));
      mesh.addVertex(radius * normal, normal, color);
    }
  }
  for (int r = 0; r < rings; ++r) {
    stitch(mesh, static_cast<std::uint32_t>(r * sides), static_cast<std::uint32_t>((r + 1) * sides),
           sides);
  }
  return mesh;
}

Mesh ringMesh(float radius, float tube, int segments, int sides, const Vec3f& color) {
  Mesh mesh;
  for (int s = 0; s < segments; ++s) {
    const Vec3f outward = onCircle(1.0F, s, segments, 0);
    for (int i = 0; i < sides; ++i) {
      const Vec3f local = onCircle(1.0F, i, sides, 0);
      const Vec3f normal = local.x() * outward - local.y() * Vec3f::UnitZ();
      mesh.addVertex(radius * outward + tube * normal, normal, color);
    }
  }
  for (int s = 0; s < segments; ++s) {
    stitch(mesh, static_cast<std::uint32_t>(s * sides),
           static_cast<std::uint32_t>(((s + 1) % segments) * sides), sides);
  }
  return mesh;
}

Mesh circleLines(float radius, int segments, const Vec3f& color) {
  Mesh mesh;
  mesh.kind = Mesh::Kind::Lines;
  for (int s = 0; s < segments; ++s) {
    mesh.addLine(onCircle(radius, s, segments, 0), onCircle(radius, s + 1, segments, 0), color,
                 color);
  }
  return mesh;
}

Mesh tubeMesh(std::span<const Eigen::Vector3d> path, float radius, int sides, const Vec3f& color) {
  std::vector<Vec3f> points;
  for (const Eigen::Vector3d& p : path) {
    const Vec3f point = p.cast<float>();
    if (points.empty() || (point - points.back()).norm() > 0.2F * radius) points.push_back(point);
  }
  Mesh mesh;
  if (points.size() < 2) return mesh;
  Vec3f side = Vec3f::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3f along =
        (points[std::min(k + 1, points.size() - 1)] - points[k > 0 ? k - 1 : 0]).stableNormalized();
    // Carry the frame along the path so that the tube does not twist.
    side -= side.dot(along) * along;
    if (side.norm() < 1e-3F) side = along.unitOrthogonal();
    side.normalize();
    const Vec3f other = along.cross(side);
    for (int i = 0; i < sides; ++i) {
      const Vec3f local = onCircle(1.0F, i, sides, 0);
      const Vec3f normal = local.x() * side + local.y() * other;
      mesh.addVertex(points[k] + radius * normal, normal, color);
    }
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    stitch(mesh, static_cast<std::uint32_t>(k) * static_cast<std::uint32_t>(sides),
           static_cast<std::uint32_t>(k + 1) * static_cast<std::uint32_t>(sides), sides);
  }
  return mesh;
}

Vec3f bladePoint(const DrawnStation& station, double spin, BladePoint point) {
  // Share of the chord behind the quarter-chord line, and height over the chord line: a lens with
  // its crest at 30 % of the chord, 9 % thick above and 4 % below.
  struct Outline {
    double ahead, above;
  };
  constexpr std::array<Outline, kBladePoints> kOutline{
      {{0.25, 0.0}, {-0.05, 0.09}, {-0.75, 0.0}, {-0.05, -0.04}}};
  const Outline& o = kOutline[point];
  const double c = std::cos(station.twist);
  const double s = std::sin(station.twist);
  const double y = station.chord * (o.ahead * c - o.above * s);
  const double z = station.chord * (o.ahead * s + o.above * c);
  return Eigen::Vector3d(station.radius, spin * y, z).cast<float>();
}

Mesh bladeMesh(std::span<const DrawnStation> stations, double radius, double spin,
               const Vec3f& color, const Vec3f& tip) {
  const std::array<DrawnStation, 2> plain{
      {{0.1 * radius, 0.12 * radius, 0.3}, {radius, 0.07 * radius, 0.15}}};
  const std::span<const DrawnStation> used =
      stations.size() < 2 ? std::span<const DrawnStation>(plain) : stations;
  const double direction = spin < 0 ? -1.0 : 1.0;
  const double tipStart = 0.88 * used.back().radius;
  Mesh mesh;
  const auto corner = [&](std::size_t i, int k) {
    return bladePoint(used[i], direction, static_cast<BladePoint>(k % kBladePoints));
  };
  // The outline of a mirrored blade runs the other way round; outside must stay outside.
  const auto face = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d,
                        const Vec3f& shade) {
    if (direction > 0) {
      mesh.addQuad(a, b, c, d, shade);
    } else {
      mesh.addQuad(d, c, b, a, shade);
    }
  };
  for (std::size_t i = 0; i + 1 < used.size(); ++i) {
    const Vec3f& shade = 0.5 * (used[i].radius + used[i + 1].radius) > tipStart ? tip : color;
    for (int k = 0; k < kBladePoints; ++k) {
      face(corner(i, k), corner(i, k + 1), corner(i + 1, k + 1), corner(i + 1, k), shade);
    }
  }
  const std::size_t last = used.size() - 1;
  face(corner(last, 0), corner(last, 1), corner(last, 2), corner(last, 3), tip);
  face(corner(0, 3), corner(0, 2), corner(0, 1), corner(0, 0), color);
  return mesh;
}

}  // namespace rotorbench
