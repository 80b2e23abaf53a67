// PoseReader: which sample is shown at a time, the planar and the elastic vehicles, decimated
// trails.
#include <QTest>
#include <limits>

#include "sim/scene/propeller_scene.h"
#include "tests/ui/scene/scene_fixture.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

Recording& fill(Recording& recording, std::initializer_list<std::vector<double>> rows) {
  for (const auto& row : rows) recording.append(row);
  recording.publish();
  return recording;
}

bool near(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() < 1e-12;
}

}  // namespace

class TestPoseReader : public QObject {
  Q_OBJECT
 private slots:
  void showsTheLastSampleNotAfterTheTime_data() {
    QTest::addColumn<double>("time");
    QTest::addColumn<double>("x");
    QTest::addRow("before the start") << -1.0 << 0.0;
    QTest::addRow("at the first") << 0.0 << 0.0;
    QTest::addRow("between") << 0.1999 << 1.0;
    QTest::addRow("exactly at a sample") << 0.2 << 2.0;
    QTest::addRow("two samples at one time: the later") << 0.3 << 4.0;
    QTest::addRow("after the end") << 9.0 << 4.0;
  }

  void showsTheLastSampleNotAfterTheTime() {
    QFETCH(double, time);
    QFETCH(double, x);
    Recording recording(flightChannels());
    fill(recording,
         {flightRow(0.0, {0, 0, 0}), flightRow(0.1, {1, 0, 0}), flightRow(0.2, {2, 0, 0}),
          flightRow(0.3, {3, 0, 0}), flightRow(0.3, {4, 0, 0})});
    const SceneModel model = quadrotorModel();
    const PoseReader reader(model, recording);
    QVERIFY(reader.valid());
    const ScenePose pose = reader.at(time);
    QCOMPARE(pose.position.x(), x);
    QCOMPARE(pose.time, time);
    QCOMPARE(pose.rotorSpeed, std::vector<double>(4, 600.0));
    QCOMPARE(pose.rotorThrust, std::vector<double>(4, 4.0));
    QVERIFY(pose.setPoint.has_value());
    QVERIFY(near(*pose.setPoint, Vector3d(0, 0, 1)));
  }

  void seesOnlyPublishedRows() {
    Recording recording(flightChannels());
    const SceneModel model = quadrotorModel();
    const PoseReader reader(model, recording);
    QVERIFY(reader.valid());
    QVERIFY(near(reader.at(0).position, Vector3d::Zero()));
    recording.append(flightRow(0, {5, 0, 0}));
    QVERIFY(near(reader.at(0).position, Vector3d::Zero()));
    recording.publish();
    QVERIFY(near(reader.at(0).position, Vector3d(5, 0, 0)));
  }

  /// A propeller on a stand has a speed and a thrust and stays where it is.
  void standTurnsAndStays_data() {
    QTest::addColumn<QString>("channel");
    QTest::addRow("thrust stand") << "motor.speed";
    QTest::addRow("propeller bench") << "speed";
  }
  void standTurnsAndStays() {
    QFETCH(QString, channel);
    Recording recording(
        {{"time", "s", ""}, {channel.toStdString(), "rad/s", ""}, {"thrust", "N", ""}});
    fill(recording, {{0, 100, 1}, {1, 500, 7}});
    const SceneModel model = standScene(PropellerGeometry{});
    const PoseReader reader(model, recording);
    QVERIFY(reader.valid());
    const ScenePose pose = reader.at(2);
    QVERIFY(near(pose.position, Vector3d::Zero()));
    QCOMPARE(pose.rotorSpeed, std::vector<double>{500});
    QCOMPARE(pose.rotorThrust, std::vector<double>{7});
    QVERIFY(reader.trail(0, 2, 10).empty());
    QCOMPARE(model.rotors.front().stations.back().radius, PropellerGeometry{}.diameter / 2);
  }

  void planarVehicleTurnsAboutX() {
    Recording recording({{"time", "s", ""},
                         {"position.y", "m", ""},
                         {"position.z", "m", ""},
                         {"angle", "rad", ""},
                         {"rotor1.thrust", "N", ""},
                         {"rotor2.thrust", "N", ""}});
    fill(recording, {{0, 2, 3, std::numbers::pi / 2, 7, 8}});
    const SceneModel model = birotorModel(false);
    const ScenePose pose = PoseReader(model, recording).at(0);
    QVERIFY(near(pose.position, Vector3d(0, 2, 3)));
    // Body 2 lies at +r along alpha: at 90 degrees it stands above the middle (physics: y-z plane).
    QVERIFY(near(pose.attitude * Vector3d::UnitY(), Vector3d::UnitZ()));
    QCOMPARE(pose.rotorThrust, (std::vector<double>{7, 8}));
    QVERIFY(pose.rotorSpeed.empty());
  }

  void elasticBarTakesHubsFromTheBodies() {
    Recording recording({{"time", "s", ""},
                         {"body1.y", "m", ""},
                         {"body1.z", "m", ""},
                         {"body2.y", "m", ""},
                         {"body2.z", "m", ""}});
    fill(recording, {{0, 1, 1, 4, 5}});  // 3-4-5 triangle: bar of 5 m
    const SceneModel model = birotorModel(true);
    const ScenePose pose = PoseReader(model, recording).at(0);
    QVERIFY(near(pose.position, Vector3d(0, 2.5, 3)));
    QCOMPARE(pose.hubs.size(), std::size_t{2});
    QVERIFY(near(pose.position + pose.attitude * pose.hubs[0], Vector3d(0, 1, 1)));
    QVERIFY(near(pose.position + pose.attitude * pose.hubs[1], Vector3d(0, 4, 5)));
  }

  void setPointOfAltitudeAloneStaysWithTheVehicle() {
    std::vector<Channel> channels = flightChannels();
    channels.erase(channels.end() - 3, channels.end() - 1);
    Recording recording(channels);
    std::vector<double> row = flightRow(0, {3, 4, 5});
    row.erase(row.end() - 3, row.end() - 1);
    fill(recording, {row});
    const SceneModel model = quadrotorModel();
    QVERIFY(near(*PoseReader(model, recording).at(0).setPoint, Vector3d(3, 4, 1)));
  }

  void isInvalidWithoutAPlace() {
    Recording recording({{"time", "s", ""}, {"position.x", "m", ""}});
    fill(recording, {{0, 1}});
    const SceneModel quad = quadrotorModel();
    const SceneModel bar = birotorModel(true);
    QVERIFY(!PoseReader(quad, recording).valid());
    QVERIFY(!PoseReader(bar, recording).valid());
    QVERIFY(near(PoseReader(quad, recording).at(0).position, Vector3d::Zero()));
    QVERIFY(PoseReader(quad, recording).trail(0, 1, 10).empty());
  }

  void trailIsBoundedAndEndsAtTheVehicle_data() {
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 3, 10, 97, 5000}) QTest::addRow("%d points", count) << count;
  }

  void trailIsBoundedAndEndsAtTheVehicle() {
    QFETCH(int, count);
    const auto recording = flightAlong([](double t) { return Vector3d(t, 2 * t, 0); }, 10.0);
    const SceneModel model = quadrotorModel();
    const PoseReader reader(model, *recording);
    const auto points = reader.trail(0, 7.5, static_cast<std::size_t>(count));
    QVERIFY(!points.empty());
    QVERIFY(points.size() <= static_cast<std::size_t>(count));
    QVERIFY(near(points.back(), reader.at(7.5).position));
    if (count >= 3) QVERIFY(near(points.front(), Vector3d::Zero()));
    // 751 rows: all of them where there is room, more than a third of the room used where not.
    if (count == 5000) QCOMPARE(points.size(), std::size_t{751});
    if (count == 97) QVERIFY(points.size() > 32);
  }

  void trailKeepsItsPointsWhileItGrows() {
    const auto recording = flightAlong([](double t) { return Vector3d(t, std::sin(t), 0); }, 10.0);
    const SceneModel model = quadrotorModel();
    const PoseReader reader(model, *recording);
    const auto before = reader.trail(0, 7.00, 100);
    const auto after = reader.trail(0, 7.01, 100);
    for (std::size_t i = 0; i + 1 < before.size(); ++i) QVERIFY(near(before[i], after[i]));
  }

  void trailLeavesOutWhatIsNotFinite() {
    Recording recording(flightChannels());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    fill(recording, {flightRow(0, {0, 0, 0}), flightRow(1, {nan, 0, 0}), flightRow(2, {2, 0, 0})});
    const SceneModel model = quadrotorModel();
    const auto points = PoseReader(model, recording).trail(0, 2, 10);
    QCOMPARE(points.size(), std::size_t{2});
    QVERIFY(near(points.back(), Vector3d(2, 0, 0)));
  }
};

QTEST_APPLESS_MAIN(TestPoseReader)
#include "test_pose_reader.moc"
