// A flight that ends at the ground: the solver finds the instant between two ticks and the loop
// ends there, with a last row at that instant.
#include <QTest>
#include <cmath>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/ode/solver_settings.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;
using namespace rotorbench::test;

class TestFlightEnd : public QObject {
  Q_OBJECT
 private slots:
  void fallsAsGalileiSays_data();
  void fallsAsGalileiSays();
  void beginsOnTheGround();
  void withoutAGroundItFallsOn();
};

namespace {

/// Thrown up without air and with motors that stand still.
Experiment thrown(const char* method, const char* more) {
  return readExperiment(
      std::string(R"({"rotorbench": 1, "setup": {"type": "flight", "duration": 3, "tick": "10 ms",
    "control": {"type": "motor-voltages", "source": {"type": "constant", "voltages": [0, 0, 0, 0]}},
    "vehicle": {"drag": {"linear": 0}}, "environment": {"air": {"type": "uniform", "density": 0}},
    "start": {"position": [0, 0, 1], "velocity": [0.5, 0, 3], "rotors": "stopped"},
    "solver": {"method": ")") +
          method + R"(", "step": "5 ms"})" + more + "}}",
      "flight.json");
}

const double kLanding = (3 + std::sqrt(9 + 2 * 9.80665)) / 9.80665;

}  // namespace

void TestFlightEnd::fallsAsGalileiSays_data() {
  QTest::addColumn<QString>("method");
  for (const auto& method : ode::kMethods)
    if (method.method != ode::Method::Euler)
      QTest::addRow("%s", method.key.data()) << QString::fromStdString(std::string(method.key));
}

void TestFlightEnd::fallsAsGalileiSays() {
  QFETCH(QString, method);
  const auto flight = finished(thrown(qPrintable(method), R"(, "endsAtGround": true)"));
  const Recording& r = *flight->runs().front().recording;
  const std::size_t last = r.rows() - 1;
  QVERIFY2(std::abs(value(r, "time", last) - kLanding) < 1e-9,
           qPrintable(QString::number(value(r, "time", last) - kLanding)));
  QVERIFY(std::abs(value(r, "position.z", last)) < 1e-9);
  QVERIFY(std::abs(value(r, "position.x", last) - 0.5 * kLanding) < 1e-9);
  // The tick before is a whole one.
  QVERIFY(std::abs(value(r, "time", last - 1) - 0.01 * std::floor(kLanding / 0.01)) < 1e-9);
  QCOMPARE(figure(*flight, "end_time"), value(r, "time", last));
  QCOMPARE(flight->progress().fraction, 1.0);
  QVERIFY(flight->verdicts().empty());
}

/// A controller that starts on the ground dips before it holds the weight: that is no landing.
void TestFlightEnd::beginsOnTheGround() {
  Experiment e = loadExperiment(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  auto& flight = alternative<Flight>(e.setup);
  flight.duration = 8;
  flight.endsAtGround = true;
  QCOMPARE(figure(*finished(e), "end_time"), 8.0);
  // It comes down when it is told to.
  flight.changes = {{4, "control.byHand.height", "-1"}, {4, "control.byHand.heightByHand", "on"}};
  const auto landed = finished(e);
  QVERIFY(figure(*landed, "end_time") > 4.5 && figure(*landed, "end_time") < 7);
  const Recording& r = *landed->runs().front().recording;
  QVERIFY(std::abs(value(r, "position.z", r.rows() - 1)) < 1e-9);
}

void TestFlightEnd::withoutAGroundItFallsOn() {
  const auto flight = finished(thrown("rk4", ""));
  QCOMPARE(figure(*flight, "end_time"), 3.0);
  QCOMPARE(flight->verdicts().size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(TestFlightEnd)
#include "test_flight_end.moc"
