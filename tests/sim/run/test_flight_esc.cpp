// Speed controllers in whole flights: dead time to the instant, runs cut in two, the same hover
// with a lag, warnings, and files from before.
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <array>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/drive_stand.h"
#include "sim/document/flight.h"
#include "sim/io/json_schema.h"
#include "sim/run/preflight.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/finished_run.h"
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

/// From rest in weightlessness, the motors on voltages: nothing moves before the first of them at
/// 0.1 s.
Experiment voltageFlight(const EscParameters& esc) {
  Experiment e;
  Flight flight;
  std::get<EqualRotors>(flight.vehicle.rotors).rotor.esc = esc;
  flight.environment.gravity = 0;
  flight.start.rotors = RotorStart::Stopped;
  TableInputs<MotorVoltageQuantity> table;
  table.rows = {{0, {0, 0, 0, 0}}, {0.1, {6, 5, 6, 5}}, {0.3, {2, 3, 2, 3}}};
  flight.control = VoltageInputs{table};
  flight.duration = 0.5;
  e.setup = flight;
  return e;
}

/// A shipped flight of `seconds` with its rotors' speed controllers changed.
Experiment shippedWith(const char* name, const EscParameters& esc, double seconds) {
  Experiment e = withQuickMaps(shipped(name));
  rotorOf(e).esc = esc;
  flightOf(e).duration = seconds;
  return e;
}

}  // namespace

class TestFlightEsc : public QObject {
  Q_OBJECT
 private slots:
  /// A command waits for the dead time, to the instant and not to the tick; nothing else changes.
  void deadTimeShiftsTheFlight_data() {
    QTest::addColumn<double>("deadTime");
    QTest::addColumn<ode::Method>("method");
    QTest::addColumn<double>("allowed");  // part of the largest speed
    // Between two rows 1 ms apart a straight line leaves h^2/8 of the second derivative.
    const auto exponential = ode::Method::ExponentialRk4, adaptive = ode::Method::Rk547M;
    QTest::addRow("whole ticks") << 0.02 << exponential << 1e-9;
    QTest::addRow("between ticks") << 0.0203 << exponential << 2e-3;
    QTest::addRow("less than a tick") << 0.0004 << exponential << 2e-3;
    QTest::addRow("between ticks, adaptive") << 0.0203 << adaptive << 2e-3;
  }
  void deadTimeShiftsTheFlight() {
    QFETCH(double, deadTime);
    QFETCH(ode::Method, method);
    QFETCH(double, allowed);
    Experiment e = voltageFlight({.responseTime = 0.01});
    flightOf(e).solver = {.method = method, .step = 1e-3};
    const auto plain = finished(e);
    rotorOf(e).esc.deadTime = deadTime;
    const auto late = finished(e);
    const Recording &a = run(*plain, "Flight"), &b = run(*late, "Flight");
    const auto ticks = static_cast<std::size_t>(std::floor(deadTime / 1e-3 + 1e-9));
    const double part = deadTime / 1e-3 - static_cast<double>(ticks);
    for (const char* name : {"rotor1.speed", "rotor2.duty", "rotor1.current", "position.z"}) {
      const std::size_t c = *a.find(name);
      double most = 0, size = 0;
      for (std::size_t row = ticks + 1; row < b.rows(); ++row) {
        const double after = a.value(c, row - ticks), before = a.value(c, row - ticks - 1);
        const double expected = after + part * (before - after);
        most = std::max(most, std::abs(b.value(c, row) - expected));
        size = std::max(size, std::abs(expected));
      }
      // A current follows within L/R = 0.43 ms: straight lines say nothing about it.
      if (part > 1e-9 && std::string(name) == "rotor1.current") continue;
      QVERIFY2(size > 0 && most < allowed * size,
               qPrintable(QString("%1: %2 of %3").arg(name).arg(most).arg(size)));
    }
    // The duty at a row t is that of a command that acts since 0.1 s + deadTime.
    const std::size_t duty = *b.find("rotor1.duty");
    for (const std::size_t row : {100 + ticks, 102 + ticks, 150 + ticks}) {
      const double since = b.value(0, row) - 0.1 - deadTime;
      const double expected = since > 0 ? 6 / 11.1 * -std::expm1(-since / 0.01) : 0;
      QVERIFY2(std::abs(b.value(duty, row) - expected) < 1e-5,
               qPrintable(QString("%1: %2 for %3").arg(row).arg(b.value(duty, row)).arg(expected)));
    }
  }

  /// Rotors each with their own dead time.
  void everyRotorWaitsForItself() {
    Experiment e = voltageFlight({.responseTime = 0});
    IndividualRotors rotors;
    const std::array<double, 4> deadTimes{0, 0.0105, 0.02, 0.0301};
    for (std::size_t i = 0; i < 4; ++i) rotors.rotors[i].esc.deadTime = deadTimes[i];
    flightOf(e).vehicle.rotors = rotors;
    const auto simulation = finished(e);
    const Recording& r = run(*simulation, "Flight");
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t duty = *r.find("rotor" + std::to_string(i + 1) + ".duty");
      std::size_t first = 0;
      while (!(r.value(duty, first) > 0)) ++first;
      QCOMPARE(first, static_cast<std::size_t>(std::ceil((0.1 + deadTimes[i]) / 1e-3 - 1e-6)));
    }
  }

  /// The rows of a run do not depend on the slices it is advanced in.
  void cutInTwoIsOneRun_data() {
    QTest::addColumn<EscParameters>("esc");
    QTest::addColumn<ode::Method>("method");
    const EscParameters all{
        .responseTime = 0.004, .deadTime = 0.0013, .maxCurrent = 15, .activeBraking = false};
    QTest::addRow("exponential") << all << ode::Method::ExponentialRk4;
    QTest::addRow("ABM4") << all << ode::Method::Abm4;
    QTest::addRow("adaptive") << all << ode::Method::Rk547M;
    QTest::addRow("reversible") << EscParameters{.responseTime = 0,
                                                 .deadTime = 0.0005,
                                                 .reverse = true}
                                << ode::Method::ExponentialRk4;
  }
  void cutInTwoIsOneRun() {
    QFETCH(EscParameters, esc);
    QFETCH(ode::Method, method);
    Experiment e = shippedWith("f450-hover-and-steps", esc, 1.5);
    flightOf(e).solver.method = method;
    flightOf(e).solver.step = method == ode::Method::Abm4 ? 1e-4 : 1e-3;
    const auto whole = runToEnd(e, 100000), cut = runToEnd(e, 7);
    QCOMPARE(whole->state(), SimulationState::Finished);
    const Recording &a = *whole->runs().front().recording, &b = *cut->runs().front().recording;
    QCOMPARE(a.rows(), b.rows());
    QCOMPARE(a.rows(), std::size_t{1501});
    for (std::size_t c = 0; c < a.channels().size(); ++c) {
      for (std::size_t row = 0; row < a.rows(); ++row) {
        const double x = a.value(c, row), y = b.value(c, row);
        QVERIFY2(x == y || (std::isnan(x) && std::isnan(y)), a.channels()[c].name.c_str());
      }
    }
  }

  /// A lag changes how a flight gets to its hover, not the hover.
  void lagKeepsTheHover_data() {
    QTest::addColumn<EscParameters>("esc");
    QTest::addRow("lag") << EscParameters{.resistance = 0, .responseTime = 0.01};
    QTest::addRow("lag and dead time")
        << EscParameters{.resistance = 0, .responseTime = 0.01, .deadTime = 0.0025};
    QTest::addRow("passive") << EscParameters{
        .resistance = 0, .responseTime = 0.01, .activeBraking = false};
  }
  void lagKeepsTheHover() {
    QFETCH(EscParameters, esc);
    Experiment plain = shippedWith("battery-flight", {.resistance = 0, .responseTime = 0}, 9);
    alternative<ControlledInputs>(flightOf(plain).control).setPoints = {{0, 0, 0, 0, 0},
                                                                        {0.5, 1, 0, 0, 0}};
    Experiment lagged = plain;
    rotorOf(lagged).esc = esc;
    const auto a = finished(plain), b = finished(lagged);
    const Recording &r = run(*a, "Flight"), &s = run(*b, "Flight");
    const std::size_t last = r.rows() - 1;
    for (const char* name : {"rotor1.speed", "rotor1.duty", "rotor1.current", "position.z"}) {
      const double x = value(r, name, last), y = value(s, name, last);
      QVERIFY2(std::abs(y / x - 1) < 1e-4, qPrintable(QString("%1 %2 %3").arg(name).arg(x).arg(y)));
    }
    // On the way there the duty is not what it was.
    double apart = 0;
    for (std::size_t row = 0; row < r.rows(); ++row)
      apart =
          std::max(apart, std::abs(value(r, "rotor1.duty", row) - value(s, "rotor1.duty", row)));
    QVERIFY(apart > 0.01);
  }

  /// Nothing of the battery's energy comes back to it where the speed controllers let go.
  void passiveFlightNeverCharges() {
    const EscParameters passive{.resistance = 0, .responseTime = 0.005, .activeBraking = false};
    Experiment e = shippedWith("battery-flight", passive, 3);
    alternative<ControlledInputs>(flightOf(e).control).setPoints = {{0, 0, 0, 0, 0},
                                                                    {1, -2, 0, 0, 0}};
    const auto passiveRun = finished(e);
    rotorOf(e).esc.activeBraking = true;
    const auto brakingRun = finished(e);
    const auto leastCurrent = [](const Simulation& simulation) {
      const Recording& r = run(simulation, "Flight");
      double least = 100;
      for (std::size_t row = 0; row < r.rows(); ++row)
        for (const char* name : {"rotor1.current", "rotor3.current", "supply.current"})
          least = std::min(least, value(r, name, row));
      return least;
    };
    QVERIFY2(leastCurrent(*passiveRun) >= 0,
             qPrintable(QString::number(leastCurrent(*passiveRun))));
    QVERIFY(leastCurrent(*brakingRun) < -0.5);
  }

  void warnings_data() {
    QTest::addColumn<EscParameters>("esc");
    QTest::addColumn<ode::Method>("method");
    QTest::addColumn<QString>("path");  // empty: none
    const auto exponential = ode::Method::ExponentialRk4, rk4 = ode::Method::Rk4;
    const EscParameters brief{.responseTime = 2e-5};
    QTest::addRow("lag far below the step, exponential") << brief << exponential << "";
    QTest::addRow("lag far below the step, RK4") << brief << rk4 << "setup.solver.step";
    QTest::addRow("lag beyond the controller") << EscParameters{.responseTime = 0.02} << exponential
                                               << "setup.vehicle.rotors.rotor.esc.responseTime";
    QTest::addRow("dead time beyond the controller")
        << EscParameters{.responseTime = 0, .deadTime = 0.02} << exponential
        << "setup.vehicle.rotors.rotor.esc.deadTime";
    QTest::addRow("as the library's are")
        << EscParameters{.resistance = 0.005, .responseTime = 0.01} << exponential << "";
  }
  void warnings() {
    QFETCH(EscParameters, esc);
    QFETCH(ode::Method, method);
    QFETCH(QString, path);
    Experiment e = shippedWith("f450-hover-and-steps", esc, 0.2);
    flightOf(e).solver.method = method;
    const auto problems = preflight(e);
    QCOMPARE(problems.size(), std::size_t(path.isEmpty() ? 0 : 1));
    if (path.isEmpty()) {
      QCOMPARE(runToEnd(e)->state(), SimulationState::Finished);
      return;
    }
    QVERIFY(problems.front().warning);
    QCOMPARE(QString::fromStdString(problems.front().path), path);
    if (method != rotorbench::ode::Method::Rk4) return;
    const auto message = QString::fromStdString(problems.front().message());
    QVERIFY2(message.contains("response time, 50000 1/s"), qPrintable(message));
    // At the step it names the warning is gone.
    // (2.7e-5 s does, but no controller's rate fits it.)
    flightOf(e).solver.step = flightOf(e).tick = 2.5e-5;
    QVERIFY(preflight(e).empty());
  }

  /// What a file does not say of a rotor's speed controller is as it was before flights knew of it.
  void oldFiles_data() {
    QTest::addColumn<QString>("esc");
    QTest::addColumn<EscParameters>("expected");
    const EscParameters none{.resistance = 0, .responseTime = 0};
    EscParameters given = none;
    given.resistance = 0.012;
    given.maxCurrent = 25;
    QTest::addRow("nothing said") << "" << none;
    QTest::addRow("resistance and limit")
        << R"("esc": {"resistance": "12 mOhm", "maxCurrent": 25})" << given;
  }
  void oldFiles() {
    QFETCH(QString, esc);
    QFETCH(EscParameters, expected);
    const QString file =
        R"({"rotorbench": 1, "setup": {"type": "flight", "vehicle": {"rotors": {"type": "equal", "rotor": {%1}}}}})";
    Experiment e = readExperiment(file.arg(esc).toStdString(), "old.json");
    QVERIFY(rotorOf(e).esc == expected);
    QVERIFY(!expected.reverse && expected.activeBraking && expected.deadTime == 0);
    QVERIFY(readExperiment(writeExperiment(e), "again.json") == e);
  }

  /// What a file leaves out of a speed controller it describes is ideal, on a rotor and on a stand:
  /// the stand's own 5 mOhm and 10 ms are those of one that is left out whole.
  void schemaKnowsWhatIsLeftOut() {
    const std::string text = jsonSchema(schema::typeOf<Experiment>());
    const auto definitions =
        QJsonDocument::fromJson(QByteArray::fromStdString(text)).object()["$defs"].toObject();
    const auto defaultOf = [&](const char* owner, const char* key) {
      const QString reference = definitions[owner]["properties"]["esc"]["$ref"].toString();
      const QJsonValue esc = definitions[reference.section(QLatin1Char('/'), -1)];
      return esc["properties"][key]["default"].toDouble(-1);
    };
    QCOMPARE(defaultOf("rotor", "responseTime"), 0.0);
    QCOMPARE(defaultOf("rotor", "resistance"), 0.0);
    QCOMPARE(defaultOf("drive-stand", "responseTime"), 0.0);
    QCOMPARE(defaultOf("drive-stand", "resistance"), 0.0);
    QCOMPARE(DriveStand{}.esc.responseTime, 0.01);
  }
};

QTEST_GUILESS_MAIN(TestFlightEsc)
#include "test_flight_esc.moc"
