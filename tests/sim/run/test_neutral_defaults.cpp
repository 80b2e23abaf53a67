// What a file does not name is zero or has no effect: it is never a figure of another product. The
// flights below are worked out by hand; the figures of the shipped parts are those their own
// sources publish.
#include <QTest>
#include <cmath>
#include <limits>
#include <map>

#include "sim/document/drive_stand.h"
#include "sim/document/experiment_file.h"
#include "sim/library/component_library.h"
#include "sim/run/drive_build.h"
#include "sim/vehicle/vehicle_parameters.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;

namespace {

/// Four rotors of a nano quadrotor at 2500 rad/s, without any drag of the body, for half a second.
std::string nanoFlight(const std::string& inflow) {
  return R"({"rotorbench":1,"setup":{"type":"flight","vehicle":{
    "layout":{"type":"cross","arm":0.043,"height":0},
    "rotors":{"type":"equal","rotor":{"aerodynamics":{"type":"coefficients","thrust":2.3e-8,
      "torque":7.8e-10)" +
         inflow + R"(},"inertia":1e-8}},
    "mass":{"type":"direct","mass":0.039,"inertia":{"xx":1.43e-5,"yy":1.43e-5,"zz":2.86e-5}},
    "drag":{"linear":0}},
    "control":{"type":"rotor-speeds","source":{"type":"constant","speeds":[2500,2500,2500,2500]}},
    "start":{"rotors":"given","rotorSpeed":2500},"duration":0.5},
    "outputs":{"recordInterval":"1 ms"}})";
}

const RotorCoefficients* coefficientsOf(const Component& component) {
  if (const auto* own = component.as<RotorCoefficients>()) return own;
  const auto* vehicle = component.as<VehicleParameters>();
  if (vehicle == nullptr) return nullptr;
  return std::get_if<RotorCoefficients>(&std::get<EqualRotors>(vehicle->rotors).rotor.aerodynamics);
}

const ComponentLibrary& shipped() {
  static const ComponentLibrary library(shippedLibraryDirectory(), {});
  return library;
}

}  // namespace

class TestNeutralDefaults : public QObject {
  Q_OBJECT

 private slots:
  void inflowThatIsNotNamedIsNone_data();
  void inflowThatIsNotNamedIsNone();
  void shippedRotorsHaveTheirOwnInflow();
  void shippedAirframesKeepTheirOwnCurrentLimit();
  void motorOnAStandKeepsItsOwnCurrentLimit();
};

void TestNeutralDefaults::inflowThatIsNotNamedIsNone_data() {
  QTest::addColumn<QString>("inflow");
  QTest::addRow("not named") << "";
  QTest::addRow("empty") << R"(,"inflow":{})";
  QTest::addRow("one of four") << R"(,"inflow":{"flapping":0})";
  QTest::addRow("zeros") << R"(,"inflow":{"drag":0,"inflow":0,"translationalLift":0,"flapping":0})";
}

/// T = 4 k w^2 = 4 2.3e-8 2500^2 = 0.575 N; a = 0.575/0.039 - 9.80665 = 4.93694 m/s^2; z = a/2
/// 0.5^2 = 0.617117 m.
void TestNeutralDefaults::inflowThatIsNotNamedIsNone() {
  QFETCH(QString, inflow);
  const auto simulation =
      test::finished(readExperiment(nanoFlight(inflow.toStdString()), "nano.json"));
  const Recording& flight = *simulation->runs().front().recording;
  const double z = test::value(flight, "position.z", flight.rows() - 1);
  QVERIFY2(std::abs(z - 0.617117) < 1e-6, qPrintable(QString::number(z, 'g', 9)));
}

/// k_d, k_z, k_h, k_flap as published; parts that are not listed have none.
void TestNeutralDefaults::shippedRotorsHaveTheirOwnInflow() {
  const RotorInflow hummingbird{1.19e-4, 2.32e-4, 3.39e-3, 0};  // RotorPy, hummingbird_params.py
  const RotorInflow crazyflie{1.025e-6, 7.55e-7, 0, 0};         // RotorPy, crazyflie_params.py
  const RotorInflow rotors{8.06428e-5, 0, 0, 0};  // RotorS, hummingbird.xacro and pelican.xacro
  const std::map<std::string, RotorInflow> published{
      {"AscTec Hummingbird rotor (RotorPy)", hummingbird},
      {"AscTec Hummingbird (RotorPy)", hummingbird},
      {"Crazyflie 2.x rotor (RotorPy)", crazyflie},
      {"Crazyflie 2.x (RotorPy)", crazyflie},
      {"Crazyflie Brushless with guards (RotorPy)", {5.09e-6, 1.19e-5, 1.11e-3, 0}},
      // gym-pybullet-drones, assets/cf2x.urdf: drag_coeff_xy, drag_coeff_z
      {"Crazyflie 2.x (gym-pybullet-drones)", {9.1785e-7, 1.0311e-6, 0, 0}},
      {"RotorS 8.55e-6 rotor", rotors},
      {"AscTec Hummingbird (RotorS)", rotors},
      {"AscTec Pelican rotor (RotorS)", rotors},
      {"AscTec Pelican (RotorS)", rotors},
      {"T18 octorotor (FSC Lab)", rotors},      // t18/model.sdf: the figure of PX4's models
      {"3DR Iris (PX4)", {1.75e-4, 0, 0, 0}}};  // PX4, models/iris/iris.sdf.jinja
  std::size_t checked = 0, found = 0;
  for (const LibraryEntry& entry : shipped().entries()) {
    const RotorCoefficients* c = coefficientsOf(entry.component);
    if (c == nullptr) continue;
    ++checked;
    const auto own = published.find(entry.component.info.name);
    found += own != published.end() ? 1 : 0;
    QVERIFY2(c->inflow == (own == published.end() ? RotorInflow{} : own->second),
             entry.component.info.name.c_str());
  }
  QVERIFY2(checked >= 20, qPrintable(QString::number(checked)));
  QCOMPARE(found, published.size());
}

/// What the file of an airframe states for its motors holds, though it names no speed controller.
void TestNeutralDefaults::shippedAirframesKeepTheirOwnCurrentLimit() {
  double most = 0;
  for (const LibraryEntry& entry : shipped().entries()) {
    const auto* vehicle = entry.component.as<VehicleParameters>();
    if (vehicle == nullptr) continue;
    const RotorParameters& rotor = std::get<EqualRotors>(vehicle->rotors).rotor;
    QVERIFY2(buildEsc(rotor.esc, buildMotor(rotor.motor)).maxCurrent == rotor.motor.maxCurrent,
             entry.component.info.name.c_str());
    most = std::max(most, rotor.motor.maxCurrent);
  }
  QCOMPARE(most, 224.0);  // 3DR Iris (PX4)
}

/// 0.5 N m at 1/100.53 N m/A are 50.3 A: a motor that bears 100 A holds them, though nothing is
/// said of a controller.
void TestNeutralDefaults::motorOnAStandKeepsItsOwnCurrentLimit() {
  DriveStand stand;
  stand.motor.maxCurrent = 100;
  stand.motor.noLoadCurrent = 0;
  stand.motor.resistance = 0.05;
  stand.load = BrakeLoad{0.5};
  const DriveTrain train = buildDriveTrain(stand);
  QCOMPARE(train.maxCurrent(), 100.0);
  const auto y = train.steadyState(1, 1, 0);
  QVERIFY2(std::abs(y[DriveTrain::kCurrent] - 0.5 * stand.motor.speedConstant) < 0.01,
           qPrintable(QString::number(y[DriveTrain::kCurrent])));
}

QTEST_APPLESS_MAIN(TestNeutralDefaults)
#include "test_neutral_defaults.moc"
