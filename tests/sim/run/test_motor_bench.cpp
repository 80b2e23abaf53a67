// The motor's own experiments: curves against closed forms, steady points against the run, limits,
// warnings.
#include <QtTest>
#include <cmath>

#include "sim/analysis/curve_figures.h"
#include "sim/document/experiment_file.h"
#include "sim/document/motor_bench.h"
#include "sim/document/motor_speed_run.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/finished_run.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

Experiment bench(double throttle) {
  Experiment experiment;
  MotorBench m;
  m.stand.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.01};
  m.throttle = {{0, throttle}};
  m.run.duration = 3;
  experiment.setup = m;
  return experiment;
}

}  // namespace

class TestMotorBench : public QObject {
  Q_OBJECT
 private slots:
  /// Drela, "First-order DC electric motor model": with constant friction the best efficiency is (1
  /// - sqrt(I0 R/V))^2 at the current sqrt(V I0/R).
  void efficiencyPeakMeetsClosedForm() {
    const auto simulation = finished(bench(1));
    const Recording& r = run(*simulation, "Over speed");
    const std::size_t efficiency = *r.find("over_speed.efficiency"),
                      current = *r.find("over_speed.current");
    std::size_t best = 0;
    for (std::size_t row = 0; row < r.rows(); ++row)
      if (r.value(efficiency, row) > r.value(efficiency, best)) best = row;
    const double expected = std::pow(1 - std::sqrt(0.45 * 0.117 / 11.1), 2);
    QVERIFY2(std::abs(r.value(efficiency, best) - expected) < 1e-4,
             qPrintable(QString::number(r.value(efficiency, best) - expected)));
    QVERIFY(std::abs(r.value(current, best) / std::sqrt(11.1 * 0.45 / 0.117) - 1) < 0.08);
    // Stall and no load are the ends of the curve.
    QVERIFY(std::abs(r.value(current, 0) - 11.1 / 0.117) < 1e-9);
    QVERIFY(std::abs(r.value(*r.find("over_speed.torque"), r.rows() - 1)) < 1e-9);
  }

  void steadyPointsAreReached_data() {
    QTest::addColumn<double>("throttle");
    for (const double u : {0.25, 0.5, 0.75}) QTest::addRow("%g", u) << u;
  }
  void steadyPointsAreReached() {
    QFETCH(double, throttle);
    const auto simulation = finished(bench(throttle));
    const Recording& reached = run(*simulation, "Run");
    const Recording& solved = run(*simulation, "Over throttle");
    const auto row = static_cast<std::size_t>(std::lround(throttle * 200));
    QCOMPARE(solved.value(0, row), throttle);
    const std::pair<const char*, const char*> pairs[] = {
        {"motor.speed", "over_throttle.speed"},
        {"thrust", "over_throttle.thrust"},
        {"supply.current", "over_throttle.supply_current"},
        {"power.electrical", "over_throttle.electrical_power"}};
    for (const auto& [name, direct] : pairs) {
      const double a = reached.value(*reached.find(name), reached.rows() - 1);
      const double b = solved.value(*solved.find(direct), row);
      QVERIFY2(std::abs(a / b - 1) < 1e-5,
               qPrintable(QString("%1: %2 %3").arg(name).arg(a).arg(b)));
    }
    QVERIFY(figure(*simulation, "peak_ledger_residual") <
            1e-9 * figure(*simulation, "final_electrical_power"));
  }

  /// A battery runs down; the run ends where the cut-off is reached and keeps what it recorded.
  void emptyBatteryEndsTheRun() {
    Experiment experiment = bench(1);
    auto& m = alternative<MotorBench>(experiment.setup);
    BatteryParameters battery;
    battery.capacity = 30;
    m.stand.supply = battery;
    m.run.duration = 60;
    const auto simulation = finished(experiment);
    const Recording& r = run(*simulation, "Run");
    const double end = r.value(0, r.rows() - 1);
    QVERIFY2(end > 1 && end < 10, qPrintable(QString::number(end)));
    QVERIFY(r.value(*r.find("supply.voltage"), r.rows() - 1) < 9);
    QVERIFY(r.value(*r.find("supply.voltage"), r.rows() - 2) >= 9 - 0.2);
  }

  /// The warning comes where the method really is unstable: just below the stated step it runs,
  /// well above it does not.
  void unstableStepIsWarnedOf_data() {
    QTest::addColumn<int>("method");
    for (const auto m : {ode::Method::Euler, ode::Method::Rk4, ode::Method::Abm4})
      QTest::addRow("%s", std::string(ode::name(m)).c_str()) << static_cast<int>(m);
  }
  void unstableStepIsWarnedOf() {
    QFETCH(int, method);
    Experiment experiment = bench(0.5);
    auto& m = alternative<MotorBench>(experiment.setup);
    m.run.solver.method = static_cast<ode::Method>(method);
    m.run.tick = 0.01;
    m.run.duration = 1;
    double stable = 0, unstable = 0;
    for (double step = 5e-3; step > 1e-5; step *= 0.98) {
      m.run.solver.step = step;
      const auto warnings = warningsOf(experiment);
      if (warnings.empty()) {
        stable = step;
        break;
      }
      QCOMPARE(warnings.front().path, std::string("setup.run.solver.step"));
      QVERIFY(QString::fromStdString(warnings.front().message()).contains("pole"));
      unstable = step;
    }
    QVERIFY(stable > 0 && unstable > 0);
    const auto wild = [&](double step) {
      m.run.solver.step = step;
      const auto simulation = buildSimulation(experiment);
      while (simulation->advance(1000) == SimulationState::Running) {
      }
      if (simulation->state() == SimulationState::Failed) return true;
      // The current limit bounds the oscillation; in the steady state there must be none.
      const Recording& r = run(*simulation, "Run");
      const std::size_t c = *r.find("motor.current");
      double low = 1e9, high = -1e9;
      for (std::size_t row = r.rows() - 20; row < r.rows(); ++row) {
        low = std::min(low, r.value(c, row));
        high = std::max(high, r.value(c, row));
      }
      return high - low > 0.05;
    };
    QVERIFY(!wild(0.95 * stable));
    QVERIFY(wild(1.25 * unstable));
    m.stand.quasiStaticCurrent = true;
    m.run.solver.step = 1e-3;
    QVERIFY(warningsOf(experiment).empty());
  }

  /// Experiment 5: within the limit, no windup, at rest on the set-point; and faster without
  /// saturation.
  void speedControl() {
    const Experiment shipped =
        loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / "motor-speed-control.json");
    const auto limited = finished(shipped);
    // Between two updates of the controller (1 ms) the current follows the speed that changed
    // meanwhile.
    QVERIFY(figure(*limited, "peak_current") <= 1.01 * figure(*limited, "current_limit"));
    QVERIFY(figure(*limited, "peak_current") > 0.95 * figure(*limited, "current_limit"));
    QVERIFY2(figure(*limited, "overshoot") < 0.05,
             qPrintable(QString::number(figure(*limited, "overshoot"))));
    QVERIFY(figure(*limited, "settling_time") < 0.3);
    QVERIFY(figure(*limited, "rest_error") < 2);
  }

  /// The second run knows no limits: duty above 1, any current; the first is the run that stands
  /// alone otherwise, bit by bit.
  void withoutSaturation() {
    Experiment experiment =
        loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / "motor-speed-saturation.json");
    const auto both = finished(experiment);
    QCOMPARE(both->runs().size(), std::size_t{2});
    QCOMPARE(both->metrics()[1].run, std::string("Without saturation"));
    QVERIFY(figure(*both, "peak_current", 0) <= 1.01 * figure(*both, "current_limit", 0));
    QVERIFY(std::isnan(figure(*both, "current_limit", 1)));
    QVERIFY(figure(*both, "peak_current", 1) > 5 * figure(*both, "peak_current", 0));
    QVERIFY(figure(*both, "rise_time", 1) < 0.5 * figure(*both, "rise_time", 0));
    for (const std::size_t part : {std::size_t{0}, std::size_t{1}})
      QVERIFY(figure(*both, "overshoot", part) < 0.06);
    const Recording& free = run(*both, "Without saturation");
    QVERIFY(largestValue(free, "esc.duty") > 1.5);
    // The control signal is what stands at the terminals and in the resistance of the speed
    // controller.
    for (std::size_t row = 100; row < free.rows(); row += 50) {
      const double terminals =
          value(free, "motor.voltage", row) + 0.005 * value(free, "motor.current", row);
      QVERIFY(std::abs(terminals - value(free, "controller.voltage", row)) < 1e-9);
    }
    alternative<MotorSpeedRun>(experiment.setup).compareUnsaturated = false;
    const auto alone = finished(experiment);
    QCOMPARE(alone->runs().size(), std::size_t{1});
    const Recording &a = run(*alone, "Run"), &b = run(*both, "With saturation");
    QCOMPARE(a.rows(), b.rows());
    for (std::size_t c = 0; c < a.channels().size(); ++c)
      for (std::size_t row = 0; row < a.rows(); row += 7)
        QCOMPARE(a.value(c, row), b.value(c, row));
  }

  /// Long against the limit, a PI controller without back-calculation winds up and overshoots by
  /// what it gathered; with it the integral stays small and the step ends as calmly as a short one.
  void noWindup() {
    Experiment experiment =
        loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / "motor-speed-control.json");
    auto& m = alternative<MotorSpeedRun>(experiment.setup);
    m.setPoints = {{0, 0}, {0.05, 500}};
    m.run.duration = 2;
    m.stand.motor.maxCurrent = 8;  // just more than the steady current: saturated for long
    m.controller.pid.ki = 1200;
    m.controller.pid.trackingTime = 0.05;
    const auto calm = finished(experiment);
    m.controller.pid.trackingTime = 1000;
    const auto wound = finished(experiment);
    const double most = largestMagnitude(run(*calm, "Run"), "controller.integral");
    QVERIFY2(figure(*wound, "overshoot") > 0.05,
             qPrintable(QString::number(figure(*wound, "overshoot"))));
    QVERIFY2(figure(*calm, "overshoot") < 0.01,
             qPrintable(QString::number(figure(*calm, "overshoot"))));
    QVERIFY(most < 0.2 * largestMagnitude(run(*wound, "Run"), "controller.integral"));
    for (const auto* simulation : {calm.get(), wound.get()})
      QVERIFY2(figure(*simulation, "peak_current") <= 1.02 * 8,
               qPrintable(QString::number(figure(*simulation, "peak_current"))));
  }

  /// The current may pass its limit only by what the back-EMF falls short between two updates of
  /// the controller: with updates ten times as often it passes it by less.
  void limitIsKeptToTheSampling() {
    Experiment experiment =
        loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / "motor-speed-control.json");
    auto& m = alternative<MotorSpeedRun>(experiment.setup);
    m.setPoints = {{0, 0}, {0.05, 500}};
    m.run = {.solver = {.method = ode::Method::Rk4, .step = 2e-5}, .tick = 1e-4, .duration = 0.5};
    experiment.outputs.recordInterval = 1e-4;
    const auto excess = [&](double rate) {
      m.controller.rate = rate;
      const auto simulation = finished(experiment);
      return figure(*simulation, "peak_current") / figure(*simulation, "current_limit") - 1;
    };
    QVERIFY2(excess(1000) < 0.01, qPrintable(QString::number(excess(1000))));
    QVERIFY2(excess(10000) < 0.002, qPrintable(QString::number(excess(10000))));
  }

  /// A command waits for the dead time, to the instant and not to the tick; nothing else changes.
  void deadTimeShiftsTheRun_data() {
    QTest::addColumn<double>("deadTime");
    QTest::addRow("whole ticks") << 0.02;
    QTest::addRow("between ticks") << 0.0203;
    QTest::addRow("less than a tick") << 0.0004;
  }
  void deadTimeShiftsTheRun() {
    QFETCH(double, deadTime);
    Experiment experiment = bench(0.6);
    auto& m = alternative<MotorBench>(experiment.setup);
    m.throttle = {{0, 0}, {0.1, 0.6}, {0.3, 0.2}};
    m.run.duration = 0.5;
    m.run.solver.step = 2e-5;
    const auto plain = finished(experiment);
    m.stand.esc.deadTime = deadTime;
    const auto late = finished(experiment);
    // The late run at t is the plain one at t - deadTime, which stands between two of its rows.
    const Recording &a = run(*plain, "Run"), &b = run(*late, "Run");
    const std::size_t speed = *a.find("motor.speed");
    double most = 0;
    for (std::size_t row = 60; row < b.rows(); ++row) {
      const double t = b.value(0, row) - deadTime;
      const auto before = static_cast<std::size_t>(std::floor(t / 1e-3 + 1e-9));
      const double part = (t - a.value(0, before)) / 1e-3;
      const double expected =
          part < 1e-9 ? a.value(speed, before)
                      : (1 - part) * a.value(speed, before) + part * a.value(speed, before + 1);
      most = std::max(most, std::abs(b.value(speed, row) - expected));
    }
    // Straight lines between rows 1 ms apart leave h^2/8 of the second derivative, about 0.3 rad/s
    // at the steps.
    QVERIFY2(most < (deadTime == 0.02 ? 1e-6 : 0.5), qPrintable(QString::number(most)));
    const std::size_t duty = *b.find("esc.duty"), throttle = *b.find("throttle");
    const std::size_t step = b.lowerBound(0.1 - 1e-9);
    QCOMPARE(b.value(throttle, step), 0.6);
    QCOMPARE(b.value(duty, step + static_cast<std::size_t>(std::floor(deadTime / 1e-3))), 0.0);
    QVERIFY(b.value(duty, step + static_cast<std::size_t>(std::floor(deadTime / 1e-3)) + 2) > 0.05);
  }

  void contradictionsAreRefused_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("path");
    QTest::addRow("times")
        << R"("throttle": [{"time": 1, "throttle": 0}, {"time": 1, "throttle": 1}])"
        << "setup.throttle[1].time";
    QTest::addRow("tick") << R"("run": {"tick": 1, "duration": 0.5})"
                          << "setup.run.tick";
    QTest::addRow("method") << R"("run": {"solver": {"method": "exponential-rk4"}})"
                            << "setup.run.solver.method";
    QTest::addRow("battery curve")
        << R"("stand": {"supply": {"type": "battery", "openCircuit": [{"charge": 0, "voltage": 4}, {"charge": 1, "voltage": 3}]}})"
        << "setup.stand.supply.openCircuit[1].voltage";
    QTest::addRow("motor")
        << R"("stand": {"motor": {"speedConstant": 100, "resistance": 0.1, "noLoadCurrent": 200}})"
        << "setup.stand.motor.noLoadCurrent";
  }
  void emptyListsAreRefused_data() {
    QTest::addColumn<QString>("stand");
    QTest::addColumn<QString>("path");
    const QString propeller = R"({"load": {"type": "blade-element", "propeller": {%1}}})";
    QTest::addRow("battery") << R"({"supply": {"type": "battery", "openCircuit": []}})"
                             << "setup.stand.supply.openCircuit";
    QTest::addRow("stations") << propeller.arg(R"("stations": [])")
                              << "setup.stand.load.propeller.stations";
    QTest::addRow("sections") << propeller.arg(R"("sections": [])")
                              << "setup.stand.load.propeller.sections";
    QTest::addRow("polars") << propeller.arg(
                                   R"("sections": [{"model": {"type": "polars", "polars": []}}])")
                            << "setup.stand.load.propeller.sections[0].model.polars";
  }
  /// Nothing is built of a document with faults, not even to warn of its step.
  void emptyListsAreRefused() {
    QFETCH(QString, stand);
    QFETCH(QString, path);
    for (const char* kind : {"motor-bench", "motor-speed-control", "thrust-stand"}) {
      const QString text =
          QString(R"({"rotorbench": 1, "setup": {"type": "%1", "stand": %2}})").arg(kind, stand);
      try {
        readExperiment(text.toStdString(), "x.json");
        QFAIL("accepted");
      } catch (const InputError& error) {
        QCOMPARE(QString::fromStdString(error.problems().front().path), path);
      }
    }
  }

  void contradictionsAreRefused() {
    QFETCH(QString, json);
    QFETCH(QString, path);
    const QString text = R"({"rotorbench": 1, "setup": {"type": "motor-bench", )" + json + "}}";
    try {
      readExperiment(text.toStdString(), "x.json");
      QFAIL("accepted");
    } catch (const InputError& error) {
      QCOMPARE(QString::fromStdString(error.problems().front().path), path);
    }
  }
};

QTEST_APPLESS_MAIN(TestMotorBench)
#include "test_motor_bench.moc"
