#include <QTest>
#include <filesystem>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/scene/scene_model.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

Experiment shipped(const char* name) {
  return loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / name);
}

void compare(const Vector3d& actual, const Vector3d& expected) {
  QVERIFY2((actual - expected).norm() < 1e-12,
           qPrintable(QString("(%1, %2, %3)").arg(actual.x()).arg(actual.y()).arg(actual.z())));
}

}  // namespace

class TestSceneModel : public QObject {
  Q_OBJECT

 private slots:
  void flagship();
  void layoutTurnsTheSpins();
  void birotors_data();
  void birotors();
  void deviationMovesOneHub();
  void impossibleVehicles_data();
  void impossibleVehicles();
};

/// JSBSim's F450: hubs 0.1651 m along both axes, 0.025 m above the centre of mass; rotors from the
/// front left, counter-clockwise seen from above, neighbours turning oppositely; 9450 propellers
/// have a diameter of 9.45 in.
void TestSceneModel::flagship() {
  const auto model = sceneModel(shipped("f450-hover-and-steps.json"));
  QVERIFY(model.has_value());
  QCOMPARE(model->title, std::string("F450: hover and steps"));
  QVERIFY(!model->elasticArms);
  QCOMPARE(model->rotors.size(), std::size_t{4});
  const double a = 0.1651;
  const std::array<Vector3d, 4> hubs{Vector3d(a, a, 0.025), Vector3d(-a, a, 0.025),
                                     Vector3d(-a, -a, 0.025), Vector3d(a, -a, 0.025)};
  for (std::size_t i = 0; i < 4; ++i) {
    const SceneRotor& rotor = model->rotors[i];
    compare(rotor.position, hubs[i]);
    compare(rotor.axis, Vector3d::UnitZ());
    QCOMPARE(rotor.spin, i % 2 == 0 ? 1.0 : -1.0);
    QVERIFY(std::abs(rotor.radius - 9.45 * 0.0254 / 2) < 1e-12);
    QCOMPARE(rotor.blades, 2);
    QVERIFY(rotor.stations.size() >= 2);
    for (std::size_t s = 1; s < rotor.stations.size(); ++s) {
      QVERIFY(rotor.stations[s].radius > rotor.stations[s - 1].radius);
      QVERIFY(rotor.stations[s].twist < rotor.stations[s - 1].twist);  // constant pitch
      QVERIFY(rotor.stations[s].chord > 0);
    }
    QVERIFY(std::abs(rotor.stations.back().radius - rotor.radius) < 1e-12);
  }
  // Twice the thrust of a rotor in hover: 1.4 kg.
  QVERIFY(std::abs(model->fullThrust - 2 * 1.4 * 9.80665 / 4) < 0.01);
}

void TestSceneModel::layoutTurnsTheSpins() {
  Experiment experiment = shipped("f450-hover-and-steps.json");
  PlusLayout plus;
  plus.arm = 0.3;
  plus.firstSpin = Spin::Clockwise;
  alternative<Flight>(experiment.setup).vehicle.layout = plus;
  const auto model = sceneModel(experiment);
  QVERIFY(model.has_value());
  compare(model->rotors[0].position, {0.3, 0, 0});
  compare(model->rotors[1].position, {0, 0.3, 0});
  QCOMPARE(model->rotors[0].spin, -1.0);
  QCOMPARE(model->rotors[1].spin, 1.0);
}

void TestSceneModel::birotors_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<bool>("elastic");
  QTest::addColumn<double>("fullThrust");
  QTest::addRow("spring bar, table 2.1: 0.2 N") << "spring-bar-birotor.json" << true << 0.2;
  QTest::addRow("rigid bar, table 2.2: 2 N") << "thesis-experiment-1.json" << false << 2.0;
}

/// Body 1 at -r, body 2 at +r along the bar (thesis 2014, figure 2.1); r = 0.25 m in both tables.
void TestSceneModel::birotors() {
  QFETCH(QString, file);
  QFETCH(bool, elastic);
  QFETCH(double, fullThrust);
  const auto model = sceneModel(shipped(qPrintable(file)));
  QVERIFY(model.has_value());
  QCOMPARE(model->elasticArms, elastic);
  QCOMPARE(model->rotors.size(), std::size_t{2});
  compare(model->rotors[0].position, {0, -0.25, 0});
  compare(model->rotors[1].position, {0, 0.25, 0});
  for (const auto& rotor : model->rotors) compare(rotor.axis, Vector3d::UnitZ());
  QCOMPARE(model->rotors[0].spin, -model->rotors[1].spin);
  QCOMPARE(model->bodyRadius, 0.0);
  QCOMPARE(model->fullThrust, fullThrust);
}

/// The place of a hub is drawn from the centre of mass, which the deviations shift too: against
/// each other only the first hub has moved.
void TestSceneModel::deviationMovesOneHub() {
  const Experiment experiment = shipped("unbalanced-f450.json");
  Experiment balanced = experiment;
  alternative<Flight>(balanced.setup).vehicle.deviations.clear();
  const auto planned = sceneModel(balanced);
  const auto actual = sceneModel(experiment);
  QVERIFY(planned.has_value() && actual.has_value());
  const auto moved = [&](std::size_t i) -> Vector3d {
    return (actual->rotors[i].position - actual->rotors[1].position) -
           (planned->rotors[i].position - planned->rotors[1].position);
  };
  compare(moved(0), {0.0212, 0.0212, 0});
  compare(moved(2), Vector3d::Zero());
  compare(moved(3), Vector3d::Zero());
  // 50 g more at rotor 3, rear right, draw the centre of mass there: all hubs come to lie ahead and
  // to the left.
  const Vector3d shift = actual->rotors[1].position - planned->rotors[1].position;
  QVERIFY(shift.x() > 0 && shift.y() > 0);
}

void TestSceneModel::impossibleVehicles_data() {
  QTest::addColumn<int>("fault");
  QTest::addRow("mass below zero") << 0;
  QTest::addRow("inertia no body has") << 1;
  QTest::addRow("deviation of rotor 9") << 2;
  QTest::addRow("three rotors in the set") << 3;
}

void TestSceneModel::impossibleVehicles() {
  QFETCH(int, fault);
  Experiment experiment;
  VehicleParameters& vehicle = alternative<Flight>(experiment.setup).vehicle;
  QVERIFY(sceneModel(experiment).has_value());
  DirectMass mass;
  if (fault == 0) mass.mass = -1;
  if (fault == 1) mass.inertia.zz = 1;  // more than the other two together
  vehicle.mass = mass;
  if (fault == 2) vehicle.deviations.push_back({9, Vector3d::Zero(), 0});
  if (fault == 3) {
    IndividualRotors three;
    three.rotors.resize(3);
    vehicle.rotors = three;
  }
  QVERIFY(!sceneModel(experiment).has_value());
}

QTEST_GUILESS_MAIN(TestSceneModel)
#include "test_scene_model.moc"
