// The map of a propeller against its blade elements. Errors are in percent of the static thrust and
// torque at the same air speed at 75 % radius, which stays meaningful where the propeller hardly
// turns.
#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/propulsion/rotor/propeller_map.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using uiuc::propeller;

namespace {

constexpr double kDegree = M_PI / 180;
/// Edgewise flow, which test_rotor_models looks at, as coarse as it may be.
constexpr PropellerMapSettings kAxialOnly{
    .sideDirections = 16, .sideAngles = 4, .sideReynoldsNumbers = 4, .sideRefinements = 0};

struct Worst {
  double thrust = 0, torque = 0;
};

/// Over directions of the air between two angles, rad, off the grid, at five speeds and in thin
/// air.
Worst worstBetween(const BladeElementRotor& rotor, const PropellerMap& map, double from,
                   double to) {
  const AirState air{1.1, 1.9e-5};
  Worst worst;
  for (double speed : {5.0, 17.0, 33.0, 60.0, 110.0}) {
    const double omega = speed / (0.75 * rotor.radius());
    const AxialLoad still = rotor.axial(omega, 0, air);
    for (double chi = from; chi <= to; chi += 0.37 * kDegree) {
      const double w = omega * std::cos(chi), axial = speed * std::sin(chi);
      const AxialLoad exact = rotor.axial(w, axial, air);
      const ThrustAndTorque mapped = map.axial(w, axial, air);
      worst.thrust =
          std::max(worst.thrust, 100 * std::abs(mapped.thrust - exact.thrust) / still.thrust);
      worst.torque =
          std::max(worst.torque, 100 * std::abs(mapped.torque - exact.torque) / still.torque);
    }
  }
  return worst;
}

}  // namespace

class TestPropellerMap : public QObject {
  Q_OBJECT
 private slots:
  void mapFollowsBladeElements_data();
  void mapFollowsBladeElements();
  void mapIsExactOnItsGrid();
  void airIsScaledByReynoldsNumber();
  void extremesAreFinite();
  void turningBackwardsIsTurningOver();
  void settingsAreChecked();
};

void TestPropellerMap::mapFollowsBladeElements_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"apcsf_10x4.7", "apce_10x5", "gwssf_10x8", "apcsp_9x7", "da4052_9x8.95",
                           "gwsdd_4x2.5", "grsn_11x6"}) {
    QTest::addRow("%s", name) << name;
  }
}

/// From straight descent to straight climb: 0.2 % and 1 %.
void TestPropellerMap::mapFollowsBladeElements() {
  QFETCH(QString, name);
  const BladeElementRotor rotor(propeller(name));
  const PropellerMap map(rotor, kAxialOnly);
  const Worst worst = worstBetween(rotor, map, -89.9 * kDegree, 89.9 * kDegree);
  qInfo("thrust %.3f %%, torque %.3f %%", worst.thrust, worst.torque);
  QVERIFY(worst.thrust <= 0.2 && worst.torque <= 1);
}

void TestPropellerMap::mapIsExactOnItsGrid() {
  const BladeElementRotor rotor({});
  const PropellerMapSettings settings = kAxialOnly;
  const PropellerMap map(rotor, settings);
  const AirState air;
  for (int i : {0, 7, 19}) {
    const double share = i / double(settings.reynoldsNumbers - 1);
    const double reynolds =
        settings.leastReynolds * std::pow(settings.mostReynolds / settings.leastReynolds, share);
    const double speed = reynolds * air.viscosity / (air.density * rotor.radius());
    for (double chi : {-45.0, 0.0, 30.0, 89.0}) {
      const double w = speed * std::cos(chi * kDegree) / (0.75 * rotor.radius());
      const double axial = speed * std::sin(chi * kDegree);
      const AxialLoad exact = rotor.axial(w, axial, air);
      const ThrustAndTorque mapped = map.axial(w, axial, air);
      QVERIFY(std::abs(mapped.thrust / exact.thrust - 1) < 1e-6);
      QVERIFY(std::abs(mapped.torque / exact.torque - 1) < 1e-6);
    }
  }
}

/// Half the density at twice the speed is the same Reynolds number: twice the load, to the last
/// digits.
void TestPropellerMap::airIsScaledByReynoldsNumber() {
  const PropellerMap map(BladeElementRotor({}), kAxialOnly);
  const ThrustAndTorque a = map.axial(400, 3, {1.2, 1.8e-5}), b = map.axial(800, 6, {0.6, 1.8e-5});
  QVERIFY(std::abs(b.thrust / a.thrust - 2) < 1e-12 && std::abs(b.torque / a.torque - 2) < 1e-12);
}

void TestPropellerMap::extremesAreFinite() {
  const PropellerMap map(BladeElementRotor({}), kAxialOnly);
  QCOMPARE(map.axial(0, 0, {}).thrust, 0.0);
  QCOMPARE(map.axial(500, 3, {0, 1.8e-5}).torque, 0.0);
  for (double omega : {-1e5, -1.0, 0.0, 1e-12, 1.0, 1e5}) {
    for (double axial : {-1e4, -1.0, 0.0, 1e-12, 1.0, 1e4}) {
      const ThrustAndTorque load = map.axial(omega, axial, {});
      QVERIFY(std::isfinite(load.thrust) && std::isfinite(load.torque));
    }
  }
}

void TestPropellerMap::turningBackwardsIsTurningOver() {
  const PropellerMap map(BladeElementRotor({}), kAxialOnly);
  QCOMPARE(map.axial(-400, 2, {}).thrust, -map.axial(400, -2, {}).thrust);
  QCOMPARE(map.axial(-400, 2, {}).torque, -map.axial(400, -2, {}).torque);
}

void TestPropellerMap::settingsAreChecked() {
  PropellerMapSettings settings;
  QVERIFY(schema::validate(schema::ref(settings)).empty());
  settings.mostReynolds = settings.leastReynolds;
  QCOMPARE(schema::validate(schema::ref(settings)).size(), std::size_t(1));
  settings = {.sideDirections = 400, .sideAngles = 100};
  QCOMPARE(schema::validate(schema::ref(settings)).size(), std::size_t(1));
}

QTEST_GUILESS_MAIN(TestPropellerMap)
#include "test_propeller_map.moc"
