// The geometry of the scene: blades from their stations, closed surfaces that look outward,
// placements, and the Qt 3D graph built from them, counted without rendering.
#include <QTest>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QTransform>
#include <numbers>

#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/scene_graph.h"
#include "ui/scene/scene_stage.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

SceneColors colors() {
  return sceneColors(QPalette(QColor(239, 239, 239)));
}

/// Volume inside a closed surface by the divergence theorem: positive if its triangles look
/// outward.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vector3d a = mesh.positions[mesh.indices[i]].cast<double>();
    const Vector3d b = mesh.positions[mesh.indices[i + 1]].cast<double>();
    const Vector3d c = mesh.positions[mesh.indices[i + 2]].cast<double>();
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

int count(const std::vector<SceneItem>& items, ItemRole role) {
  return static_cast<int>(std::count_if(items.begin(), items.end(),
                                        [role](const SceneItem& i) { return i.role == role; }));
}

std::size_t indexOf(const std::vector<SceneItem>& items, const std::string& name) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return i;
  }
  qFatal("no item %s", name.c_str());
  return 0;
}

}  // namespace

class TestSceneItems : public QObject {
  Q_OBJECT
 private slots:
  void bladeHasChordAndTwistOfItsStations_data() {
    QTest::addColumn<double>("spin");
    QTest::addRow("counter-clockwise") << 1.0;
    QTest::addRow("clockwise") << -1.0;
  }

  void bladeHasChordAndTwistOfItsStations() {
    QFETCH(double, spin);
    const std::vector<DrawnStation> stations{
        {0.02, 0.030, 0.6}, {0.06, 0.025, 0.3}, {0.12, 0.012, -0.05}};
    const Mesh mesh = bladeMesh(stations, 0.12, spin, Vec3f::Ones(), Vec3f::Ones());
    for (const DrawnStation& s : stations) {
      // Of the vertices at this radius, leading and trailing edge are the two farthest apart.
      Vec3f leading = Vec3f::Zero(), trailing = Vec3f::Zero();
      float widest = 0;
      for (const Vec3f& a : mesh.positions) {
        for (const Vec3f& b : mesh.positions) {
          if (std::abs(a.x() - s.radius) > 1e-6 || std::abs(b.x() - s.radius) > 1e-6) continue;
          if ((a - b).norm() <= widest) continue;
          widest = (a - b).norm();
          leading = spin * a.y() > spin * b.y() ? a : b;
          trailing = spin * a.y() > spin * b.y() ? b : a;
        }
      }
      QVERIFY(std::abs(widest - s.chord) < 1e-6);
      const Vec3f chord = leading - trailing;
      QVERIFY(std::abs(std::atan2(chord.z(), spin * chord.y()) - s.twist) < 1e-4);
      // The quarter-chord point lies on the radial line.
      QVERIFY((0.75F * leading + 0.25F * trailing - Vec3f(leading.x(), 0, 0)).norm() < 1e-6F);
    }
  }

  void surfacesLookOutward_data() {
    QTest::addColumn<Mesh>("mesh");
    QTest::addColumn<double>("expected");
    const double pi = std::numbers::pi;
    const Vec3f c = Vec3f::Ones();
    const std::vector<DrawnStation> plain{{0, 0.1, 0}, {1, 0.1, 0}};
    // Outline of bladePoint(): two triangles over the chord, 9 % and 4 % of it high.
    const double blade = 0.5 * 0.13 * 0.1 * 0.1;
    QTest::addRow("cone frustum") << frustumMesh(2, 1, 0, 3, 200, c, 3) << pi * 3 / 3 * (4 + 2 + 1);
    QTest::addRow("sphere") << sphereMesh(1, 200, c) << 4.0 / 3 * pi;
    QTest::addRow("ring") << ringMesh(2, 0.2F, 200, 100, c) << 2 * pi * pi * 2 * 0.04;
    QTest::addRow("blade") << bladeMesh(plain, 1, 1, c, c) << blade;
    QTest::addRow("mirrored blade") << bladeMesh(plain, 1, -1, c, c) << blade;
  }

  void surfacesLookOutward() {
    QFETCH(Mesh, mesh);
    QFETCH(double, expected);
    QVERIFY2(std::abs(volume(mesh) - expected) < 2e-3 * expected,
             qPrintable(QString::number(volume(mesh))));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const Vec3f& a = mesh.positions[mesh.indices[i]];
      const Vec3f across =
          (mesh.positions[mesh.indices[i + 1]] - a).cross(mesh.positions[mesh.indices[i + 2]] - a);
      if (across.norm() < 1e-9F) continue;
      QVERIFY(across.dot(mesh.normals[mesh.indices[i]]) > 0);
    }
  }

  void tubeFollowsThePath() {
    std::vector<Vector3d> path;
    for (int i = 0; i <= 50; ++i) path.emplace_back(0.1 * i, std::sin(0.1 * i), 0.3 * i);
    const Mesh mesh = tubeMesh(path, 0.01F, 6, Vec3f::Ones());
    QCOMPARE(mesh.positions.size(), path.size() * 6);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const double away = (mesh.positions[i].cast<double>() - path[i / 6]).norm();
      QVERIFY(std::abs(away - 0.01) < 1e-5);
    }
    QVERIFY(tubeMesh(std::vector<Vector3d>(5, Vector3d(1, 2, 3)), 0.01F, 6, Vec3f::Ones())
                .indices.empty());
  }

  void everyRotorHasItsBlades_data() {
    QTest::addColumn<int>("blades");
    QTest::addRow("two") << 2;
    QTest::addRow("three") << 3;
  }

  void everyRotorHasItsBlades() {
    QFETCH(int, blades);
    SceneStage stage(MeshDetail::High);
    stage.setColors(colors());
    stage.setModel(quadrotorModel(blades));
    QCOMPARE(count(stage.items(), ItemRole::Blade), 4 * blades);
    QCOMPARE(count(stage.items(), ItemRole::Arm), 4);
    QCOMPARE(count(stage.items(), ItemRole::Motor), 4);
    QCOMPARE(count(stage.items(), ItemRole::ThrustShaft), 4);

    Qt3DCore::QEntity root;
    SceneGraph graph = buildSceneGraph(stage.items(), &root);
    QCOMPARE(graph.nodes.size(), stage.items().size());
    for (int r = 1; r <= 4; ++r) {
      for (int b = 1; b <= blades; ++b) {
        const QString name = QStringLiteral("rotor%1.blade%2").arg(r).arg(b);
        QVERIFY2(root.findChild<Qt3DCore::QEntity*>(name), qPrintable(name));
      }
    }
    // Frames move entities and never make or remove any.
    stage.setRecording(flightAlong([](double t) { return Vector3d(0, 0, t); }, 2.0));
    const auto entities = root.findChildren<Qt3DCore::QEntity*>();
    const auto nodes = root.findChildren<Qt3DCore::QNode*>().size();
    for (int frame = 0; frame < 20; ++frame) {
      stage.setTime(0.1 * frame);
      updateSceneGraph(graph, stage);
    }
    QCOMPARE(root.findChildren<Qt3DCore::QEntity*>(), entities);
    QCOMPARE(root.findChildren<Qt3DCore::QNode*>().size(), nodes);
    const float z = graph.nodes[indexOf(stage.items(), "hub")].transform->translation().z();
    QVERIFY(std::abs(z - 1.9F) < 1e-5F);
  }

  void arrowsHaveTheLengthAndSideOfTheThrust() {
    const SceneModel model = quadrotorModel();
    const std::vector<SceneItem> items = itemsOf(model, colors(), MeshDetail::High);
    ScenePose pose;
    pose.position = {1, 2, 3};
    pose.rotorThrust = {8, 4, -4, 0};
    const std::vector<double> angles(4, 0.0);
    const auto places = placeItems(items, model, pose, angles, SceneOptions{});
    const double full = arrowLength(model, pose, 0);
    QVERIFY(full > 0.1);
    QCOMPARE(arrowLength(model, pose, 1), 0.5 * full);
    QCOMPARE(arrowLength(model, pose, 2), -0.5 * full);
    const auto tip = [&](int rotor) {
      const std::string name = "rotor" + std::to_string(rotor);
      const Placement& head = places[indexOf(items, name + ".thrust.head")];
      const Placement& shaft = places[indexOf(items, name + ".thrust.shaft")];
      float top = 0;
      for (const Vec3f& p : items[indexOf(items, name + ".thrust.head")].mesh.positions) {
        top = std::max(top, p.z());
      }
      const Vector3d end = head.position + head.rotation * Vector3d(0, 0, top * head.scale.z());
      return (end - shaft.position).z();
    };
    QVERIFY(std::abs(tip(1) - full) < 1e-6);
    QVERIFY(std::abs(tip(3) + 0.5 * full) < 1e-6);
    QVERIFY(!places[indexOf(items, "rotor4.thrust.shaft")].visible);
    SceneOptions none;
    none.thrust = false;
    QVERIFY(!placeItems(items, model, pose, angles, none)[indexOf(items, "rotor1.thrust.head")]
                 .visible);
  }

  /// From upwind towards the vehicle, never into it, longer in stronger wind; none without.
  void windHasAnArrow() {
    const SceneModel model = quadrotorModel();
    const std::vector<SceneItem> items = itemsOf(model, colors(), MeshDetail::Low);
    const std::vector<double> angles(4, 0.0);
    ScenePose pose;
    pose.position = {1, 2, 3};
    const auto shaft = [&](const SceneOptions& options) {
      return placeItems(items, model, pose, angles, options)[indexOf(items, "wind.shaft")];
    };
    QVERIFY(!shaft({}).visible);
    pose.wind = Vector3d(0, -6, 0);
    const WindArrow six = windArrow(model, pose);
    QCOMPARE(six.speed, 6.0);
    QVERIFY(shaft({}).visible);
    QVERIFY((shaft({}).rotation * Vector3d::UnitZ() + Vector3d::UnitY()).norm() < 1e-12);
    const Vector3d tip = six.tail + six.length * six.direction;
    QVERIFY(tip.y() > pose.position.y() + sceneSize(model).radius);
    QVERIFY(six.tail.y() > tip.y());
    pose.wind = Vector3d(0, 0, 12);
    QVERIFY(std::abs(windArrow(model, pose).length - 2 * six.length) < 1e-12);
    SceneOptions without;
    without.wind = false;
    QVERIFY(!shaft(without).visible);
    pose.wind = Vector3d::Zero();
    QVERIFY(!shaft({}).visible);
    // Before a run the experiment's own wind is shown.
    SceneModel windy = model;
    windy.wind = Vector3d(3, 4, 0);
    pose.wind.reset();
    QCOMPARE(windArrow(windy, pose).speed, 5.0);
  }

  void rotorsTurnTheirWay() {
    SceneStage stage(MeshDetail::Low);
    stage.setModel(quadrotorModel());
    stage.setRecording(flightAlong([](double) { return Vector3d(0, 0, 0); }, 2.0, 400));
    stage.setTime(0.02);
    const std::vector<double> angles = stage.rotorAngles();
    QVERIFY(angles[0] > 0);
    QVERIFY(angles[1] < 0);
    QCOMPARE(angles[0], -angles[1]);
    stage.setTime(0.0);
    QVERIFY(std::abs(stage.rotorAngles()[0]) < 1e-12);
  }

  void elasticHubsMoveArmsAndMotors() {
    const SceneModel model = birotorModel(true);
    const std::vector<SceneItem> items = itemsOf(model, colors(), MeshDetail::Low);
    ScenePose pose;
    pose.hubs = {Vector3d(0, -0.9, 0), Vector3d(0, 0.9, 0)};
    const auto places = placeItems(items, model, pose, {0, 0}, SceneOptions{});
    QVERIFY((places[indexOf(items, "rotor2.motor")].position - pose.hubs[1]).norm() < 1e-12);
    QCOMPARE(places[indexOf(items, "rotor2.arm")].scale.z(), 0.9);
    QVERIFY(sceneSize(model).planar);
    QVERIFY(!sceneSize(quadrotorModel()).planar);
  }

  void samplesThatAreNotFiniteLeaveTheVehicleThere() {
    auto recording = std::make_shared<Recording>(flightChannels());
    recording->append(flightRow(0, {0, 0, 2}));
    recording->append(flightRow(1, {0, std::nan(""), 5}));
    recording->publish();
    SceneStage stage(MeshDetail::Low);
    stage.setModel(quadrotorModel());
    stage.setRecording(recording);
    stage.setTime(0.5);
    stage.setTime(1.5);
    QCOMPARE(stage.pose().position.z(), 2.0);
  }
};

QTEST_MAIN(TestSceneItems)
#include "test_scene_items.moc"
