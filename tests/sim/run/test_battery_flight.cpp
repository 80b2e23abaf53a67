// Flights with real propellers on a battery, as experiments: every rotor model flies, the battery
// empties, the step is warned of, and old files without a type of supply still load.
#include <QTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/run/preflight.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/quick_map.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Flight& flightOf(Experiment& e) {
  return alternative<Flight>(e.setup);
}

RotorParameters& rotorOf(Experiment& e) {
  return std::get<EqualRotors>(flightOf(e).vehicle.rotors).rotor;
}

std::vector<Problem> problemsOf(const Experiment& e) {
  return preflight(e);
}

}  // namespace

class TestBatteryFlight : public QObject {
  Q_OBJECT
 private slots:
  /// A step of height and of roll, then rest, with each model.
  void everyModelFlies_data() {
    QTest::addColumn<int>("model");
    QTest::addRow("lumped") << 0;
    QTest::addRow("measured") << 1;
    QTest::addRow("map") << 2;
    QTest::addRow("blade-element") << 3;
  }
  void everyModelFlies() {
    QFETCH(int, model);
    Experiment e = shipped("battery-flight");
    const RotorAerodynamics models[] = {PropellerCoefficients{}, MeasuredPropeller{}, quickMap(),
                                        BladeElementPropeller{}};
    rotorOf(e).aerodynamics = models[model];
    Flight& flight = flightOf(e);
    // Blade elements solved in every derivative are slow: a glance.
    const bool slow = model == 3;
    flight.duration = slow ? 0.2 : 8;
    alternative<ControlledInputs>(flight.control).setPoints = {{0, 0, 0, 0, 0}, {0.05, 1, 0, 0, 0}};
    const auto simulation = runToEnd(e);
    QVERIFY(simulation->state() == SimulationState::Finished);
    const Recording& r = *simulation->runs().front().recording;
    const std::size_t last = r.rows() - 1, z = *r.find("position.z");
    if (slow) {
      QVERIFY(r.value(z, last) > 0.001);
      return;
    }
    QVERIFY2(std::abs(r.value(z, last) - 1) < 0.01, qPrintable(QString::number(r.value(z, last))));
    QVERIFY(r.value(*r.find("supply.stateOfCharge"), last) < 1);
    QVERIFY(r.value(*r.find("supply.voltage"), last) < r.value(*r.find("supply.voltage"), 0));
  }

  /// Energy and charge of the metrics are those of the state; the time left is what a longer flight
  /// finds.
  void figuresOfTheBattery() {
    Experiment e = withQuickMaps(shipped("battery-flight"));
    Flight& flight = flightOf(e);
    auto& battery = std::get<BatteryParameters>(flight.vehicle.supply);
    battery.capacity = 200 * 3.6;
    alternative<ControlledInputs>(flight.control).setPoints = {{0, 0, 0, 0, 0}};
    flight.duration = 5;
    const auto simulation = runToEnd(e);
    const MetricTable table = simulation->metrics();
    const double energy = figure(table, "Flight", "energy");
    const double left = figure(table, "Flight", "remaining_charge");
    const double minutes = figure(table, "Flight", "minutes_left");
    QVERIFY(energy > 0 && left < 1 && left > 0.1);
    QVERIFY(std::abs(figure(table, "Flight", "mean_power") - energy / 5) < 1e-9 * energy);

    flight.duration = 300;
    const auto whole = runToEnd(e);
    QCOMPARE(whole->state(), SimulationState::Failed);
    const double end = whole->failure()->time;
    QVERIFY2(std::abs(5 + minutes * 60 - end) < 0.1 * end,
             qPrintable(QString("%1 s against %2 s").arg(5 + minutes * 60).arg(end)));
    const QString message = QString::fromStdString(whole->failure()->message);
    QVERIFY2(message.contains("battery is empty") && message.contains("cut-off of 9 V"),
             qPrintable(message));
    const Recording& r = *whole->runs().front().recording;
    QVERIFY(r.value(*r.find("supply.voltage"), r.rows() - 1) < 9);
    QVERIFY(r.value(*r.find("supply.voltage"), r.rows() - 2) >= 9);
  }

  void unstableStepsAreWarnedOf_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("resistance");
    QTest::addColumn<QString>("named");
    QTest::addRow("RK4 on a soft supply") << "rk4" << 0.05 << "fastest pole";
    QTest::addRow("Euler at 1 ms") << "euler" << 0.0 << "fastest pole";
    QTest::addRow("exponential") << "exponential-rk4" << 0.0 << "";
    QTest::addRow("exponential on a soft supply")
        << "exponential-rk4" << 0.2 << "supply resistance";
    QTest::addRow("with step control") << "rk5(4)7m" << 0.0 << "";
  }
  void unstableStepsAreWarnedOf() {
    QFETCH(QString, method);
    QFETCH(double, resistance);
    QFETCH(QString, named);
    Experiment e = shipped("f450-hover-and-steps");
    Flight& flight = flightOf(e);
    flight.vehicle.supply = SupplyParameters{.voltage = 11.1, .internalResistance = resistance};
    if (method == "rk4") flight.solver.method = ode::Method::Rk4;
    if (method == "euler") flight.solver.method = ode::Method::Euler;
    if (method == "rk5(4)7m") flight.solver.method = ode::Method::Rk547M;
    auto problems = problemsOf(e);
    // A supply as soft as one of them cannot hold the vehicle either, which is said apart.
    std::erase_if(problems, [](const Problem& p) { return p.path != "setup.solver.step"; });
    QCOMPARE(problems.size(), std::size_t(named.isEmpty() ? 0 : 1));
    if (named.isEmpty()) return;
    QVERIFY(problems.front().warning);
    QCOMPARE(problems.front().path, std::string("setup.solver.step"));
    QVERIFY2(QString::fromStdString(problems.front().message()).contains(named),
             problems.front().message().c_str());
    // At the step it names the warning is gone, and RK4 flies.
    flight.solver.step = flight.tick = 1e-4;
    flight.duration = 0.1;
    for (const Problem& problem : problemsOf(e)) QVERIFY(problem.path != "setup.solver.step");
    if (method != "rk4") return;
    QVERIFY(runToEnd(e)->state() == SimulationState::Finished);
  }

  /// Files from before the battery name no type of supply.
  void supplyWithoutType() {
    const Experiment e = readExperiment(
        R"({"rotorbench": 1, "setup": {"type": "flight", "vehicle": {"supply": {"voltage": "12.6 V", "internalResistance": 0.01}}}})",
        "old.json");
    const auto& supply = std::get<SupplyParameters>(alternative<Flight>(e.setup).vehicle.supply);
    QVERIFY(supply == (SupplyParameters{.voltage = 12.6, .internalResistance = 0.01}));
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        readExperiment(
            R"({"rotorbench": 1, "setup": {"type": "flight", "vehicle": {"supply": {"type": "nuclear"}}}})",
            "bad.json"));
  }

  /// The issue asks that a map is made when a simulation is built, never to look at a document.
  void documentsBuildNoMaps() {
    Experiment e = shipped("battery-flight");
    auto& map = std::get<MapPropeller>(rotorOf(e).aerodynamics);
    map.map.directions = 2000;
    map.map.reynoldsNumbers = 100;  // half a minute to build
    QElapsedTimer timer;
    timer.start();
    QVERIFY(problemsOf(e).empty());
    QVERIFY(readExperiment(writeExperiment(e), "again.json") == e);
    QVERIFY(timer.elapsed() < 2000);
  }
};

QTEST_GUILESS_MAIN(TestBatteryFlight)
#include "test_battery_flight.moc"
