#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/vehicle/vehicle_parameters.h"

using namespace rotorbench;
using Eigen::Matrix3d;
using Eigen::Vector3d;

class TestMassProperties : public QObject {
  Q_OBJECT
 private slots:
  void partsFollowThesisFormula();
  void anyPartsFollowParallelAxes();
  void deviationOfAMeasuredVehicleMovesItsMotor();
  void impossibleInertiaIsRefused_data();
  void impossibleInertiaIsRefused();
  void rotorsAreNumberedFromTheFront_data();
  void rotorsAreNumberedFromTheFront();
  void wrongRotorsAreNamed();
};

/// Thesis 2014 (3.9): Ixx = (m2 + m4) r^2 + 2/5 m rs^2, Izz = (m1 + .. + m4) r^2 + 2/5 m rs^2.
void TestMassProperties::partsFollowThesisFormula() {
  VehicleParameters v;
  v.layout = PlusLayout{.arm = 0.2};
  v.mass = PartsMass{.bodyMass = 1, .bodyRadius = 0.1};
  std::get<EqualRotors>(v.rotors).rotor.mass = 0.1;
  const MassProperties m = massOf(v);
  QVERIFY(std::abs(m.mass - 1.4) < 1e-15);
  QVERIFY(m.centre.norm() < 1e-15);
  QVERIFY(m.inertia.isApprox(Vector3d(0.012, 0.012, 0.02).asDiagonal().toDenseMatrix(), 1e-12));
}

void TestMassProperties::anyPartsFollowParallelAxes() {
  VehicleParameters v;
  v.layout = CrossLayout{};
  v.mass = PartsMass{.bodyMass = 0.9, .bodyRadius = 0.08, .bodyPosition = {0.01, -0.02, 0.03}};
  v.payloads = {{0.2, {0.1, 0.05, -0.1}}};
  v.deviations = {{2, {0.03, 0.01, -0.02}, 0.02}};
  const MassProperties m = massOf(v);

  // By hand: all points, then the tensor about the actual centre.
  std::vector<std::pair<double, Vector3d>> points{{0.2, {0.1, 0.05, -0.1}}};
  const double a = 0.1651;
  const Vector3d hubs[] = {{a, a, 0.025}, {-a, a, 0.025}, {-a, -a, 0.025}, {a, -a, 0.025}};
  for (int i = 0; i < 4; ++i) {
    points.emplace_back(i == 1 ? 0.075 : 0.055,
                        i == 1 ? Vector3d(hubs[i] + Vector3d(0.03, 0.01, -0.02)) : hubs[i]);
  }
  points.emplace_back(0.9, Vector3d(0.01, -0.02, 0.03));
  double mass = 0;
  Vector3d centre = Vector3d::Zero();
  for (const auto& [k, r] : points) mass += k, centre += k * r;
  centre /= mass;
  Matrix3d inertia = 0.4 * 0.9 * 0.08 * 0.08 * Matrix3d::Identity();
  for (const auto& [k, r] : points) {
    const Vector3d d = r - centre;
    inertia += k * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
  QVERIFY(std::abs(m.mass - mass) < 1e-14);
  QVERIFY((m.centre - centre).norm() < 1e-14);
  QVERIFY((m.inertia - inertia).norm() < 1e-14);
}

void TestMassProperties::deviationOfAMeasuredVehicleMovesItsMotor() {
  VehicleParameters v;  // F450, 1.4 kg given directly, motors of 55 g
  v.deviations = {{1, {0.02, 0, 0}, 0.01}};
  const MassProperties m = massOf(v);
  QVERIFY(std::abs(m.mass - 1.41) < 1e-14);
  // 55 g moved by 2 cm and 10 g more at 0.1851 m.
  QVERIFY(std::abs(m.centre.x() - (0.055 * 0.02 + 0.01 * 0.1851) / 1.41) < 1e-12);
  const MassProperties planned = massOf(v, true);
  QVERIFY(std::abs(planned.mass - 1.4) < 1e-15);
  QVERIFY(planned.centre.norm() < 1e-15);
}

void TestMassProperties::impossibleInertiaIsRefused_data() {
  QTest::addColumn<double>("zz");
  QTest::addColumn<double>("xy");
  QTest::addColumn<bool>("possible");
  QTest::addRow("F450") << 0.0252 << 0.0 << true;
  QTest::addRow("flat plate, the limit") << 0.038 << 0.0 << true;
  QTest::addRow("above the sum of the others by 1.9 %%: rounded") << 0.03872 << 0.0 << true;
  QTest::addRow("above the sum of the others by 2.1 %%") << 0.0388 << 0.0 << false;
  QTest::addRow("not positive definite") << 0.0252 << 0.02 << false;
  QTest::addRow("products of inertia break the triangle") << 0.0252 << 0.0131 << false;
}

void TestMassProperties::impossibleInertiaIsRefused() {
  QFETCH(double, zz);
  QFETCH(double, xy);
  QFETCH(bool, possible);
  VehicleParameters v;
  auto& inertia = std::get<DirectMass>(v.mass).inertia;
  inertia.zz = zz;
  inertia.xy = xy;
  const auto problems = schema::validate(schema::ref(std::as_const(v)));
  QCOMPARE(std::ranges::all_of(problems, &Problem::warning), possible);
  QCOMPARE(problems.empty(), possible && zz <= 0.038);
  bool thrown = false;
  try {
    massOf(v);
  } catch (const InputError& e) {
    thrown = !e.problems().empty();
  }
  QCOMPARE(thrown, !possible);
}

void TestMassProperties::rotorsAreNumberedFromTheFront_data() {
  QTest::addColumn<bool>("cross");
  QTest::addColumn<int>("rotor");
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  QTest::addColumn<double>("spin");
  QTest::addRow("plus 1 front") << false << 1 << 0.2 << 0.0 << 1.0;
  QTest::addRow("plus 2 left") << false << 2 << 0.0 << 0.2 << -1.0;
  QTest::addRow("plus 3 rear") << false << 3 << -0.2 << 0.0 << 1.0;
  QTest::addRow("plus 4 right") << false << 4 << 0.0 << -0.2 << -1.0;
  QTest::addRow("cross 1 front left") << true << 1 << 0.1651 << 0.1651 << 1.0;
  QTest::addRow("cross 2 rear left") << true << 2 << -0.1651 << 0.1651 << -1.0;
  QTest::addRow("cross 3 rear right") << true << 3 << -0.1651 << -0.1651 << 1.0;
  QTest::addRow("cross 4 front right") << true << 4 << 0.1651 << -0.1651 << -1.0;
}

void TestMassProperties::rotorsAreNumberedFromTheFront() {
  QFETCH(bool, cross);
  QFETCH(int, rotor);
  QFETCH(double, x);
  QFETCH(double, y);
  QFETCH(double, spin);
  const RotorLayout layout =
      cross ? RotorLayout(CrossLayout{}) : RotorLayout(PlusLayout{.arm = 0.2});
  const auto place = placeRotors(layout)[static_cast<std::size_t>(rotor - 1)];
  QVERIFY(std::abs(place.position.x() - x) < 1e-12);
  QVERIFY(std::abs(place.position.y() - y) < 1e-12);
  QCOMPARE(spinSign(place.spin), spin);
}

void TestMassProperties::wrongRotorsAreNamed() {
  VehicleParameters v;
  v.deviations = {{5, Vector3d::Zero(), 0}};
  v.layout = FreeLayout{};
  std::get<FreeLayout>(v.layout).rotors.resize(3);
  try {
    rotorsOf(v);
    QFAIL("a layout of three rotors and a deviation of the fifth were accepted");
  } catch (const InputError& e) {
    QCOMPARE(e.problems().size(), std::size_t{2});
    QCOMPARE(e.problems()[0].path, std::string("layout.rotors"));
    QCOMPARE(e.problems()[1].path, std::string("deviations[0].rotor"));
  }
}

QTEST_APPLESS_MAIN(TestMassProperties)
#include "test_mass_properties.moc"
