#include "ui/scene/scene_graph.h"

#include <QVector3D>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>
#include <array>
#include <cstring>
#include <numbers>

namespace rotorbench {
namespace {

constexpr int kTrailSides = 6;

constexpr const char* kVertexShader = R"(#version 330 core
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec3 vertexColor;
out vec3 normal;
out vec3 color;
uniform mat4 mvp;
uniform mat4 modelMatrix;
void main() {
  // Rotation times scale: dividing by the squared length of each column gives the inverse
  // transpose.
  mat3 m = mat3(modelMatrix);
  vec3 s = vec3(dot(m[0], m[0]), dot(m[1], m[1]), dot(m[2], m[2]));
  normal = m * (vertexNormal / max(s, vec3(1e-12)));
  color = vertexColor;
  gl_Position = mvp * vec4(vertexPosition, 1.0);
}
)";

// The same light as lit() in scene_colors.cpp.
constexpr const char* kFragmentShader = R"(#version 330 core
in vec3 normal;
in vec3 color;
out vec4 fragColor;
uniform vec3 lamp;
void main() {
  float strength = 1.0;
  if (dot(normal, normal) > 0.0) {
    vec3 n = normalize(normal);
    strength = 0.42 + 0.26 * (0.5 + 0.5 * n.z) + 0.42 * max(dot(n, lamp), 0.0);
  }
  fragColor = vec4(color * strength, 1.0);
}
)";

Qt3DRender::QMaterial* makeMaterial(Qt3DCore::QNode* parent) {
  auto* material = new Qt3DRender::QMaterial(parent);
  auto* effect = new Qt3DRender::QEffect(material);
  auto* technique = new Qt3DRender::QTechnique(effect);
  auto* api = technique->graphicsApiFilter();
  api->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
  api->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
  api->setMajorVersion(3);
  api->setMinorVersion(3);
  auto* pass = new Qt3DRender::QRenderPass(technique);
  auto* program = new Qt3DRender::QShaderProgram(pass);
  program->setVertexShaderCode(kVertexShader);
  program->setFragmentShaderCode(kFragmentShader);
  pass->setShaderProgram(program);
  auto* culling = new Qt3DRender::QCullFace(pass);
  culling->setMode(Qt3DRender::QCullFace::NoCulling);
  pass->addRenderState(culling);
  technique->addRenderPass(pass);
  effect->addTechnique(technique);
  material->setEffect(effect);
  const Vec3f lamp = lampDirection();
  material->addParameter(new Qt3DRender::QParameter(
      QStringLiteral("lamp"), QVector3D(lamp.x(), lamp.y(), lamp.z()), material));
  return material;
}

/// Position, normal and colour interleaved, 9 floats a vertex.
QByteArray vertexBytes(const Mesh& mesh) {
  QByteArray bytes(static_cast<qsizetype>(mesh.positions.size() * 9 * sizeof(float)),
                   Qt::Uninitialized);
  char* out = bytes.data();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (const Vec3f* v : {&mesh.positions[i], &mesh.normals[i], &mesh.colors[i]}) {
      std::memcpy(out, v->data(), 3 * sizeof(float));
      out += 3 * sizeof(float);
    }
  }
  return bytes;
}

Qt3DCore::QAttribute* makeAttribute(Qt3DCore::QBuffer* buffer, const QString& name, uint offset,
                                    Qt3DCore::QNode* parent) {
  auto* attribute = new Qt3DCore::QAttribute(parent);
  attribute->setName(name);
  attribute->setBuffer(buffer);
  attribute->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
  attribute->setVertexBaseType(Qt3DCore::QAttribute::Float);
  attribute->setVertexSize(3);
  attribute->setByteOffset(offset * static_cast<uint>(sizeof(float)));
  attribute->setByteStride(9 * sizeof(float));
  return attribute;
}

Qt3DCore::QGeometry* makeGeometry(Qt3DCore::QNode* parent) {
  auto* geometry = new Qt3DCore::QGeometry(parent);
  auto* vertices = new Qt3DCore::QBuffer(geometry);
  auto* indices = new Qt3DCore::QBuffer(geometry);
  using Qt3DCore::QAttribute;
  geometry->addAttribute(
      makeAttribute(vertices, QAttribute::defaultPositionAttributeName(), 0, geometry));
  geometry->addAttribute(
      makeAttribute(vertices, QAttribute::defaultNormalAttributeName(), 3, geometry));
  geometry->addAttribute(
      makeAttribute(vertices, QAttribute::defaultColorAttributeName(), 6, geometry));
  auto* index = new QAttribute(geometry);
  index->setBuffer(indices);
  index->setAttributeType(QAttribute::IndexAttribute);
  index->setVertexBaseType(QAttribute::UnsignedInt);
  geometry->addAttribute(index);
  return geometry;
}

/// Writes a mesh into a geometry made by makeGeometry().
void setMesh(Qt3DRender::QGeometryRenderer& renderer, const Mesh& mesh) {
  const auto attributes = renderer.geometry()->attributes();
  for (qsizetype i = 0; i < 3; ++i)
    attributes[i]->setCount(static_cast<uint>(mesh.positions.size()));
  attributes[3]->setCount(static_cast<uint>(mesh.indices.size()));
  attributes[0]->buffer()->setData(vertexBytes(mesh));
  attributes[3]->buffer()->setData(
      QByteArray(reinterpret_cast<const char*>(mesh.indices.data()),
                 static_cast<qsizetype>(mesh.indices.size() * sizeof(std::uint32_t))));
  renderer.setVertexCount(static_cast<int>(mesh.indices.size()));
  renderer.setPrimitiveType(mesh.kind == Mesh::Kind::Lines
                                ? Qt3DRender::QGeometryRenderer::Lines
                                : Qt3DRender::QGeometryRenderer::Triangles);
}

QVector3D toQVector(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

SceneGraph buildSceneGraph(const std::vector<SceneItem>& items, Qt3DCore::QEntity* parent) {
  SceneGraph graph;
  graph.root = new Qt3DCore::QEntity(parent);
  graph.root->setObjectName(QStringLiteral("scene"));
  Qt3DRender::QMaterial* material = makeMaterial(graph.root);
  for (const SceneItem& item : items) {
    auto* entity = new Qt3DCore::QEntity(graph.root);
    entity->setObjectName(QString::fromStdString(item.name));
    auto* transform = new Qt3DCore::QTransform(entity);
    auto* renderer = new Qt3DRender::QGeometryRenderer(entity);
    renderer->setGeometry(makeGeometry(renderer));
    // A given box spares Qt 3D its bounding volume job; nothing is culled by it.
    renderer->setMinPoint(QVector3D(-1, -1, -1));
    renderer->setMaxPoint(QVector3D(1, 1, 1));
    setMesh(*renderer, item.mesh);
    entity->addComponent(transform);
    entity->addComponent(renderer);
    entity->addComponent(material);
    entity->setEnabled(!item.mesh.indices.empty());
    graph.nodes.push_back({entity, transform, renderer});
  }
  return graph;
}

void updateSceneGraph(SceneGraph& graph, const SceneStage& stage) {
  const std::vector<Placement> places = stage.placements();
  const std::vector<SceneItem>& items = stage.items();
  for (std::size_t i = 0; i < graph.nodes.size() && i < items.size(); ++i) {
    SceneGraph::Node& node = graph.nodes[i];
    const Placement& place = places[i];
    bool visible = place.visible;
    if (visible && (items[i].role == ItemRole::Trail || items[i].role == ItemRole::Shadow)) {
      const double radius = 0.009 * stage.size().radius;
      const Mesh mesh = items[i].role == ItemRole::Shadow
                            ? stage.shadow()
                            : tubeMesh(stage.trail(), static_cast<float>(radius), kTrailSides,
                                       stage.colors().trail);
      visible = !mesh.indices.empty();
      if (visible) setMesh(*node.renderer, mesh);
    }
    node.entity->setEnabled(visible);
    if (!visible) continue;
    const Eigen::Quaternionf q = place.rotation.cast<float>();
    node.transform->setTranslation(toQVector(place.position));
    node.transform->setRotation(QQuaternion(q.w(), q.x(), q.y(), q.z()));
    node.transform->setScale3D(toQVector(place.scale));
  }
}

void updateCamera(Qt3DRender::QCamera& camera, const CameraView& view, double aspect) {
  camera.lens()->setPerspectiveProjection(
      static_cast<float>(view.verticalFov * 180.0 / std::numbers::pi), static_cast<float>(aspect),
      static_cast<float>(view.near), static_cast<float>(view.far));
  camera.setPosition(toQVector(view.eye));
  camera.setViewCenter(toQVector(view.target));
  camera.setUpVector(toQVector(view.up));
}

}  // namespace rotorbench
