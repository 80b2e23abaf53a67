// The motor's own experiments: curves against closed forms, steady points against the run, limits, warnings.
#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/experiment/experiment_file.h"
#include "sim/experiment/simulation.h"

using namespace rotorbench;

namespace {

std::unique_ptr<Simulation> finished(const Experiment& experiment) {
  auto simulation = buildSimulation(experiment);
  while (simulation->advance(1000) == SimulationState::Running) {
  }
  if (simulation->state() != SimulationState::Finished) qFatal("the run failed");
  return simulation;
}

double figure(const Simulation& simulation, const std::string& name) {
  const MetricTable table = simulation.metrics();
  for (const Metric& m : table.front().metrics)
    if (m.name == name) return m.value;
  qFatal("no metric %s", name.c_str());
}

const Recording& run(const Simulation& simulation, const std::string& name) {
  for (const RunOutput& r : simulation.runs())
    if (r.name == name) return *r.recording;
  qFatal("no run %s", name.c_str());
}

Experiment bench(double throttle) {
  Experiment experiment;
  MotorBench m;
  m.stand.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.01};
  m.throttle = {{0, throttle}};
  m.run.duration = 3;
  experiment.setup = m;
  return experiment;
}

std::vector<Problem> warningsOf(const Experiment& experiment) {
  std::vector<Problem> problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return !p.warning; });
  return problems;
}

}  // namespace

class TestMotorBench : public QObject {
  Q_OBJECT
 private slots:
  /// Drela, "First-order DC electric motor model": with constant friction the best efficiency is (1 - sqrt(I0 R/V))^2
  /// at the current sqrt(V I0/R).
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
    auto& m = std::get<MotorBench>(experiment.setup);
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

  /// The warning comes where the method really is unstable: just below the stated step it runs, well above it does not.
  void unstableStepIsWarnedOf_data() {
    QTest::addColumn<int>("method");
    for (const auto m : {ode::Method::Euler, ode::Method::Rk4, ode::Method::Abm4})
      QTest::addRow("%s", std::string(ode::name(m)).c_str()) << static_cast<int>(m);
  }
  void unstableStepIsWarnedOf() {
    QFETCH(int, method);
    Experiment experiment = bench(0.5);
    auto& m = std::get<MotorBench>(experiment.setup);
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

  /// Experiment 5: within the limit, no windup, at rest on the set-point; and faster without saturation.
  void speedControl() {
    const Experiment shipped =
        loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / "motor-speed-control.json");
    const auto limited = finished(shipped);
    // Between two updates of the controller (1 ms) the current follows the speed that changed meanwhile.
    QVERIFY(figure(*limited, "peak_current") <= 1.01 * figure(*limited, "current_limit"));
    QVERIFY(figure(*limited, "peak_current") > 0.95 * figure(*limited, "current_limit"));
    QVERIFY2(figure(*limited, "overshoot") < 0.05,
             qPrintable(QString::number(figure(*limited, "overshoot"))));
    QVERIFY(figure(*limited, "settling_time") < 0.3);
    QVERIFY(figure(*limited, "rest_error") < 2);
    Experiment free = shipped;
    auto& m = std::get<MotorSpeedRun>(free.setup);
    m.stand.esc.maxCurrent = m.stand.motor.maxCurrent = 1000;
    m.stand.supply = SupplyParameters{.voltage = 200};
    const auto unlimited = finished(free);
    QVERIFY(figure(*unlimited, "peak_current") > 2 * figure(*limited, "peak_current"));
    QVERIFY(figure(*unlimited, "rise_time") < 0.5 * figure(*limited, "rise_time"));
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
    QTest::addRow("motor") << R"("stand": {"motor": {"noLoadCurrent": 200}})"
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
    for (const char* kind : {"motor-bench", "motor-speed-control"}) {
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
