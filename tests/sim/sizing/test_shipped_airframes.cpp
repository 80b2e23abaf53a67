// Whoever takes an airframe off the shelf gets one that flies as its like do: it hovers within its
// own limits, climbs, and is braked by the air. Figures of flights and stands are cited where they
// stand.
#include <QTest>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/library/component_library.h"
#include "sim/sizing/performance.h"

using namespace rotorbench;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSteepest = 45 * kDegree;

/// Published coefficients that no rotor can have: kept as published, and warned of.
const std::set<std::string>& implausible() {
  static const std::set<std::string> names{
      "Crazyflie 2.1 Brushless (IDSIA)", "Racer (gym-pybullet-drones)", "T18 octorotor (FSC Lab)"};
  return names;
}

const ComponentLibrary& shipped() {
  static const ComponentLibrary library(shippedLibraryDirectory(), {});
  return library;
}

const VehicleParameters& airframe(const std::string& name) {
  const LibraryEntry* entry = shipped().find(*kindOf("airframe"), name);
  if (entry == nullptr) qFatal("no airframe %s", name.c_str());
  return *entry->component.as<VehicleParameters>();
}

/// m/s^2 upwards of the level vehicle that climbs straight at a speed in m/s with its rotors at
/// full throttle.
double climbAcceleration(const VehicleParameters& vehicle, double climb) {
  const Eigen::VectorXd speeds = SteadyFlight(vehicle, {}).fullThrottle().speeds;
  return withRotorCount(rotorCount(vehicle.layout), [&](auto count) {
    using Plant = Multirotor<count, RotorDrive::PrescribedSpeeds>;
    using L = typename Plant::Layout;
    const Plant plant(buildMultirotor<count>(vehicle, {}));
    typename Plant::State y = Plant::State::Zero(), rate;
    y.template segment<4>(L::kAttitude) = quaternionOf({0, 0, 0});
    y[L::kVelocity + 2] = climb;
    Plant::setRotorSpeeds(y, speeds);
    plant.setBodyRates(y, Eigen::Vector3d::Zero());
    plant(0, y, rate);
    return rate[L::kVelocity + 2];
  });
}

/// Speed in m/s of the level flight at a tilt in rad.
double speedAt(const VehicleParameters& vehicle, double tilt) {
  const SteadyFlight flight(vehicle, {});
  Trim near = *flight.hover();
  double low = 0, high = 0;
  while (near.tilt() < tilt && high < 100) {
    const auto next = flight.trim(high += 0.5, near);
    if (!next) qFatal("no trim at %g m/s", high);
    low = near.speed;
    near = *next;
  }
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    (flight.trim(middle, near)->tilt() < tilt ? low : high) = middle;
  }
  return low;
}

double hoverPower(const VehicleParameters& vehicle) {
  const SteadyFlight flight(vehicle, {});
  return flight.demand(*flight.hover()).power;
}

bool within30Percent(double value, double cited) {
  return std::abs(value / cited - 1) < 0.3;
}

}  // namespace

class TestShippedAirframes : public QObject {
  Q_OBJECT

 private slots:
  void all_data();
  void all();
  void exceptionsAreFewAndWarnedOf();
  void f450LeansInto10Degrees_data();
  void f450LeansInto10Degrees();
  void citedFlights();
  void citedHoverPowers_data();
  void citedHoverPowers();
};

void TestShippedAirframes::all_data() {
  QTest::addColumn<QString>("name");
  for (const LibraryEntry* entry : shipped().list(*kindOf("airframe"))) {
    const std::string& name = entry->component.info.name;
    QTest::addRow("%s", name.c_str()) << QString::fromStdString(name);
  }
}

void TestShippedAirframes::all() {
  QFETCH(QString, name);
  const VehicleParameters& vehicle = airframe(name.toStdString());
  const SteadyFlight flight(vehicle, {});
  const auto hover = flight.hover();
  QVERIFY(hover.has_value());
  QVERIFY(marginOf(flight, *hover, 1, kSteepest).value > 0);
  QVERIFY2(climbAcceleration(vehicle, 2) > 0, "does not climb at 2 m/s");
  QVERIFY2(climbAcceleration(vehicle, 40) < 0, "nothing ends its climb");
  QVERIFY2(airResistanceOf(vehicle).described(), airResistanceOf(vehicle).missing().c_str());
  const LevelFlight level = levelFlight(flight, *hover, {});
  QVERIFY2(level.fastest.speed > 2 && level.fastest.speed < 40,
           qPrintable(QString::number(level.fastest.speed)));
  const FigureSheet sheet = performanceSheet(vehicle, {});
  const double merit = sheet.at("efficiency.propeller").value;
  const bool plausible = merit >= 0.2 && merit <= 0.8;
  QVERIFY2(plausible != implausible().contains(name.toStdString()),
           qPrintable(QString("figure of merit %1").arg(merit)));
}

void TestShippedAirframes::exceptionsAreFewAndWarnedOf() {
  QVERIFY(implausible().size() <= 3);
  for (const std::string& name : implausible()) {
    const LibraryEntry* entry = shipped().find(*kindOf("airframe"), name);
    QVERIFY2(entry != nullptr, name.c_str());
    QVERIFY2(entry->component.info.warning.find("Implausible as published") != std::string::npos,
             name.c_str());
  }
}

void TestShippedAirframes::f450LeansInto10Degrees_data() {
  QTest::addColumn<bool>("experiment");
  QTest::addRow("DJI F450 (JSBSim)") << false;
  QTest::addRow("DJI F450 (AirSim)") << false;
  QTest::addRow("f450-hover-and-steps") << true;
  QTest::addRow("f450-in-the-wind") << true;
}
void TestShippedAirframes::f450LeansInto10Degrees() {
  QFETCH(bool, experiment);
  const std::string name = QTest::currentDataTag();
  const std::string file = std::string(EXPERIMENTS_DIR "/") + name + ".json";
  const VehicleParameters vehicle =
      experiment ? alternative<Flight>(loadExperiment(file).setup).vehicle : airframe(name);
  const double speed = speedAt(vehicle, 10 * kDegree);
  QVERIFY2(speed > 3.5 && speed < 8.5, qPrintable(QString::number(speed)));
}

/// PX4, PX4-SITL_gazebo-classic, pull request 451: in the log of an Iris 0.22 rad at 5 m/s. Five
/// inch racers lean by 45 degrees at 20 m/s.
void TestShippedAirframes::citedFlights() {
  const SteadyFlight iris(airframe("3DR Iris (PX4)"), {});
  const auto trim = iris.trim(5, *iris.hover());
  QVERIFY2(within30Percent(trim->tilt(), 0.22), qPrintable(QString::number(trim->tilt())));
  const double racer = speedAt(airframe("Racer (gym-pybullet-drones)"), kSteepest);
  QVERIFY2(within30Percent(racer, 20), qPrintable(QString::number(racer)));
}

/// A DJI 9450 on the stand of the MRS group (ctu-mrs.github.io, hardware/motor_tests, Readytosky
/// 2312, half throttle) takes 51.48 W for 401 gf, and power goes with thrust to 3/2. Four rotors of
/// a Crazyflie 2.0 (crazyflie-firmware, docs/functional-areas/pwm-to-thrust.md) with its
/// electronics take 1.83 A at 3.71 V for 24.4 gf and 2.11 A at 3.67 V for 28.6 gf.
void TestShippedAirframes::citedHoverPowers_data() {
  QTest::addColumn<double>("cited");
  const auto rotors9450 = [](double kilograms, int rotors) {
    return rotors * 51.48 * std::pow(kilograms / rotors / 0.401, 1.5);
  };
  QTest::addRow("DJI F450 (JSBSim)") << rotors9450(1.4, 4);
  QTest::addRow("DJI F450 (AirSim)") << rotors9450(1.635, 4);
  QTest::addRow("DJI F550 (MRS, E305)") << rotors9450(2.0, 6);
  const double low = 1.83 * 3.71, high = 2.11 * 3.67;
  QTest::addRow("Crazyflie 2.1 (Bitcraze)") << low + (28 - 24.4) / (28.6 - 24.4) * (high - low);
}
void TestShippedAirframes::citedHoverPowers() {
  QFETCH(double, cited);
  const double power = hoverPower(airframe(QTest::currentDataTag()));
  QVERIFY2(within30Percent(power, cited), qPrintable(QString("%1 W, %2").arg(power).arg(cited)));
}

QTEST_APPLESS_MAIN(TestShippedAirframes)
#include "test_shipped_airframes.moc"
