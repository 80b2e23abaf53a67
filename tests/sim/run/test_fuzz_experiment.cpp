#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <variant>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/document/experiment_file.h"
#include "sim/document/kinds.h"
#include "sim/io/file.h"
#include "sim/run/simulation.h"
#include "tests/sim/io/mutator.h"

using namespace rotorbench;

namespace {

constexpr int kMutations = 40'000;
constexpr int kSimulated = 800;

/// The shipped experiments as they are and written out in full, so that every default is hit too.
std::vector<std::string> seedTexts() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(EXPERIMENTS_DIR)) {
    if (entry.path().extension() == kExperimentSuffix) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());  // the folder's order differs between machines
  std::vector<std::string> texts;
  for (const auto& file : files) {
    texts.push_back(readTextFile(file));
    texts.push_back(writeExperiment(loadExperiment(file)));
  }
  return texts;
}

/// A run of a few ticks and little memory, whatever the file says.
struct Shorten {
  void operator()(Flight& flight) const {
    flight.duration = 4.5 * flight.tick;
    limit(flight.solver);
    if (auto* equal = std::get_if<EqualRotors>(&flight.vehicle.rotors))
      coarsen(equal->rotor.aerodynamics);
    if (auto* own = std::get_if<IndividualRotors>(&flight.vehicle.rotors)) {
      for (RotorParameters& rotor : own->rotors) coarsen(rotor.aerodynamics);
    }
  }
  /// Blade elements and maps as coarse as they may be, of a flight's rotor or a propeller on the
  /// bench.
  template <class Variant>
  static void coarsen(Variant& propeller) {
    std::visit(
        [](auto& p) {
          if constexpr (requires { p.settings; }) {
            p.settings.elements = std::min(p.settings.elements, 6);
            p.settings.azimuths = std::min(p.settings.azimuths, 6);
          }
          if constexpr (requires { p.map; }) {
            p.map.directions = p.map.sideDirections = 16;
            p.map.reynoldsNumbers = p.map.sideReynoldsNumbers = p.map.sideAngles = 4;
            p.map.sideRefinements = 0;
          }
        },
        propeller);
  }
  void operator()(BirotorMotion& motion) const {
    motion.duration = 4.5 * motion.sampleInterval;
    limit(motion.solver);
  }
  void operator()(MotorBench& bench) const { limit(bench.run); }
  void operator()(MotorSpeedRun& run) const { limit(run.run); }
  void operator()(ThrustStand& stand) const {
    std::visit(*this, stand.procedure);
    if (durationOf(stand.procedure) > 10 * stand.run.tick)
      stand.procedure = ThrottleRows{.duration = 4.5 * stand.run.tick};
    limit(stand.run.solver);
  }
  void operator()(ThrottleLevels& /*steps*/) const {}
  void operator()(ThrottleSweep& sweep) const { sweep.readings = std::min(sweep.readings, 10); }
  void operator()(ThrottleRows& /*rows*/) const {}
  void operator()(PropellerBench& bench) const {
    bench.run.duration = 4.5 * bench.run.tick;
    bench.curves.points = std::min(bench.curves.points, 10);
    coarsen(bench.propeller);
    coarsen(bench.second);
  }
  void operator()(SolverComparison& comparison) const {
    comparison.duration = 4.5 * comparison.sampleInterval;
    comparison.referenceStep = std::max(comparison.referenceStep, comparison.duration / 1000);
  }
  static void limit(DriveRunSettings& run) {
    run.duration = 4.5 * run.tick;
    limit(run.solver);
  }
  static void limit(ode::SolverSettings& solver) {
    solver.maximumSteps = std::min<std::int64_t>(solver.maximumSteps, 2000);
  }
};

void checkProblems(const InputError& error, const std::string& source) {
  QVERIFY(!error.problems().empty());
  QCOMPARE(error.source(), source);
  QVERIFY(!findInvalidUtf8(error.what()));
  for (const Problem& problem : error.problems()) {
    QVERIFY(!problem.what.empty());
    QVERIFY(!problem.message().empty());
  }
}

void checkRoundTrip(const Experiment& experiment, const std::string& text) {
  for (const Problem& problem : schema::validate(schema::ref(experiment)))
    QVERIFY2(problem.warning, text.c_str());
  const std::string written = writeExperiment(experiment);
  const Experiment again = readExperiment(written, "again.json");
  QVERIFY2(again == experiment, text.c_str());
  QCOMPARE(writeExperiment(again), written);
}

/// Builds and runs a short version; what it cannot build it says. Returns the largest number of
/// rows of a run.
std::size_t simulate(Experiment experiment) {
  visitAlternative(Shorten{}, experiment.setup);
  experiment.outputs.memoryLimit = 1e6;
  std::size_t rows = 0;
  try {
    const auto simulation = buildSimulation(experiment);
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 200 && simulation->advance(1) == SimulationState::Running; ++i) {
      if (timer.elapsed() > 1000) break;
    }
    simulation->stop();
    static_cast<void>(simulation->metrics());
    for (const auto& run : simulation->runs()) rows = std::max(rows, run.recording->rows());
    if (simulation->state() == SimulationState::Failed && simulation->failure()->message.empty())
      qFatal("a run failed without a message");
  } catch (const InputError& error) {
    if (error.problems().empty()) qFatal("refused without a sentence");
  }
  return rows;
}

}  // namespace

class TestFuzzExperiment : public QObject {
  Q_OBJECT

 private slots:
  void shippedFilesAreSeeds();
  void mutatedExperiments();
  void badFiles_data();
  void badFiles();
  void badPlaces_data();
  void badPlaces();
  void hugeFile();
};

void TestFuzzExperiment::shippedFilesAreSeeds() {
  const auto seeds = seedTexts();
  QVERIFY(seeds.size() >= 12);
  for (const auto& text : seeds) checkRoundTrip(readExperiment(text, "seed.json"), text);
}

/// Every damaged file is refused with sentences, or it is a valid experiment: it is written and
/// read back equal, and it runs or says why it cannot.
void TestFuzzExperiment::mutatedExperiments() {
  Mutator mutator(450);
  const auto seeds = seedTexts();
  int accepted = 0;
  int simulated = 0;
  int recorded = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string text = mutator.mutate(seeds[mutator.below(seeds.size())]);
    try {
      const Experiment experiment = readExperiment(text, "fuzz.json");
      ++accepted;
      checkRoundTrip(experiment, text);
      // Every fourth, so that all seeds and kinds of damage are among them.
      if (simulated < kSimulated && accepted % 4 == 0) {
        ++simulated;
        if (simulate(experiment) > 0) ++recorded;
      }
    } catch (const InputError& error) {
      checkProblems(error, "fuzz.json");
    } catch (const std::exception& error) {
      QFAIL((std::string(error.what()) + "\n" + text).c_str());
    }
    if (QTest::currentTestFailed()) return;
  }
  qInfo("%d of %d damaged experiments were still valid, %d of %d of these left rows", accepted,
        kMutations, recorded, simulated);
  QVERIFY(accepted > kMutations / 100);  // else the mutations are too coarse to test anything
  QVERIFY(accepted < kMutations * 3 / 4);
  QVERIFY(simulated >= 200);
  QVERIFY(recorded > simulated * 3 / 4);
}

void TestFuzzExperiment::badFiles_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("named");
  const QByteArray whole = QByteArray::fromStdString(
      readTextFile(std::filesystem::path(EXPERIMENTS_DIR) / "f450-hover-and-steps.json"));
  const auto flight = [](const char* member) {
    return QByteArray(R"({"rotorbench": 1, "setup": {"type": "flight", )") + member + "}}";
  };
  QByteArray binary;
  for (int i = 0; i < 4096; ++i) binary.append(static_cast<char>((i * 197 + 91) & 0xFF));
  QTest::addRow("empty") << QByteArray() << "empty";
  QTest::addRow("only blanks") << QByteArray(" \n\t ") << "empty";
  const QByteArray half = whole.left(whole.size() / 2);
  QTest::addRow("truncated") << half << QString("line %1,").arg(half.count('\n') + 1);
  QTest::addRow("truncated at the last brace")
      << whole.trimmed().chopped(1) << QString("line %1,").arg(whole.trimmed().count('\n') + 1);
  QTest::addRow("binary") << binary << "text";
  QTest::addRow("deep lists") << QByteArray(100'000, '[') << "64";
  QTest::addRow("deep objects") << QByteArray(R"({"a":)").repeated(100'000) << "64";
  QTest::addRow("50 MB of text") << QByteArray(R"({"rotorbench": 1, "notes": ")") +
                                        QByteArray(50'000'000, 'x') + "\"}"
                                 << "16 MiB";
  QTest::addRow("50 MB of numbers")
      << QByteArray("[") + QByteArray("1,").repeated(25'000'000) << "16 MiB";
  QTest::addRow("wrong unit") << flight(R"("duration": "5 kg")") << "setup.duration";
  QTest::addRow("wrong unit, named") << flight(R"("duration": "5 kg")") << "kg";
  QTest::addRow("no unit of this world") << flight(R"("duration": "5 parsnips")") << "parsnips";
  QTest::addRow("NaN") << flight(R"("duration": NaN)") << "line 1";
  QTest::addRow("Infinity") << flight(R"("duration": Infinity)") << "line 1";
  QTest::addRow("NaN as text") << flight(R"("duration": "NaN")") << "setup.duration";
  QTest::addRow("too large for a number") << flight(R"("duration": 1e999)") << "too large";
  QTest::addRow("null") << flight(R"("duration": null)") << "setup.duration";
  QTest::addRow("duplicate key") << flight(R"("duration": 5, "duration": 6)") << "setup.duration";
  QTest::addRow("duplicate version")
      << QByteArray(R"({"rotorbench": 1, "rotorbench": 1})") << "rotorbench";
  QTest::addRow("unknown version") << QByteArray(R"({"rotorbench": 99})") << "99";
  QTest::addRow("no version") << QByteArray(R"({"title": "x"})") << "version";
  QTest::addRow("version as text") << QByteArray(R"({"rotorbench": "one"})") << "one";
  QTest::addRow("a list") << QByteArray("[1, 2]") << "list";
  QTest::addRow("a number") << QByteArray("12") << "12";
  QTest::addRow("unknown key") << flight(R"("durration": 5)") << "duration";
  QTest::addRow("unknown kind") << QByteArray(R"({"rotorbench": 1, "setup": {"type": "flihgt"}})")
                                << "flight";
  QTest::addRow("text after the end")
      << QByteArray(R"({"rotorbench": 1} {"rotorbench": 1})") << "line 1";
}

/// One sentence says where, what and what is allowed.
void TestFuzzExperiment::badFiles() {
  QFETCH(QByteArray, text);
  QFETCH(QString, named);
  QElapsedTimer timer;
  timer.start();
  try {
    readExperiment({text.constData(), static_cast<std::size_t>(text.size())}, "bad.json");
    QFAIL("the file was accepted");
  } catch (const InputError& error) {
    checkProblems(error, "bad.json");
    QCOMPARE(error.problems().size(), std::size_t{1});
    const QString message = QString::fromStdString(error.problems().front().message());
    QVERIFY2(message.contains(named), qPrintable(message));
    QVERIFY2(message.size() < 400, qPrintable(message));
    QVERIFY2(!message.contains('\n'), qPrintable(message));
  }
  QVERIFY(timer.elapsed() < 5000);
}

void TestFuzzExperiment::badPlaces_data() {
  QTest::addColumn<QString>("place");
  QTest::addColumn<QString>("named");
  QTest::addRow("missing") << "no-such-experiment.json"
                           << "there is no such file";
  QTest::addRow("a folder") << "."
                            << "folder";
}

void TestFuzzExperiment::badPlaces() {
  QFETCH(QString, place);
  QFETCH(QString, named);
  const QTemporaryDir folder;
  const std::filesystem::path file =
      std::filesystem::path(folder.path().toStdString()) / place.toStdString();
  try {
    loadExperiment(file);
    QFAIL("the file was accepted");
  } catch (const InputError& error) {
    checkProblems(error, file.string());
    QVERIFY2(QString(error.what()).contains(named), error.what());
  }
}

void TestFuzzExperiment::hugeFile() {
  const QTemporaryDir folder;
  QFile file(folder.filePath("huge.json"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  QVERIFY(file.resize(50'000'000));
  file.close();
  try {
    loadExperiment(file.fileName().toStdString());
    QFAIL("the file was accepted");
  } catch (const InputError& error) {
    QCOMPARE(error.problems().size(), std::size_t{1});
    QVERIFY2(QString(error.what()).contains("16 MiB"), error.what());
  }
}

QTEST_GUILESS_MAIN(TestFuzzExperiment)
#include "test_fuzz_experiment.moc"
