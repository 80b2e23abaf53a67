// The thrust stand: steady points solved directly and reached in time, its procedures, what it
// refuses.
#include <QtTest>
#include <cmath>

#include "sim/document/experiment_file.h"
#include "sim/document/thrust_stand.h"
#include "sim/run/drive_build.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

/// A stand whose battery hardly runs down, so that points that are reached stay.
ThrustStand lastingStand() {
  ThrustStand stand;
  BatteryParameters battery;
  battery.capacity = 1e7;
  battery.polarisationTime = 0.05;
  stand.stand.supply = battery;
  stand.procedure = ThrottleLevels{{{0.2}, {0.5}, {0.8}, {1.0}, {0.4}}, 2};
  return stand;
}

Experiment experimentOf(const ThrustStand& stand) {
  Experiment experiment;
  experiment.setup = stand;
  return experiment;
}

std::vector<double> column(const Recording& r, const char* channel) {
  std::vector<double> values;
  for (std::size_t row = 0; row < r.rows(); ++row) values.push_back(value(r, channel, row));
  return values;
}

}  // namespace

class TestThrustStandKind : public QObject {
  Q_OBJECT
 private slots:
  void solvedAndReachedAgree_data() {
    QTest::addColumn<bool>("blades");
    QTest::addColumn<bool>("quasiStatic");
    QTest::addColumn<double>("deadTime");
    QTest::addRow("coefficients") << false << false << 0.0;
    QTest::addRow("blade elements") << true << false << 0.0;
    QTest::addRow("quasi-static current") << false << true << 0.0;
    QTest::addRow("dead time") << false << false << 0.0123;
  }
  /// Two seconds are dozens of the drive's time constants; what is left is the solver and the sag
  /// of the battery.
  void solvedAndReachedAgree() {
    QFETCH(bool, blades);
    QFETCH(bool, quasiStatic);
    QFETCH(double, deadTime);
    ThrustStand stand = lastingStand();
    if (blades) stand.stand.load = BladeElementLoad{};
    stand.stand.quasiStaticCurrent = quasiStatic;
    stand.stand.esc.deadTime = deadTime;
    const auto simulation = finished(experimentOf(stand));
    const Recording& r = run(*simulation, "Steady points");
    QCOMPARE(r.rows(), std::size_t{5});
    QCOMPARE(column(r, "reading.time"), (std::vector<double>{2, 4, 6, 8, 10}));
    QCOMPARE(column(r, "steady.throttle"), (std::vector<double>{0.2, 0.5, 0.8, 1, 0.4}));
    for (const char* name :
         {"speed", "thrust", "torque", "supply_voltage", "supply_current", "motor_current",
          "electrical_power", "shaft_power", "efficiency", "thrust_per_power"}) {
      for (std::size_t row = 0; row < r.rows(); ++row) {
        const double solved = value(r, std::string("steady.") + name, row);
        const double reached = value(r, std::string("reached.") + name, row);
        QVERIFY(solved > 0);
        QVERIFY2(std::abs(reached / solved - 1) < 1e-6,
                 qPrintable(QString("%1 %2: %3").arg(name).arg(row).arg(reached / solved - 1)));
      }
    }
    QVERIFY(figure(*simulation, "steady_difference") < 1e-6);
    QVERIFY(figure(*simulation, "peak_ledger_residual") <
            1e-9 * figure(*simulation, "full_electrical_power"));
  }

  /// Held too short, the drive is not there yet: the figure says so.
  void shortStepsAreSeen() {
    ThrustStand stand = lastingStand();
    std::get<ThrottleLevels>(stand.procedure).holdTime = 0.05;
    const auto simulation = finished(experimentOf(stand));
    QVERIFY(figure(*simulation, "steady_difference") > 0.05);
  }

  /// Full throttle in the metrics, at the end of the curve and reached on the stand is one point;
  /// powers and ratios are those of what stands beside them.
  void fullThrottleIsOnePoint() {
    ThrustStand stand = lastingStand();
    stand.stand.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.01};
    const auto simulation = finished(experimentOf(stand));
    const Recording& curve = run(*simulation, "Over throttle");
    const Recording& points = run(*simulation, "Steady points");
    const std::size_t last = curve.rows() - 1;
    QCOMPARE(value(curve, "over_throttle.throttle", last), 1.0);
    QCOMPARE(value(curve, "over_throttle.thrust", last), figure(*simulation, "full_thrust"));
    QCOMPARE(value(curve, "over_throttle.thrust", last), value(points, "steady.thrust", 3));
    for (std::size_t row = 1; row < curve.rows(); ++row) {
      const auto at = [&](const char* name) {
        return value(curve, std::string("over_throttle.") + name, row);
      };
      QVERIFY(std::abs(at("electrical_power") - at("supply_voltage") * at("supply_current")) <
              1e-12 * at("electrical_power"));
      QVERIFY(std::abs(at("shaft_power") - at("torque") * at("speed")) < 1e-12 * at("shaft_power"));
      QVERIFY(std::abs(at("efficiency") * at("electrical_power") - at("shaft_power")) < 1e-9);
      QVERIFY(std::abs(at("thrust_per_power") * at("electrical_power") - at("thrust")) < 1e-9);
      QVERIFY(std::abs(at("supply_voltage") - (11.1 - 0.01 * at("supply_current"))) < 1e-9);
      QVERIFY(at("efficiency") < 1);
      QVERIFY(at("thrust") > value(curve, "over_throttle.thrust", row - 1));
    }
  }

  /// A sweep lags behind the steady points by its speed times the drive's time constant: ten times
  /// slower, ten times less.
  void slowSweepLagsLess() {
    ThrustStand stand = lastingStand();
    stand.stand.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.01};
    const auto lag = [&](double duration) {
      stand.procedure = ThrottleSweep{.from = 0.3, .to = 1, .duration = duration, .readings = 7};
      const auto simulation = finished(experimentOf(stand));
      const Recording& r = run(*simulation, "Steady points");
      if (r.rows() != 7) qFatal("%zu readings", r.rows());
      if (value(r, "reading.time", 3) != duration * 4 / 7) {
        // The end of the tick it fell into.
        if (std::abs(value(r, "reading.time", 3) - duration * 4 / 7) > 1.001e-3) qFatal("time");
      }
      return value(r, "steady.speed", 3) - value(r, "reached.speed", 3);
    };
    const double quick = lag(2), slow = lag(20);
    QVERIFY2(quick > 0 && slow > 0, qPrintable(QString("%1 %2").arg(quick).arg(slow)));
    QVERIFY2(quick / slow > 8 && quick / slow < 12, qPrintable(QString::number(quick / slow)));
  }

  void timelineIsReadWhereRowsEnd() {
    ThrustStand stand = lastingStand();
    stand.procedure = ThrottleRows{{{0, 0.3}, {0.5, 0.6}, {1.2, 0.9}}, Interpolation::Hold, 2};
    const auto simulation = finished(experimentOf(stand));
    const Recording& r = run(*simulation, "Steady points");
    QCOMPARE(column(r, "reading.time"), (std::vector<double>{0.5, 1.2, 2}));
    QCOMPARE(column(r, "reached.throttle"), (std::vector<double>{0.3, 0.6, 0.9}));
    const Recording& whole = run(*simulation, "Run");
    QCOMPARE(value(whole, "time", whole.rows() - 1), 2.0);
  }

  void contradictionsAreRefused_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("path");
    QTest::addRow("brake") << R"("stand": {"load": {"type": "brake"}})"
                           << "setup.stand.load";
    QTest::addRow("free shaft") << R"("stand": {"load": {"type": "free"}})"
                                << "setup.stand.load";
    QTest::addRow("tick")
        << R"("procedure": {"type": "sweep", "duration": 0.5}, "run": {"tick": 1})"
        << "setup.run.tick";
    QTest::addRow("method") << R"("run": {"solver": {"method": "exponential-rk4"}})"
                            << "setup.run.solver.method";
    QTest::addRow("no levels") << R"("procedure": {"type": "levels", "levels": []})"
                               << "setup.procedure.levels";
    QTest::addRow("times")
        << R"("procedure": {"type": "rows", "rows": [{"time": 1, "throttle": 0}, {"time": 1, "throttle": 1}]})"
        << "setup.procedure.rows[1].time";
  }
  void contradictionsAreRefused() {
    QFETCH(QString, json);
    QFETCH(QString, path);
    const QString text = R"({"rotorbench": 1, "setup": {"type": "thrust-stand", )" + json + "}}";
    try {
      readExperiment(text.toStdString(), "x.json");
      QFAIL("accepted");
    } catch (const InputError& error) {
      QCOMPARE(QString::fromStdString(error.problems().front().path), path);
    }
  }

  /// The warning of a step that is too long is made with few points of a propeller; it is the same
  /// as with the many of the run to a part in a hundred.
  void warningWithFewPoints() {
    ThrustStand stand = lastingStand();
    stand.stand.load = BladeElementLoad{};
    stand.stand.quasiStaticCurrent = true;  // here the propeller makes much of the pole
    stand.stand.esc.responseTime = 0;
    stand.run.tick = 1;
    stand.run.solver.step = 1;
    const auto warnings = warningsOf(experimentOf(stand));
    QCOMPARE(warnings.size(), std::size_t{1});
    const DriveTrain exact = buildDriveTrain(stand.stand);
    const double top = exact.steadySpeed(exact.supply().openCircuit(1.0));
    const double limit = 2.785e6 / std::max(exact.fastestPole(0), exact.fastestPole(top));
    const QString said = QString::fromStdString(warnings.front().message());
    const QRegularExpressionMatch match = QRegularExpression("at most ([\\d.]+) us").match(said);
    QVERIFY2(match.hasMatch(), qPrintable(said));
    QVERIFY2(std::abs(match.captured(1).toDouble() / limit - 1) < 0.01, qPrintable(said));
  }
};

QTEST_APPLESS_MAIN(TestThrustStandKind)
#include "test_thrust_stand_kind.moc"
