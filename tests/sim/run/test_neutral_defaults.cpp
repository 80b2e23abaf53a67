// What a file does not name is zero or has no effect: it is never a figure of another product. The
// flights below are worked out by hand; the figures of the shipped parts are those their own
// sources publish, and stand in their files.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>
#include <limits>
#include <map>

#include "sim/document/drive_stand.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/io/file.h"
#include "sim/io/json_schema.h"
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
  void describedPartsHaveNothingOfTheDefaultVehicle();
  void whatHasNoNeutralValueMustBeGiven_data();
  void whatHasNoNeutralValueMustBeGiven();
  void shippedFilesStateTheirFigures();
  void fullCellHas420();
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

/// k_d, k_z, k_h, k_flap as published, where they are.
void TestNeutralDefaults::shippedRotorsHaveTheirOwnInflow() {
  const RotorInflow hummingbird{1.19e-4, 2.32e-4, 3.39e-3, 0};  // RotorPy, hummingbird_params.py
  const RotorInflow crazyflie{1.025e-6, 7.55e-7, 0, 0};         // RotorPy, crazyflie_params.py
  // gym-pybullet-drones, assets/cf2x.urdf, from Foerster 2015: drag_coeff_xy, drag_coeff_z
  const RotorInflow foerster{9.1785e-7, 1.0311e-6, 0, 0};
  // RotorS, hummingbird.xacro, and the loss of thrust RotorPy has for the same vehicle
  const RotorInflow rotors{8.06428e-5, 2.32e-4, 0, 0};
  const std::map<std::string, RotorInflow> published{
      {"AscTec Hummingbird rotor (RotorPy)", hummingbird},
      {"AscTec Hummingbird (RotorPy)", hummingbird},
      {"Crazyflie 2.x rotor (RotorPy)", crazyflie},
      {"Crazyflie 2.x (RotorPy)", crazyflie},
      {"Crazyflie Brushless with guards (RotorPy)", {5.09e-6, 1.19e-5, 1.11e-3, 0}},
      {"Crazyflie 2.x (gym-pybullet-drones)", foerster},
      {"Crazyflie 2 (RotorS)", foerster},
      {"Crazyflie 2.1 (Bitcraze)", foerster},
      {"Crazyflie 2.1 stock propeller (Bitcraze)", foerster},
      {"RotorS 8.55e-6 rotor", rotors},
      {"AscTec Hummingbird (RotorS)", rotors}};
  std::size_t checked = 0, found = 0;
  for (const LibraryEntry& entry : shipped().entries()) {
    const RotorCoefficients* c = coefficientsOf(entry.component);
    if (c == nullptr) continue;
    ++checked;
    const auto own = published.find(entry.component.info.name);
    found += own != published.end() ? 1 : 0;
    if (own != published.end())
      QVERIFY2(c->inflow == own->second, entry.component.info.name.c_str());
    QVERIFY2(c->inflow.drag > 0 && c->inflow.inflow > 0, entry.component.info.name.c_str());
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
  QCOMPARE(most, 154.0);  // T18 octorotor (FSC Lab)
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

/// A file that describes a part by half has the rest of it neutral; a part it leaves out whole is
/// the default vehicle's whole.
void TestNeutralDefaults::describedPartsHaveNothingOfTheDefaultVehicle() {
  const auto rotorOf = [](const Experiment& e) {
    const auto& vehicle = alternative<Flight>(e.setup).vehicle;
    return std::get<EqualRotors>(vehicle.rotors).rotor;
  };
  const Experiment e = readExperiment(
      R"({"rotorbench":1,"setup":{"type":"flight","vehicle":{"rotors":{"type":"equal","rotor":{
        "aerodynamics":{"type":"propeller","thrustCoefficient":0.1,"powerCoefficient":0.04,
          "diameter":0.3},
        "motor":{"speedConstant":50,"resistance":0.2},"esc":{"maxCurrent":25}}},"drag":{}}}})",
      "half.json");
  const RotorParameters rotor = rotorOf(e);
  QCOMPARE(rotor.motor.noLoadCurrent, 0.0);
  QCOMPARE(rotor.motor.maxCurrent, kMostCurrentLimit);
  QVERIFY(rotor.esc == EscParameters{.maxCurrent = 25});
  QCOMPARE(rotor.esc.resistance + rotor.esc.responseTime, 0.0);
  QVERIFY(std::get<PropellerCoefficients>(rotor.aerodynamics).inflow == RotorInflow{});
  QVERIFY(alternative<Flight>(e.setup).vehicle.drag == BodyDrag{});
  QCOMPARE(BodyDrag{}.linear, 0.0);
  // Whole: the E305 with its own limit.
  const Experiment whole =
      readExperiment(R"({"rotorbench":1,"setup":{"type":"flight"}})", "whole.json");
  QVERIFY(rotorOf(whole).motor == djiE305());
  QCOMPARE(rotorOf(whole).motor.maxCurrent, 20.0);
  QCOMPARE(alternative<Flight>(whole.setup).vehicle.avionicsPower, 0.0);
}

void TestNeutralDefaults::whatHasNoNeutralValueMustBeGiven_data() {
  QTest::addColumn<QString>("rotor");
  QTest::addColumn<QString>("path");
  QTest::addRow("speed constant") << R"("motor":{"resistance":0.1})"
                                  << "motor.speedConstant";
  QTest::addRow("resistance") << R"("motor":{"speedConstant":"920 rpm/V"})"
                              << "motor.resistance";
  QTest::addRow("torque") << R"("aerodynamics":{"type":"coefficients","thrust":1e-5})"
                          << "aerodynamics.torque";
  QTest::addRow("diameter")
      << R"("aerodynamics":{"type":"propeller","thrustCoefficient":0.1,"powerCoefficient":0.04})"
      << "aerodynamics.diameter";
}
void TestNeutralDefaults::whatHasNoNeutralValueMustBeGiven() {
  QFETCH(QString, rotor);
  QFETCH(QString, path);
  const std::string text =
      R"({"rotorbench":1,"setup":{"type":"flight","vehicle":{"rotors":{"type":"equal","rotor":{)" +
      rotor.toStdString() + "}}}}}";
  try {
    readExperiment(text, "half.json");
    QFAIL("accepted");
  } catch (const InputError& error) {
    QCOMPARE(error.problems().size(), std::size_t{1});
    QCOMPARE(error.problems().front().path, "setup.vehicle.rotors.rotor." + path.toStdString());
    QCOMPARE(error.problems().front().what, std::string("this key is missing"));
  }
  const QString schema = QString::fromStdString(jsonSchema(schema::typeOf<Experiment>()));
  const auto definitions = QJsonDocument::fromJson(schema.toUtf8()).object()["$defs"].toObject();
  const QString part = path.section('.', 0, 0), key = path.section('.', 1);
  const QString name = part == "motor"                  ? part
                       : rotor.contains("coefficients") ? "coefficients"
                                                        : "propeller";
  QVERIFY(definitions[name].toObject()["required"].toArray().contains(key));
}

/// Whatever a flight with it leans on stands in the file itself and not in a default.
void TestNeutralDefaults::shippedFilesStateTheirFigures() {
  const std::map<std::string, std::vector<const char*>> figures{
      {"motor", {"speedConstant", "resistance", "inductance", "noLoadCurrent", "maxCurrent"}},
      {"esc", {"resistance", "responseTime", "maxCurrent"}},
      {"battery", {"series", "capacity", "resistance", "polarisation"}},
      {"propeller-coefficients", {"thrustCoefficient", "powerCoefficient", "diameter", "inflow"}},
      {"rotor-coefficients", {"thrust", "torque", "diameter", "inflow"}},
      {"airframe",
       {"layout", "arm", "height", "aerodynamics", "diameter", "inflow", "inertia", "mass",
        "speedConstant", "resistance", "inductance", "noLoadCurrent", "maxCurrent", "drag",
        "supply"}}};
  std::size_t files = 0;
  for (const LibraryEntry& entry : shipped().entries()) {
    const auto listed = figures.find(kindOf(*entry.component.type)->key);
    if (listed == figures.end()) continue;
    const std::string text = readTextFile(entry.file);
    for (const std::string figure : listed->second) {
      const bool free = text.find("\"free\"") != std::string::npos;
      if (free && (figure == "arm" || figure == "height")) continue;
      QVERIFY2(text.find("\"" + figure + "\":") != std::string::npos,
               (entry.component.info.name + " states no " + figure).c_str());
    }
    ++files;
  }
  QVERIFY2(files > 50, qPrintable(QString::number(files)));
}

/// A lithium-polymer cell is charged to 4.20 V; Chen's was charged to 4.10 V.
void TestNeutralDefaults::fullCellHas420() {
  const auto full = [](const BatteryParameters& b) {
    return Supply(b).openCircuit(1.0) / b.series;
  };
  QVERIFY(std::abs(full({}) - 4.2) < 1e-3);
  QVERIFY(std::abs(Supply(BatteryParameters{}).openCircuit(0.0) / 3 - 2.654) < 1e-3);
  std::size_t checked = 0;
  for (const LibraryEntry& entry : shipped().entries()) {
    const auto* battery = entry.component.as<BatteryParameters>();
    if (battery == nullptr) continue;
    const bool chen = entry.component.info.name.find("Chen") != std::string::npos;
    QVERIFY2(std::abs(full(*battery) - (chen ? 4.103 : 4.2)) < 1e-3,
             entry.component.info.name.c_str());
    ++checked;
  }
  QVERIFY(checked >= 9);
}

QTEST_APPLESS_MAIN(TestNeutralDefaults)
#include "test_neutral_defaults.moc"
