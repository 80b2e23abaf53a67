// The performance sheet of a vehicle against the vehicle's own equations, closed forms and
// published figures.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/sizing/discharge.h"
#include "sim/sizing/performance.h"

using namespace rotorbench;

namespace {

bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::abs(b);
}

Flight flightOf(const char* name) {
  const Experiment e = loadExperiment(std::string(EXPERIMENTS_DIR "/") + name + ".json");
  return alternative<Flight>(e.setup);
}

RotorParameters& rotorOf(VehicleParameters& vehicle) {
  return std::get<EqualRotors>(vehicle.rotors).rotor;
}

double value(const FigureSheet& sheet, const char* key) {
  return sheet.at(key).value;
}

bool noteSays(const FigureSheet& sheet, const char* key, const char* part) {
  return sheet.at(key).note.text().find(part) != std::string::npos;
}

/// A vehicle of published numbers whose motors reach exactly the largest speed given: no losses.
VehicleParameters published(double mass, double kf, double kmOverKf, double largestSpeed) {
  VehicleParameters vehicle;
  vehicle.mass = DirectMass{};
  std::get<DirectMass>(vehicle.mass).mass = mass;
  RotorParameters& rotor = rotorOf(vehicle);
  rotor.aerodynamics = RotorCoefficients{kf, kf * kmOverKf, {}, 1.225, 0.2};
  rotor.motor.noLoadCurrent = 0;
  rotor.motor.resistance = 1e-9;
  rotor.motor.speedConstant = largestSpeed / 11.1;
  rotor.motor.maxCurrent = 1e4;
  return vehicle;
}

}  // namespace

class TestPerformance : public QObject {
  Q_OBJECT
 private slots:
  /// Simulators' parameter files: mass with rotors, thrust constant, largest rotor speed, and what
  /// follows.
  void publishedVehicles_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("kf");
    QTest::addColumn<double>("largest");
    QTest::addColumn<double>("hover");
    QTest::addColumn<double>("thrustToWeight");
    // RotorS: hummingbird.xacro, pelican.xacro, iris.xacro; PX4: sihsim quadx.
    QTest::addRow("Hummingbird") << 0.716 << 8.54858e-6 << 838.0 << 453.0 << 3.42;
    QTest::addRow("Pelican") << 1.04 << 9.9865e-6 << 838.0 << 505.0 << 2.75;
    QTest::addRow("Iris") << 1.52 << 8.54858e-6 << 838.0 << 660.0 << 1.61;
    QTest::addRow("PX4 SIH") << 1.0 << 5e-6 << 1000.0 << 700.0 << 2.04;
  }
  void publishedVehicles() {
    QFETCH(double, mass);
    QFETCH(double, kf);
    QFETCH(double, largest);
    const FigureSheet sheet = performanceSheet(published(mass, kf, 0.016, largest), {});
    QTEST(std::round(value(sheet, "hover.speed")), "hover");
    QTEST(std::round(100 * value(sheet, "thrust.toWeight")) / 100, "thrustToWeight");
  }

  /// The hover is the one the flight starts from, with its duties.
  void hoverIsTheVehicles_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"f450-hover-and-steps", "hummingbird-open-loop", "unbalanced-f450"}) {
      QTest::addRow("%s", name) << name;
    }
  }
  void hoverIsTheVehicles() {
    QFETCH(QString, name);
    const Flight flight = flightOf(qPrintable(name));
    const Multirotor<4> vehicle(buildMultirotor<4>(flight.vehicle, flight.environment));
    const auto speeds = vehicle.hoverSpeeds();
    const FigureSheet sheet = performanceSheet(flight.vehicle, flight.environment);
    QVERIFY(near(value(sheet, "hover.speed"), speeds.mean(), 1e-6));
    QVERIFY(near(value(sheet, "hover.throttle"), vehicle.steadyDuties(speeds).maxCoeff(), 1e-6));
    QVERIFY(value(sheet, "efficiency.propeller") < 1);
    const double chain = value(sheet, "efficiency.battery") * value(sheet, "efficiency.esc") *
                         value(sheet, "efficiency.motor") * value(sheet, "efficiency.propeller");
    QVERIFY(near(value(sheet, "efficiency.total"), chain, 1e-12));
  }

  /// The fastest flight put into the equations that are flown: nothing accelerates, and its limit
  /// is just met.
  void fastestFlightIsATrim_data() {
    QTest::addColumn<double>("tiltDegrees");
    QTest::addColumn<QString>("limit");
    QTest::addRow("tilt") << 20.0 << "tilt of 20 degrees";
    QTest::addRow("throttle") << 80.0 << "voltage under load";
  }
  void fastestFlightIsATrim() {
    QFETCH(double, tiltDegrees);
    QFETCH(QString, limit);
    Flight flight = flightOf("hummingbird-open-loop");
    flight.vehicle.drag.quadratic = {0.03, 0.03, 0.05};
    std::get<RotorCoefficients>(rotorOf(flight.vehicle).aerodynamics).inflow = {1e-6, 1e-5, 0,
                                                                                1e-7};
    PerformanceSettings settings;
    settings.tiltLimit = tiltDegrees * std::numbers::pi / 180;
    const SteadyFlight steady(flight.vehicle, flight.environment);
    const LevelFlight level = levelFlight(steady, *steady.hover(), settings);
    const Trim& trim = level.fastest;
    QVERIFY(trim.speed > 1);

    using Vehicle = Multirotor<4, RotorDrive::PrescribedSpeeds>;
    using L = Vehicle::Layout;
    const Vehicle vehicle(buildMultirotor<4>(flight.vehicle, flight.environment));
    Vehicle::State y = Vehicle::State::Zero(), rate;
    y.segment<4>(L::kAttitude) = quaternionOf({trim.roll, trim.pitch, 0});
    y[L::kVelocity] = trim.speed;
    Vehicle::setRotorSpeeds(y, trim.rotors());
    vehicle.setBodyRates(y, Eigen::Vector3d::Zero());
    vehicle(0, y, rate);
    QVERIFY(rate.segment<3>(L::kVelocity).norm() < 1e-6);
    QVERIFY(rate.segment<3>(L::kMomentum).norm() < 1e-6);
    const Margin left = marginOf(steady, trim, settings.speedThrottle, settings.tiltLimit);
    QVERIFY(left.value >= 0 && left.value < 1e-5);
    const FigureSheet sheet = performanceSheet(flight.vehicle, flight.environment, settings);
    QVERIFY(near(value(sheet, "level.speed"), trim.speed, 1e-12));
    QVERIFY2(noteSays(sheet, "level.speed", qPrintable(limit)),
             sheet.at("level.speed").note.text().c_str());
  }

  /// Without rotor drag: tan(theta) = drag/weight, so v_max at a tilt limit is sqrt(m g tan/c).
  void tiltLimitHasItsClosedForm() {
    VehicleParameters vehicle = published(1, 5e-6, 0.016, 3000);
    vehicle.drag.linear = 0;
    vehicle.drag.quadratic = {0.05, 0.05, 0.05};
    PerformanceSettings settings;
    settings.tiltLimit = 0.5;
    const FigureSheet sheet = performanceSheet(vehicle, {}, settings);
    // Equal in all axes the drag points along the wind: c v^2 = m g tan(theta).
    QVERIFY(near(value(sheet, "level.speed"), std::sqrt(9.80665 * std::tan(0.5) / 0.05), 1e-6));
  }

  void flightWithoutDragIsNotGivenASpeed() {
    VehicleParameters vehicle = published(1, 5e-6, 0.016, 1000);
    vehicle.drag.linear = 0;
    QVERIFY(noteSays(performanceSheet(vehicle, {}), "level.speed", "at least this"));
  }

  /// A loss-free motor hovers at throttle w/w_max: the payload at 80 % is 0.64 T/W - 1 of the mass.
  void payloadHasItsClosedForm() {
    const double kf = 8.54858e-6, largest = 838, mass = 0.716;
    const FigureSheet sheet = performanceSheet(published(mass, kf, 0.016, largest), {});
    const double expected = 4 * kf * std::pow(0.8 * largest, 2) / 9.80665 - mass;
    QVERIFY(near(value(sheet, "payload.most"), expected, 1e-6));
    QVERIFY(noteSays(sheet, "payload.most", "80 % throttle"));
  }

  /// And its ceiling lies where the density is 1/(T/W) of that at sea level (ISO 2533: 0.6125
  /// kg/m^3 at 6667 m for a half).
  void ceilingHasItsClosedForm() {
    const double mass = 4 * 5e-6 * 1e6 / 2 / 9.80665;  // thrust to weight 2
    const FigureSheet sheet = performanceSheet(published(mass, 5e-6, 0.016, 1000), {});
    QVERIFY(std::abs(value(sheet, "ceiling.hover") - 6667) < 5);
  }

  /// With a battery the time is that of the discharge under the hover's power, never above capacity
  /// over current.
  void limitsAreNamed() {
    Flight flight = flightOf("f450-hover-and-steps");
    FigureSheet sheet = performanceSheet(flight.vehicle, flight.environment);
    QVERIFY(noteSays(sheet, "thrust.toWeight", "current limit of 20 A"));
    rotorOf(flight.vehicle).motor.maxCurrent = 8;
    sheet = performanceSheet(flight.vehicle, flight.environment);
    QVERIFY(noteSays(sheet, "payload.most", "current limit of 8 A"));
    rotorOf(flight.vehicle).motor.maxCurrent = 7;
    sheet = performanceSheet(flight.vehicle, flight.environment);
    QVERIFY(std::isnan(value(sheet, "hover.throttle")));
    QVERIFY(noteSays(sheet, "hover.speed", "current limit of 7 A"));
    QCOMPARE(sheet.warnings.size(), std::size_t(1));
    QCOMPARE(value(sheet, "payload.most"), 0.0);
  }

  void moreMassMeansLessOfEverything() {
    Flight flight = flightOf("f450-hover-and-steps");
    const FigureSheet light = performanceSheet(flight.vehicle, flight.environment);
    std::get<DirectMass>(flight.vehicle.mass).mass += 0.4;
    const FigureSheet heavy = performanceSheet(flight.vehicle, flight.environment);
    QVERIFY(value(heavy, "thrust.toWeight") < value(light, "thrust.toWeight"));
    QVERIFY(value(heavy, "hover.throttle") > value(light, "hover.throttle"));
    QVERIFY(near(value(heavy, "payload.most") + 0.4, value(light, "payload.most"), 1e-6));
  }

  void everyFigureIsComplete() {
    const Flight flight = flightOf("f450-hover-and-steps");
    for (const auto& f : performanceSheet(flight.vehicle, flight.environment).figures) {
      QVERIFY2(!f.label.empty() && !f.symbol.empty() && !f.formula.empty(), f.key.c_str());
      QVERIFY2(f.unit == f.shownUnit || unitsLike(f.unit).size() > 1, f.key.c_str());
      QVERIFY2(std::isfinite(f.value) || !f.note.empty(), f.key.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(TestPerformance)
#include "test_performance.moc"
