// The cameras: where things appear in the picture, and that a vehicle on its way stays in it.
#include <QTest>
#include <numbers>

#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/scene_camera.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

SceneCamera cameraFor(CameraMode mode, double heading = 0) {
  SceneCamera camera;
  camera.reset(0.35, false);
  camera.setMode(mode);
  ScenePose pose;
  pose.attitude = Eigen::AngleAxisd(heading, Vector3d::UnitZ());
  camera.follow(pose);
  return camera;
}

}  // namespace

class TestSceneCamera : public QObject {
  Q_OBJECT
 private slots:
  void axesAppearWhereTheyShould_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<double>("heading");
    QTest::addColumn<Vector3d>("point");
    QTest::addColumn<int>("right");  // sign of the way to the right, 2 for "any"
    QTest::addColumn<int>("up");
    const double quarter = std::numbers::pi / 2;
    const int orbit = static_cast<int>(CameraMode::Orbit);
    const int chase = static_cast<int>(CameraMode::Chase);
    const int top = static_cast<int>(CameraMode::Top);
    QTest::addRow("orbit, z is up") << orbit << 0.0 << Vector3d(0, 0, 0.1) << 0 << 1;
    QTest::addRow("orbit from behind right, x goes right and away")
        << orbit << 0.0 << Vector3d(0.1, 0, 0) << 1 << 1;
    QTest::addRow("orbit, y is left") << orbit << 0.0 << Vector3d(0, 0.1, 0) << -1 << 1;
    QTest::addRow("chase, y is left") << chase << 0.0 << Vector3d(0, 0.1, 0) << -1 << 0;
    QTest::addRow("chase, turned left by 90 degrees, -x is left")
        << chase << quarter << Vector3d(-0.1, 0, 0) << -1 << 0;
    QTest::addRow("top, x is up") << top << 0.0 << Vector3d(0.1, 0, 0) << 0 << 1;
    QTest::addRow("top, y is left") << top << 0.0 << Vector3d(0, 0.1, 0) << -1 << 0;
  }

  void axesAppearWhereTheyShould() {
    QFETCH(int, mode);
    QFETCH(double, heading);
    QFETCH(Vector3d, point);
    QFETCH(int, right);
    QFETCH(int, up);
    const SceneCamera camera = cameraFor(static_cast<CameraMode>(mode), heading);
    const Projector project(camera.view(1.5), 600, 400);
    const auto at = project(point);
    const auto middle = project(Vector3d::Zero());
    QVERIFY(at && middle);
    const auto sign = [](double v) { return v > 1 ? 1 : v < -1 ? -1 : 0; };
    QCOMPARE(sign(at->x - middle->x), right);
    QCOMPARE(sign(middle->y - at->y), up);
    QVERIFY(std::abs(middle->x - 300) < 1e-9);
    QVERIFY(std::abs(middle->y - 200) < 1e-9);
  }

  void projectorAgreesWithTheMatrix() {
    const SceneCamera camera = cameraFor(CameraMode::Orbit);
    const CameraView view = camera.view(1.6);
    const Projector project(view, 800, 500);
    for (const Vector3d& p :
         {Vector3d(0, 0, 0), Vector3d(0.3, -0.2, 0.1), Vector3d(-0.4, 0.1, -0.3)}) {
      const Eigen::Vector4d clip = view.viewProjection(1.6) * p.homogeneous();
      const auto at = project(p);
      QVERIFY(at);
      QVERIFY(std::abs(400 * (1 + clip.x() / clip.w()) - at->x) < 1e-9);
      QVERIFY(std::abs(250 * (1 - clip.y() / clip.w()) - at->y) < 1e-9);
    }
    QVERIFY(!project(view.eye + 2 * (view.eye - view.target)));
  }

  void vehicleFillsAGoodPartOfThePicture_data() {
    QTest::addColumn<double>("aspect");
    for (const double aspect : {0.5, 1.0, 1.6, 3.0}) {
      QTest::addRow("width / height %.1f", aspect) << aspect;
    }
  }

  void vehicleFillsAGoodPartOfThePicture() {
    QFETCH(double, aspect);
    const Projector project(cameraFor(CameraMode::Orbit).view(aspect), 400 * aspect, 400);
    const auto at = project(Vector3d::Zero());
    const double radius = 0.35 * project.scaleAt(at->depth);
    const double room = 0.5 * std::min(400.0, 400 * aspect);
    QVERIFY2(radius > 0.5 * room && radius < 0.95 * room,
             qPrintable(QString::number(radius / room)));
  }

  void orbitStaysStillForSmallMovesAndFollowsLargeOnes() {
    SceneCamera camera = cameraFor(CameraMode::Orbit);
    const Vector3d before = camera.view(1.5).target;
    ScenePose pose;
    pose.position = {0.05, 0.05, 0.05};
    camera.follow(pose);
    QVERIFY((camera.view(1.5).target - before).norm() < 1e-12);
    for (int step = 0; step < 100; ++step) {
      pose.position += Vector3d(0.5, -0.3, 0.4);
      camera.follow(pose);
      const auto at = Projector(camera.view(1.5), 600, 400)(pose.position);
      QVERIFY(at && at->x > 0 && at->x < 600 && at->y > 0 && at->y < 400);
    }
  }

  void zoomAndTurnHaveBounds() {
    SceneCamera camera = cameraFor(CameraMode::Orbit);
    for (int i = 0; i < 200; ++i) camera.zoom(0.8);
    QVERIFY((camera.view(1.5).eye - camera.view(1.5).target).norm() > 0.35);
    for (int i = 0; i < 400; ++i) camera.zoom(1.3);
    QVERIFY((camera.view(1.5).eye - camera.view(1.5).target).norm() < 100);
    for (int i = 0; i < 100; ++i) camera.turn(0.3, 0.3);
    const CameraView view = camera.view(1.5);
    QVERIFY(view.up.z() > 0);
    QVERIFY((view.target - view.eye).normalized().cross(view.up).norm() > 0.9);
  }
};

QTEST_APPLESS_MAIN(TestSceneCamera)
#include "test_scene_camera.moc"
