#include "ui/scene/scene_painter.h"

#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <array>

namespace rotorbench {
namespace {

/// A triangle (three corners) or line (two) in the picture.
struct Primitive {
  std::array<QPointF, 3> corners;
  int count;
  double depth;
  QRgb color;
  double width;
};

class Sorter {
 public:
  Sorter(const CameraView& view, const QSizeF& size)
      : view_(view), project_(view, size.width(), size.height()) {}

  void addMesh(const Mesh& mesh, const Placement& place, double lineWidth) {
    if (!place.visible || mesh.indices.empty()) return;
    points_.clear();
    world_.clear();
    for (const Vec3f& p : mesh.positions) {
      world_.emplace_back(place.position +
                          place.rotation * place.scale.cwiseProduct(p.cast<double>()));
      points_.push_back(project_(world_.back()));
    }
    if (mesh.kind == Mesh::Kind::Lines) {
      addLines(mesh, lineWidth);
    } else {
      addTriangles(mesh, place);
    }
  }

  void addPath(const std::vector<Eigen::Vector3d>& path, const Vec3f& color, double width) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto a = project_(path[i]);
      const auto b = project_(path[i + 1]);
      if (a && b) addLine(*a, *b, color, width);
    }
  }

  void paint(QPainter& painter) {
    std::stable_sort(primitives_.begin(), primitives_.end(),
                     [](const Primitive& a, const Primitive& b) { return a.depth > b.depth; });
    for (const Primitive& p : primitives_) {
      const QColor color = QColor::fromRgb(p.color);
      // A hair-thin outline of the same colour closes the seams that antialiasing leaves.
      painter.setPen(QPen(color, p.width, Qt::SolidLine, Qt::RoundCap));
      if (p.count == 2) {
        painter.drawLine(p.corners[0], p.corners[1]);
      } else {
        painter.setBrush(color);
        painter.drawConvexPolygon(p.corners.data(), 3);
      }
    }
    primitives_.clear();
  }

 private:
  void addLine(const Projected& a, const Projected& b, const Vec3f& color, double width) {
    primitives_.push_back({{QPointF(a.x, a.y), QPointF(b.x, b.y), {}},
                           2,
                           0.5 * (a.depth + b.depth),
                           toQColor(color).rgb(),
                           width});
  }

  void addLines(const Mesh& mesh, double width) {
    for (std::size_t i = 0; i + 1 < mesh.indices.size(); i += 2) {
      const auto& a = points_[mesh.indices[i]];
      const auto& b = points_[mesh.indices[i + 1]];
      const Vec3f color = mix(mesh.colors[mesh.indices[i]], mesh.colors[mesh.indices[i + 1]], 0.5F);
      if (a && b) addLine(*a, *b, color, width);
    }
  }

  void addTriangles(const Mesh& mesh, const Placement& place) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const std::array<std::uint32_t, 3> k{mesh.indices[i], mesh.indices[i + 1],
                                           mesh.indices[i + 2]};
      const auto &a = points_[k[0]], &b = points_[k[1]], &c = points_[k[2]];
      if (!a || !b || !c) continue;
      const bool plain = mesh.normals[k[0]].squaredNorm() < 0.25F;
      const Eigen::Vector3d across =
          (world_[k[1]] - world_[k[0]]).cross(world_[k[2]] - world_[k[0]]);
      if (!plain && across.dot(view_.eye - world_[k[0]]) <= 0) continue;
      Vec3f normal = Vec3f::Zero();
      if (!plain) {
        const Vec3f local = mesh.normals[k[0]] + mesh.normals[k[1]] + mesh.normals[k[2]];
        const Eigen::Vector3d unscaled = local.cast<double>().cwiseQuotient(place.scale);
        normal = (place.rotation * unscaled).normalized().cast<float>();
      }
      primitives_.push_back({{QPointF(a->x, a->y), QPointF(b->x, b->y), QPointF(c->x, c->y)},
                             3,
                             (a->depth + b->depth + c->depth) / 3.0,
                             toQColor(lit(mesh.colors[k[0]], normal)).rgb(),
                             0.6});
    }
  }

  CameraView view_;
  Projector project_;
  std::vector<std::optional<Projected>> points_;
  std::vector<Eigen::Vector3d> world_;
  std::vector<Primitive> primitives_;
};

bool onGround(ItemRole role) {
  return role == ItemRole::Grid || role == ItemRole::Shadow;
}

}  // namespace

void paintScene(QPainter& painter, const QSizeF& size, const SceneStage& stage) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(0, 0), size), stage.colors().background);
  const CameraView view = stage.camera().view(size.width() / std::max(size.height(), 1.0));
  Sorter sorter(view, size);
  const std::vector<Placement> places = stage.placements();
  const auto paintGround = [&] {
    // The shadow first, the grid lines over it.
    for (const ItemRole role : {ItemRole::Shadow, ItemRole::Grid}) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const SceneItem& item = stage.items()[i];
        if (item.role != role) continue;
        sorter.addMesh(role == ItemRole::Shadow ? stage.shadow() : item.mesh, places[i], 1.0);
      }
      sorter.paint(painter);
    }
  };
  const auto paintBodies = [&] {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SceneItem& item = stage.items()[i];
      if (!onGround(item.role)) sorter.addMesh(item.mesh, places[i], 1.0);
    }
    sorter.addPath(stage.trail(), stage.colors().trail, 2.0);
    sorter.paint(painter);
  };
  // The ground is one sheet: behind everything for an eye above it that looks at what is above it.
  const bool groundInFront = (view.eye.z() > 0) != (stage.pose().position.z() >= -1e-6);
  if (groundInFront) paintBodies();
  paintGround();
  if (!groundInFront) paintBodies();
  painter.restore();
}

}  // namespace rotorbench
