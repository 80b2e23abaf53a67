// What happens to a flight on its way: motors at their limits, a supply that gives out, a recording
// thinned, energy out of nothing.
#include <QTest>
#include <cmath>

#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/io/metrics_output.h"
#include "sim/run/drive_watch.h"
#include "sim/run/energy_watch.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

constexpr double kTick = 0.01;

Flight& flightOf(Experiment& e) {
  return alternative<Flight>(e.setup);
}

const RunEvent* named(const std::vector<RunEvent>& events, const std::string& name) {
  const auto found = std::ranges::find(events, name, &RunEvent::name);
  return found == events.end() ? nullptr : &*found;
}

std::string words(const std::vector<RunEvent>& events) {
  std::string all;
  for (const RunEvent& e : events) all += sentence(e) + "; ";
  return all;
}

}  // namespace

class TestFlightEvents : public QObject {
  Q_OBJECT
 private slots:
  /// Full throttle from 1 to 1.5 s with a gap of 50 ms, of two motors; a tick of it at 3 s is the
  /// edge of a step.
  void episodes() {
    Board board(4);
    DriveWatch::Limits limits{.rotors = 4, .controlled = true};
    limits.current.setConstant(20);
    DriveWatch watch(limits, board);
    for (int k = 0; k < 500; ++k) {
      const double t = k * kTick;
      board.command.value.head<4>().setConstant(0.5);
      board.truth.drives.current.head<4>().setConstant(5);
      if ((k >= 100 && k < 120) || k == 300) board.command.value[1] = 1;
      if (k >= 125 && k < 150) board.command.value[3] = 1;
      if (k >= 400 && k < 420) board.truth.drives.current[0] = -19.9;
      watch.see({t, kTick}, 11, false);
    }
    const auto events = watch.events();
    QCOMPARE(events.size(), std::size_t{2});
    QCOMPARE(sentence(events[0]), std::string("motors 2 and 4 saturated at 1 s for 0.5 s"));
    QCOMPARE(sentence(events[1]), std::string("motor 1 at the current limit at 4 s for 0.2 s"));
    QVERIFY(std::abs(watch.saturated() - 0.5) < 1e-9);
    QVERIFY(std::abs(watch.currentLimited() - 0.2) < 1e-9);
    QVERIFY(watch.verdicts().empty());
  }

  /// Full throttle laid down in advance is what was asked for; what a controller cannot have from
  /// the rotors at all is an episode of all of them.
  void whoAsks() {
    Board board(4);
    board.command.value.setConstant(1);
    DriveWatch laidDown({.rotors = 4}, board);
    DriveWatch controlled({.rotors = 4, .controlled = true}, board);
    board.command.value.setConstant(1);
    for (int k = 0; k < 100; ++k) laidDown.see({k * kTick, kTick}, 11, false);
    board.command.value.setConstant(0.5);
    for (int k = 0; k < 100; ++k) controlled.see({k * kTick, kTick}, 11, true);
    QVERIFY(laidDown.events().empty());
    QCOMPARE(words(controlled.events()), std::string("motors saturated at 0 s for 1 s; "));
  }

  /// A vehicle 40 % too heavy to be held: its motors are at their limits for as long as it falls,
  /// and figures and JSON say so.
  void overloaded() {
    Experiment e = shipped("f450-hover-and-steps");
    flightOf(e).vehicle.payloads = {{5, {0, 0, -0.1}}};
    flightOf(e).duration = 3;
    const auto simulation = runToEnd(e);
    const auto events = simulation->events();
    const RunEvent* limit = named(events, "current_limited");
    const RunEvent* full = named(events, "motors_saturated");
    QVERIFY2(limit != nullptr || full != nullptr, words(events).c_str());
    QVERIFY2(named(events, "below_ground") != nullptr, words(events).c_str());
    QVERIFY(std::ranges::is_sorted(events, {}, &RunEvent::time));
    const MetricTable table = simulation->metrics();
    QVERIFY(figure(table, "Flight", "saturated_time") > 1);
    const std::string json =
        metricsJson(e.title, {table, simulation->verdicts(), {}, simulation->events()});
    QVERIFY2(json.find("\"events\"") != std::string::npos &&
                 json.find("motors_saturated") != std::string::npos,
             json.c_str());
  }

  void calmFlight() {
    Experiment e = shipped("f450-hover-and-steps");
    alternative<ControlledInputs>(flightOf(e).control).setPoints = {{0, 0, 0, 0, 0}};
    flightOf(e).duration = 2;
    const auto simulation = runToEnd(e);
    QVERIFY2(simulation->events().empty(), words(simulation->events()).c_str());
    QVERIFY(std::isnan(figure(simulation->metrics(), "Flight", "saturated_time")));
  }

  void thinnedRecording() {
    Experiment e = shipped("f450-hover-and-steps");
    flightOf(e).duration = 5;
    e.outputs.memoryLimit = 1e6;
    const auto simulation = runToEnd(e);
    const auto events = simulation->events();
    const RunEvent* thinned = named(events, "recording_thinned");
    QVERIFY(thinned != nullptr);
    // 8 bytes a value: the first rows that fit.
    const Recording& r = *simulation->runs().front().recording;
    QVERIFY(r.stride() > 1);
    const double room = 1e6 / (8.0 * static_cast<double>(r.channels().size())) * 1e-3;
    QVERIFY2(thinned->time < 1.2 * room && thinned->time > 0.3 * room,
             qPrintable(QString::number(thinned->time)));
  }

  void emptyBattery() {
    Experiment e = shipped("f450-hover-and-steps");
    BatteryParameters battery;
    battery.capacity = 20 * 3.6;
    flightOf(e).vehicle.supply = battery;
    const auto simulation = runToEnd(e);
    QCOMPARE(simulation->state(), SimulationState::Failed);
    const auto events = simulation->events();
    const RunEvent* cutOff = named(events, "cut_off");
    QVERIFY(cutOff != nullptr);
    QCOMPARE(cutOff->time, simulation->failure()->time);
  }

  /// An internal resistance of 1 Ohm behind 11.1 V gives 30.8 W at most, and a hover takes 172 W:
  /// the bus falls to 0 V and never below, and the flight failed by it.
  void supplyGivesOut() {
    Experiment e = shipped("f450-hover-and-steps");
    Flight& flight = flightOf(e);
    flight.vehicle.supply = SupplyParameters{11.1, 1};
    flight.solver.step = flight.tick = 2e-5;
    alternative<ControlledInputs>(flight.control).motors.rate = 1000;
    flight.duration = 0.5;
    e.outputs.recordInterval = 2e-5;
    const auto simulation = runToEnd(e);
    const Recording& r = *simulation->runs().front().recording;
    double least = 11.1;
    for (std::size_t row = 0; row < r.rows(); ++row) {
      const double bus = r.value(*r.find("supply.voltage"), row);
      least = std::min(least, bus);
      QVERIFY(bus >= 0);
      QVERIFY(std::abs(bus + r.value(*r.find("supply.current"), row) - 11.1) < 1e-9);
    }
    const auto verdicts = simulation->verdicts();
    const bool gone =
        std::ranges::find(verdicts, "supply_collapsed", &Verdict::name) != verdicts.end();
    QCOMPARE(gone, least == 0);
    QVERIFY(!verdicts.empty());
  }

  /// A lumped rotor whose thrust does not fall with the climb lifts the vehicle faster and faster
  /// without taking more from the supply; with inflow it does not.
  void energyOutOfNothing() {
    Experiment e = shipped("f450-hover-and-steps");
    Flight& flight = flightOf(e);
    flight.vehicle.drag = {};
    auto& rotor = std::get<EqualRotors>(flight.vehicle.rotors).rotor;
    auto& propeller = std::get<PropellerCoefficients>(rotor.aerodynamics);
    propeller.inflow = {};
    VoltageInputs full;
    std::get<ConstantInputs<MotorVoltageQuantity>>(full.source).values =
        std::vector<double>(4, 11.1);
    flight.control = full;
    flight.duration = 60;
    const auto simulation = runToEnd(e, 10);
    QCOMPARE(simulation->state(), SimulationState::Failed);
    const RunFailure& failure = *simulation->failure();
    QCOMPARE(failure.component, std::string("energy"));
    QVERIFY2(failure.message.find("J more than they began with") != std::string::npos,
             failure.message.c_str());
    QVERIFY(failure.time < 30);
    // k_z of the size blade elements give: T/(w v) at an advance that takes all thrust.
    propeller.inflow.inflow = 4e-4;
    flight.vehicle.drag.quadratic = {0.02, 0.02, 0.05};
    QCOMPARE(runToEnd(e, 10)->state(), SimulationState::Finished);
  }

  void energyLedger() {
    EnergyWatch watch;
    QVERIFY(!watch.see(0, {.stored = 10, .moving = 10, .drawn = 0, .mass = 1}));
    // A fall: what is stored goes into the air.
    QVERIFY(!watch.see(1, {.stored = 5, .moving = 5, .drawn = 0, .mass = 1}));
    // All that was drawn, and a quarter of it more.
    QVERIFY(!watch.see(2, {.stored = 135, .moving = 5, .drawn = 100, .mass = 1}));
    const auto failure = watch.see(3, {.stored = 150, .moving = 5, .drawn = 100, .mass = 1});
    QVERIFY(failure && failure->time == 3 && failure->message.find("40 J") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(TestFlightEvents)
#include "test_flight_events.moc"
