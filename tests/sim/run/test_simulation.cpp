#include <QElapsedTimer>
#include <QTest>
#include <bit>
#include <cmath>
#include <filesystem>

#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"
#include "sim/document/solver_comparison.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/quick_map.h"

using namespace rotorbench;

namespace {

Experiment shipped(const char* name) {
  return loadExperiment(std::filesystem::path(EXPERIMENTS_DIR) / name);
}

/// The flagship for `duration` s.
Experiment flagship(double duration) {
  Experiment experiment = shipped("f450-hover-and-steps.json");
  alternative<Flight>(experiment.setup).duration = duration;
  return experiment;
}

SolverComparison everyMethod() {
  SolverComparison comparison;
  comparison.plant = RigidBarParameters{};
  comparison.duration = 2;
  comparison.methods.clear();
  for (const auto& m : ode::kMethods) {
    if (m.method != ode::Method::ExponentialRk4) comparison.methods.push_back({m.method});
  }
  return comparison;
}

double metric(const MetricRow& row, const char* name) {
  for (const Metric& m : row.metrics) {
    if (m.name == name) return m.value;
  }
  qFatal("no metric %s", name);
}

/// Runs to the end; the progress never falls and ends at 1.
void runAll(Simulation& simulation, std::int64_t ticks) {
  double before = simulation.progress().fraction;
  QVERIFY(before >= 0 && before < 1);
  while (simulation.advance(ticks) == SimulationState::Running) {
    const Progress progress = simulation.progress();
    QVERIFY(progress.fraction >= before);
    QVERIFY(progress.fraction <= 1);
    QVERIFY(!progress.activity.empty());
    before = progress.fraction;
  }
  QVERIFY2(simulation.state() == SimulationState::Finished,
           simulation.failure() ? simulation.failure()->message.c_str() : "");
  QCOMPARE(simulation.progress().fraction, 1.0);
  for (const auto& run : simulation.runs()) {
    QVERIFY(run.recording->finished());
    QVERIFY(run.recording->rows() > 0);
  }
}

}  // namespace

class TestSimulation : public QObject {
  Q_OBJECT

 private slots:
  void progressRisesToOne_data();
  void progressRisesToOne();
  void stopKeepsTheRows();
  void recordInterval_data();
  void recordInterval();
  void freeComparisonOfEveryMethod();
  void hopelessToleranceEnds_data();
  void hopelessToleranceEnds();
  void springBarComparison();
  void invalidExperiment();
  void sameSeedSameRows();
  void memoryLimitEndsTheRun();
};

void TestSimulation::progressRisesToOne_data() {
  QTest::addColumn<QString>("file");
  for (const auto& entry : std::filesystem::directory_iterator(EXPERIMENTS_DIR)) {
    if (entry.path().extension() == ".json")
      QTest::addRow("%s", entry.path().stem().c_str())
          << QString::fromStdString(entry.path().filename().string());
  }
}

void TestSimulation::progressRisesToOne() {
  QFETCH(QString, file);
  Experiment experiment = test::withQuickMaps(shipped(qPrintable(file)));
  std::visit(
      [](auto& setup) {
        if constexpr (requires { setup.run.duration; }) {
          setup.run.duration = std::min(setup.run.duration, 2.0);
        } else if constexpr (requires { setup.duration; }) {
          setup.duration = std::min(setup.duration, 2.0);
        }
      },
      experiment.setup);
  runAll(*buildSimulation(experiment), 17);
}

void TestSimulation::stopKeepsTheRows() {
  const auto simulation = buildSimulation(flagship(10));
  QCOMPARE(simulation->advance(500), SimulationState::Running);
  const Recording& recording = *simulation->runs().front().recording;
  const std::size_t rows = recording.rows();
  QCOMPARE(rows, std::size_t{500});  // one per tick of 1 ms, taken at the start of each
  QVERIFY(!recording.finished());
  simulation->stop();
  QCOMPARE(simulation->state(), SimulationState::Finished);
  QVERIFY(recording.finished());
  QVERIFY(!simulation->failure());
  QCOMPARE(simulation->advance(100), SimulationState::Finished);
  QCOMPARE(recording.rows(), rows);
  QVERIFY(simulation->progress().fraction < 0.06);
  const MetricTable table = simulation->metrics();
  QCOMPARE(table.size(), std::size_t{1});
  QVERIFY(std::abs(metric(table.front(), "end_time") - 0.5) < 1e-9);
  QCOMPARE(metric(table.front(), "steps"), 500.0);
  const std::size_t z = recording.find("position.z").value();
  QCOMPARE(metric(table.front(), "final_z"), recording.value(z, rows - 1));
}

void TestSimulation::recordInterval_data() {
  QTest::addColumn<double>("interval");
  QTest::addColumn<double>("recorded");  // s between rows
  QTest::addColumn<double>("duration");
  QTest::addColumn<int>("rows");  // the last row stands at the end, on the raster or not
  QTest::addRow("every tick") << 1e-3 << 1e-3 << 0.1 << 101;
  QTest::addRow("10 ms") << 0.01 << 0.01 << 0.1 << 11;
  QTest::addRow("off the raster") << 0.03 << 0.03 << 0.1 << 5;
  QTest::addRow("below a tick") << 1e-5 << 1e-3 << 0.1 << 101;
  QTest::addRow("rounded to ticks") << 2.4e-3 << 2e-3 << 0.1 << 51;
  QTest::addRow("longer than the run") << 60.0 << 60.0 << 0.1 << 2;
}

void TestSimulation::recordInterval() {
  QFETCH(double, interval);
  QFETCH(double, recorded);
  QFETCH(double, duration);
  QFETCH(int, rows);
  Experiment experiment = flagship(duration);
  experiment.outputs.recordInterval = interval;
  const auto simulation = buildSimulation(experiment);
  runAll(*simulation, 1000);
  const Recording& recording = *simulation->runs().front().recording;
  QCOMPARE(recording.rows(), static_cast<std::size_t>(rows));
  for (std::size_t row = 0; row + 1 < recording.rows(); ++row) {
    QVERIFY(std::abs(recording.value(0, row) - static_cast<double>(row) * recorded) < 1e-12);
  }
  QCOMPARE(recording.value(0, recording.rows() - 1), duration);
}

void TestSimulation::freeComparisonOfEveryMethod() {
  Experiment experiment;
  SolverComparison comparison = everyMethod();
  comparison.mode = DrivingMode::Free;
  comparison.errorControl = ode::ScaledErrorControl{};
  experiment.setup = comparison;
  experiment.outputs.recordInterval = comparison.sampleInterval;
  const auto simulation = buildSimulation(experiment);
  QCOMPARE(simulation->runs().size(), comparison.methods.size() + 2);
  runAll(*simulation, 1);
  const MetricTable table = simulation->metrics();
  QCOMPARE(table.size(), comparison.methods.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const ode::MethodInfo& method = ode::info(comparison.methods[i].method);
    QCOMPARE(table[i].run, std::string(method.name));
    const Recording& recording = *simulation->runs()[i + 1].recording;
    QCOMPARE(recording.value(0, recording.rows() - 1), comparison.duration);
    const double error = metric(table[i], "max_error_norm");
    // Euler's first order shows; all others are within 1e-4 at 10 ms or a tolerance of 1e-6.
    QVERIFY2(error > 0 && error < (method.method == ode::Method::Euler ? 1.0 : 1e-4),
             qPrintable(QString::number(error)));
    QVERIFY(metric(table[i], "wall_time") > 0);
    if (method.adaptive) continue;
    QVERIFY(std::abs(metric(table[i], "steps") - 200) <= 1);  // 2 s of 10 ms
    QCOMPARE(metric(table[i], "rejected"), 0.0);
  }
  const Recording& diagram = *simulation->runs().back().recording;
  QCOMPARE(diagram.rows(), std::size_t{7});
  for (const auto& m : comparison.methods) {
    const std::string name(ode::name(m.method));
    const std::size_t cost = diagram.find(name + ".evaluations").value();
    const std::size_t error = diagram.find(name + ".max_error_norm").value();
    for (std::size_t row = 1; row < 7; ++row)
      QVERIFY(diagram.value(cost, row) > diagram.value(cost, row - 1));
    QVERIFY(diagram.value(error, 6) < diagram.value(error, 0));
  }
}

void TestSimulation::hopelessToleranceEnds_data() {
  QTest::addColumn<DrivingMode>("mode");
  QTest::addRow("sampled") << DrivingMode::Sampled;
  QTest::addRow("free") << DrivingMode::Free;
}

/// The smallest tolerance allowed is below what doubles resolve here: the run ends, with a small
/// error or without a figure, and is no endless one. Less is refused.
void TestSimulation::hopelessToleranceEnds() {
  QFETCH(DrivingMode, mode);
  Experiment experiment;
  SolverComparison comparison;
  comparison.plant = RigidBarParameters{};
  comparison.mode = mode;
  comparison.duration = 0.1;
  comparison.methods = {{ode::Method::Rk547M}};
  comparison.errorControl = ode::ThesisErrorControl{.tolerance = 1e-300};
  experiment.setup = comparison;
  QVERIFY_THROWS_EXCEPTION(InputError, buildSimulation(experiment));
  comparison.errorControl = ode::ThesisErrorControl{.tolerance = 1e-15};
  experiment.setup = comparison;
  const auto simulation = buildSimulation(experiment);
  QElapsedTimer timer;
  timer.start();
  runAll(*simulation, 1);
  QVERIFY(timer.elapsed() < 30'000);
  const double error = metric(simulation->metrics().front(), "max_error_norm");
  QVERIFY2(std::isinf(error) || error < 1e-9, qPrintable(QString::number(error)));
}

/// Stiff enough to tell the methods apart, and both kinds of embedded control keep to their
/// tolerance.
void TestSimulation::springBarComparison() {
  Experiment experiment;
  SolverComparison comparison = everyMethod();
  comparison.plant = SpringBarParameters{};
  comparison.workPrecision = false;
  comparison.errorControl = ode::ScaledErrorControl{};
  experiment.setup = comparison;
  experiment.outputs.recordInterval = comparison.sampleInterval;
  const auto simulation = buildSimulation(experiment);
  QCOMPARE(simulation->runs().size(), comparison.methods.size() + 1);
  runAll(*simulation, 50);
  for (const auto& run : simulation->runs()) {
    QCOMPARE(run.recording->rows(), std::size_t{201});
    QVERIFY(run.recording->find("bar.length").has_value());
  }
  const MetricTable table = simulation->metrics();
  double euler = 0;
  double rk4 = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double error = metric(table[i], "max_error_norm");
    if (comparison.methods[i].method == ode::Method::Euler) euler = error;
    if (comparison.methods[i].method == ode::Method::Rk4) rk4 = error;
    if (ode::isAdaptive(comparison.methods[i].method)) QVERIFY(error < 1e-4);
  }
  QVERIFY(rk4 < euler / 10);
}

void TestSimulation::invalidExperiment() {
  Experiment experiment = flagship(1);
  auto& flight = alternative<Flight>(experiment.setup);
  flight.duration = -1;
  flight.environment.gravity = std::numeric_limits<double>::quiet_NaN();
  experiment.outputs.recordInterval = 0;
  try {
    buildSimulation(experiment);
    QFAIL("accepted");
  } catch (const InputError& error) {
    std::vector<std::string> paths;
    for (const Problem& problem : error.problems()) paths.push_back(problem.path);
    for (const char* path :
         {"setup.duration", "setup.environment.gravity", "outputs.recordInterval"})
      QVERIFY2(std::find(paths.begin(), paths.end(), path) != paths.end(), path);
  }
}

/// The same experiment gives the same bits, however its run is cut into pieces.
void TestSimulation::sameSeedSameRows() {
  const Experiment experiment = flagship(3);
  const auto one = buildSimulation(experiment);
  const auto two = buildSimulation(experiment);
  runAll(*one, 1);
  runAll(*two, 37);
  const Recording& a = *one->runs().front().recording;
  const Recording& b = *two->runs().front().recording;
  QCOMPARE(a.rows(), std::size_t{3001});
  QCOMPARE(b.rows(), a.rows());
  for (std::size_t c = 0; c < a.channels().size(); ++c) {
    for (std::size_t row = 0; row < a.rows(); ++row) {
      QCOMPARE(std::bit_cast<std::uint64_t>(a.value(c, row)),
               std::bit_cast<std::uint64_t>(b.value(c, row)));
    }
  }
}

void TestSimulation::memoryLimitEndsTheRun() {
  Experiment experiment = flagship(20);
  experiment.outputs.memoryLimit = 1e6;
  experiment.outputs.thinWhenFull = false;
  const auto simulation = buildSimulation(experiment);
  while (simulation->advance(1000) == SimulationState::Running) {
  }
  QCOMPARE(simulation->state(), SimulationState::Failed);
  QCOMPARE(simulation->failure()->component, std::string("recording"));
  QVERIFY(simulation->failure()->message.find("memoryLimit") != std::string::npos);
  const Recording& recording = *simulation->runs().front().recording;
  QVERIFY(recording.rows() > 1000);
  QVERIFY(recording.value(0, recording.rows() - 1) <= simulation->failure()->time);
  QVERIFY(!simulation->metrics().empty());
}

QTEST_GUILESS_MAIN(TestSimulation)
#include "test_simulation.moc"
