#include <Eigen/Core>  // AutoDiff does not include it itself
#include <QtTest>
#include <unsupported/Eigen/AutoDiff>

#include "sim/core/schema_tree.h"
#include "sim/environment/environment.h"

using namespace rotorbench;

class TestEnvironment : public QObject {
  Q_OBJECT
 private slots:
  void uniformAirIsTheSameEverywhere();
  void defaultsAreValidAndEditable();
};

void TestEnvironment::uniformAirIsTheSameEverywhere() {
  const AirConstants air = buildAir(UniformAir{.density = 0.9});
  QCOMPARE(air.density(0.0), 0.9);
  QCOMPARE(air.density(5000.0), 0.9);
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  QCOMPARE(air.density(Dual(100.0, 1, 0)).derivatives()[0], 0.0);
}

void TestEnvironment::defaultsAreValidAndEditable() {
  EnvironmentParameters e;
  QVERIFY(schema::validate(schema::ref(std::as_const(e))).empty());
  schema::set(schema::ref(e), "air.density", schema::Value(1.0));
  QCOMPARE(std::get<UniformAir>(e.air).density, 1.0);
  bool refused = false;
  try {
    schema::set(schema::ref(e), "gravity", schema::Value(-1.0));
  } catch (const InputError&) {
    refused = true;
  }
  QVERIFY(refused);
  QCOMPARE(e.gravity, 9.80665);
}

QTEST_APPLESS_MAIN(TestEnvironment)
#include "test_environment.moc"
