// What a flight came to that nobody asked for, and whether its vehicle can hover at all.
#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/run/flight_watch.h"
#include "sim/run/preflight.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

constexpr double kTick = 0.01;

/// Verdicts of a flight of ten seconds whose height and yaw are given over time, both to be held at
/// `wanted`.
struct Course {
  double (*height)(double t) = [](double) { return 2.0; };
  double (*yaw)(double t) = [](double) { return 0.0; };
  double (*tilt)(double t) = [](double) { return 0.0; };
  double (*wantedHeight)(double t) = [](double) { return 2.0; };
  double seconds = 10;
};

std::vector<Verdict> watched(const Course& c) {
  Board board;
  FlightWatch watch({{"altitude", "position.z", "setpoint.z", 1, false,
                      [](const SetPoint& s) -> const double& { return s.height; },
                      [](const Truth& t) -> const double& { return t.body.position[2]; }},
                     {"yaw", "attitude.yaw", "setpoint.yaw", 0.5, true,
                      [](const SetPoint& s) -> const double& { return s.yaw; },
                      [](const Truth& t) -> const double& { return t.body.attitude[2]; }}},
                    board);
  for (int k = 0; k * kTick <= c.seconds; ++k) {
    const double t = k * kTick;
    board.truth.body.position[2] = c.height(t);
    board.truth.body.attitude[2] = std::remainder(c.yaw(t), 2 * std::numbers::pi);
    board.truth.tiltCosine = std::cos(c.tilt(t));
    board.setPoint.height = c.wantedHeight(t);
    watch.see(t);
  }
  return watch.verdicts();
}

Flight& flightOf(Experiment& e) {
  return alternative<Flight>(e.setup);
}

/// case 07 of the checks from outside: 5 kg hung below the F450.
Experiment overloaded() {
  Experiment e = shipped("f450-hover-and-steps");
  flightOf(e).vehicle.payloads = {{5, {0, 0, -0.1}}};
  flightOf(e).duration = 5;
  return e;
}

const Problem* at(const std::vector<Problem>& problems, const std::string& path) {
  const auto found = std::ranges::find(problems, path, &Problem::path);
  return found == problems.end() ? nullptr : &*found;
}

}  // namespace

class TestFlightWatch : public QObject {
  Q_OBJECT
 private slots:
  void whatIsAskedForIsNoVerdict() {
    QVERIFY(watched({}).empty());
    // A step up of 8 m, reached slowly; a dip of 5 cm at the start; whole turns of the set-point's
    // frame.
    QVERIFY(watched({.height = [](double t) { return t < 0.3 ? -0.05 : std::min(10.0, 2 * t); },
                     .wantedHeight = [](double t) { return t < 0.5 ? 0.0 : 10.0; }})
                .empty());
    // An overshoot within the limit, and a lag behind a ramp.
    QVERIFY(watched({.height = [](double t) { return t < 1 ? 0.0 : 3 * (t - 1); },
                     .wantedHeight = [](double t) { return 3 * t; }})
                .empty());
    // Left for a moment only by the end.
    QVERIFY(watched({.height = [](double t) { return t < 9.5 ? 2.0 : 5.0; }}).empty());
  }

  void groundAndTilt() {
    const auto fallen = watched({.height = [](double t) { return 2 - t; }, .seconds = 2.5});
    QCOMPARE(fallen.size(), std::size_t(1 + 1));
    QCOMPARE(fallen.back().name, std::string("below_ground"));
    QVERIFY(std::abs(fallen.back().time - 2.11) < 1.5 * kTick);
    const auto tumbled = watched({.tilt = [](double t) { return t < 4 ? 0.2 * t : 2.0; }});
    QCOMPARE(tumbled.size(), std::size_t(1));
    QCOMPARE(sentence(tumbled.front()), std::string("tilted beyond 90 degrees at 4 s"));
    // Started on its back: that is what was asked for, until it has been upright.
    QVERIFY(watched({.tilt = [](double) { return 3.0; }}).empty());
  }

  void setPointsLeft() {
    const auto climbed = watched({.height = [](double t) { return t < 5 ? 2.0 : 2 + (t - 5); }});
    QCOMPARE(climbed.size(), std::size_t(1));
    QCOMPARE(climbed.front().name, std::string("altitude_lost"));
    QVERIFY(std::abs(climbed.front().time - 6) < 2 * kTick);
    // A vehicle that spins passes through its set-point once a turn and has left it all the same.
    const auto spun = watched({.yaw = [](double t) { return t < 3 ? 0.0 : 5 * (t - 3); }});
    QCOMPARE(spun.size(), std::size_t(1));
    QCOMPARE(spun.front().name, std::string("yaw_lost"));
    QVERIFY(std::abs(spun.front().time - 3.1) < 2 * kTick);
  }

  /// The shipped flights do what they are told.
  void shippedFlightsAreClean_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"f450-hover-and-steps", "unbalanced-f450", "hummingbird-open-loop"})
      QTest::addRow("%s", name) << name;
  }
  void shippedFlightsAreClean() {
    QFETCH(QString, name);
    const Experiment e = shipped(name.toUtf8().constData());
    QVERIFY(preflight(e).empty());
    const auto simulation = runToEnd(e);
    for (const Verdict& verdict : simulation->verdicts()) QFAIL(sentence(verdict).c_str());
  }

  /// Thrust to weight 0.627: it falls, and both the run and the list before it say so.
  void overloadedVehicle() {
    const Experiment e = overloaded();
    const auto warnings = preflight(e);
    const Problem* hover = at(warnings, "setup.vehicle.rotors");
    QVERIFY(hover != nullptr && hover->warning);
    // 39.38 N of 62.76 N, from an independent program.
    QVERIFY2(hover->what.find("39.4 N of its 62.8 N") != std::string::npos, hover->what.c_str());
    QVERIFY2(hover->allowed.find("4.02 kg") != std::string::npos, hover->allowed.c_str());
    QVERIFY(at(warnings, "setup.start.rotors") != nullptr);

    const auto simulation = runToEnd(e);
    const auto verdicts = simulation->verdicts();
    QVERIFY(!verdicts.empty());
    const auto fell = std::ranges::find(verdicts, "below_ground", &Verdict::name);
    QVERIFY(fell != verdicts.end());
    QVERIFY(fell->time < 1);
    const MetricTable table = simulation->metrics();
    QCOMPARE(figure(table, "Flight", "below_ground"), fell->time);
  }

  /// A hover of 1166 rad/s and 36.3 A, where the motors take 20 A (weak propeller of the same
  /// checks).
  void weakPropeller() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& rotor = std::get<EqualRotors>(flightOf(e).vehicle.rotors).rotor;
    std::get<PropellerCoefficients>(rotor.aerodynamics).thrustCoefficient = 0.0245;
    const auto warnings = preflight(e);
    const Problem* start = at(warnings, "setup.start.rotors");
    QVERIFY(start != nullptr);
    for (const char* part : {"1166 rad/s", "36.3 A", "20 A"})
      QVERIFY2(start->what.find(part) != std::string::npos, start->what.c_str());
    const Problem* hover = at(warnings, "setup.vehicle.rotors");
    QVERIFY2(hover != nullptr && hover->what.find("7.49 N of its 13.7 N") != std::string::npos,
             hover == nullptr ? "" : hover->what.c_str());
  }

  /// What decides besides current: voltage, the supply's power, no air. Speeds laid down in advance
  /// ask nothing of motors.
  void otherLimits() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& supply = std::get<SupplyParameters>(flightOf(e).vehicle.supply);
    supply.voltage = 5;
    auto warnings = preflight(e);
    QVERIFY(at(warnings, "setup.vehicle.rotors") != nullptr);
    QVERIFY(at(warnings, "setup.vehicle.rotors")->what.find(" V under that load") !=
            std::string::npos);
    supply = {11.1, 1};
    warnings = preflight(e);
    QVERIFY(at(warnings, "setup.vehicle.rotors") != nullptr);
    QVERIFY(at(warnings, "setup.vehicle.rotors")->what.find("the supply gives at most 30.8 W") !=
            std::string::npos);
    flightOf(e).control = SpeedInputs{};
    QVERIFY(at(preflight(e), "setup.vehicle.rotors") == nullptr);
    flightOf(e).control = VoltageInputs{};
    QVERIFY(at(preflight(e), "setup.vehicle.rotors") == nullptr);
    QVERIFY(at(preflight(e), "setup.start.rotors") != nullptr);
  }

  /// Maps are not made to answer this: it is asked at every edit.
  void quickWithAMap() {
    Experiment e = shipped("f450-hover-and-steps");
    MapPropeller propeller;
    propeller.propeller.diameter = 0.2401234;  // no other test has made this map
    std::get<EqualRotors>(flightOf(e).vehicle.rotors).rotor.aerodynamics = propeller;
    QElapsedTimer timer;
    timer.start();
    preflight(e);
    // The map itself takes some ten times as long, and this test runs with sanitizers too.
    QVERIFY2(timer.elapsed() < 4000, qPrintable(QString::number(timer.elapsed())));
  }
};

QTEST_GUILESS_MAIN(TestFlightWatch)
#include "test_flight_watch.moc"
