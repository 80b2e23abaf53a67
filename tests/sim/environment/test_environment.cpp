#include <QtTest>

#include "sim/core/schema_tree.h"
#include "sim/environment/environment.h"
#include "sim/numerics/dual.h"

using namespace rotorbench;

class TestEnvironment : public QObject {
  Q_OBJECT
 private slots:
  void uniformAirIsTheSameEverywhere();
  void standardAtmosphere_data();
  void standardAtmosphere();
  void warmAirIsThinner();
  void windOverHeight();
  void stillAirIsTheDefault();
  void defaultsAreValidAndEditable();
};

void TestEnvironment::uniformAirIsTheSameEverywhere() {
  const AirConstants air = buildAir({.air = UniformAir{.density = 0.9}, .wind = {}});
  QCOMPARE(air.density(0.0), 0.9);
  QCOMPARE(air.density(5000.0), 0.9);
  QCOMPARE(air.density(Dual(100.0, 1)).slope(), 0.0);
  QVERIFY(air.sameAtAllRotors());
}

/// U.S. Standard Atmosphere 1976, table I (geometric altitude), equal to ISO 2533 below 32 km.
void TestEnvironment::standardAtmosphere_data() {
  QTest::addColumn<double>("altitude");
  QTest::addColumn<double>("density");
  const double table[][2] = {{-1000, 1.3470},  {0, 1.2250},      {1000, 1.1117},   {2000, 1.0066},
                             {5000, 0.73643},  {8000, 0.52579},  {10000, 0.41351}, {11000, 0.36480},
                             {12000, 0.31194}, {15000, 0.19476}, {20000, 0.088910}};
  for (const auto& row : table) QTest::addRow("%g m", row[0]) << row[0] << row[1];
}
void TestEnvironment::standardAtmosphere() {
  QFETCH(double, altitude);
  QFETCH(double, density);
  EnvironmentParameters e;
  e.air = StandardAir{.elevation = 300};
  const AirConstants air = buildAir(e);
  // The table has five digits.
  QVERIFY(std::abs(air.density(altitude - 300) / density - 1) < 6e-5);
  if (altitude <= 11000)
    QVERIFY(std::abs(standardAltitude(standardDensity(altitude)) - altitude) < 1e-6);
  const double step = 1;
  const double slope =
      (air.density(altitude - 300 + step) - air.density(altitude - 300 - step)) / (2 * step);
  if (altitude < 20000)
    QVERIFY(std::abs(air.density(Dual(altitude - 300, 1)).slope() / slope - 1) < 1e-5);
}

/// At the same pressure density goes with the inverse of the absolute temperature.
void TestEnvironment::warmAirIsThinner() {
  for (const double altitude : {0.0, 3000.0, 15000.0}) {
    const double temperature = altitude < 11000 ? 288.15 - 0.0065 * altitude : 216.65;
    const double ratio = standardDensity(altitude, 20) / standardDensity(altitude);
    QVERIFY(std::abs(ratio * (temperature + 20) / temperature - 1) < 1e-4);
  }
  // Beyond its range the density stays, and no number becomes none.
  QCOMPARE(standardDensity(1e6), standardDensity(isa::kHigh));
  QCOMPARE(standardDensity(-1e6), standardDensity(isa::kLow));
}

/// Stull: 5 m/s at 10 m over a roughness of 0.03 m are 3.61474 at 2 m and 6.38526 at 50 m.
void TestEnvironment::windOverHeight() {
  EnvironmentParameters e;
  e.wind =
      LogarithmicWind{.velocity = {3, 4}, .referenceHeight = 10, .roughness = 0.03, .ground = 7};
  const AirConstants air = buildAir(e);
  QVERIFY(!air.sameAtAllRotors());
  const auto speed = [&](double height) { return air.velocity(0, height + 7).norm(); };
  QVERIFY(std::abs(speed(10) - 5) < 1e-12);
  QVERIFY(std::abs(speed(2) - 3.61474) < 1e-5);
  QVERIFY(std::abs(speed(50) - 6.38526) < 1e-5);
  QCOMPARE(speed(0.03), 0.0);
  QCOMPARE(speed(-3), 0.0);
  QVERIFY((air.velocity(0, 17.0) - Eigen::Vector3d(3, 4, 0)).norm() < 1e-12);
  QVERIFY(std::abs(air.velocity(0, Dual(12, 1)).x().slope() - 3 / std::log(10 / 0.03) / 5) < 1e-12);
}

void TestEnvironment::stillAirIsTheDefault() {
  const AirConstants air = buildAir({});
  QVERIFY(!air.moving && air.sameAtAllRotors());
  // A wind of 0 may rise during a flight, and its velocity is recorded.
  EnvironmentParameters calm;
  calm.wind = SteadyWind{.velocity = {0, 0, 0}};
  QVERIFY(buildAir(calm).moving && buildAir(calm).sameAtAllRotors());
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
  e.wind = LogarithmicWind{.velocity = {5, 0}, .referenceHeight = 0.02};
  const auto problems = schema::validate(schema::ref(std::as_const(e)));
  QCOMPARE(problems.size(), std::size_t{1});
  QCOMPARE(problems.front().path, std::string("wind.roughness"));
}

QTEST_APPLESS_MAIN(TestEnvironment)
#include "test_environment.moc"
