// Every shipped experiment: reads, reads back equal, runs to its end, gives the same bits twice and
// however the work is sliced, records what its charts show; and what the issue of the flights
// promises of them.
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/document/resources.h"
#include "sim/io/file.h"
#include "sim/run/run_files.h"
#include "sim/run/simulation.h"
#include "tests/sim/run/charted_channels.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

/// A shipped experiment, run once for all that ask about it.
const Simulation& flown(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Simulation>> all;
  auto& simulation = all[name];
  if (!simulation) simulation = runToEnd(shipped(name), 1'000'000);
  return *simulation;
}

/// The same without resistance of the air, which acts on hubs above the centre of mass and fades
/// only with the speed: what the controller makes of its set-points is then seen alone.
const Simulation& flownWithoutAir(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Simulation>> all;
  auto& simulation = all[name];
  if (simulation) return *simulation;
  Experiment experiment = shipped(name);
  VehicleParameters& vehicle = alternative<Flight>(experiment.setup).vehicle;
  vehicle.drag = {};
  std::visit(
      [](auto& a) {
        if constexpr (requires { a.inflow.drag; }) a.inflow = {};
      },
      std::get<EqualRotors>(vehicle.rotors).rotor.aerodynamics);
  simulation = runToEnd(experiment, 1'000'000);
  return *simulation;
}

bool sameBits(const Recording& a, const Recording& b) {
  if (a.channels() != b.channels() || a.rows() != b.rows()) return false;
  for (std::size_t c = 0; c < a.channels().size(); ++c) {
    for (std::size_t row = 0; row < a.rows();) {
      const auto one = a.column(c, row), other = b.column(c, row);
      if (one.size() != other.size() ||
          std::memcmp(one.data(), other.data(), one.size_bytes()) != 0)
        return false;
      row += one.size();
    }
  }
  return true;
}

/// Whether a run says why it has no such channels, which the chart then shows.
bool explained(const QString& pattern, const std::vector<RunOutput>& runs) {
  for (const RunOutput& run : runs) {
    for (const AbsentChannels& absent : run.absent)
      if (pattern.startsWith(QString::fromStdString(absent.beginning)) && !absent.reason.empty())
        return true;
  }
  return false;
}

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

}  // namespace

class TestShippedExperiments : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("ROTORBENCH_RESOURCES", EXPERIMENTS_DIR "/.."); }

  void all_data() {
    QTest::addColumn<QString>("name");
    std::vector<InputError> faults;
    const auto experiments = shippedExperiments(&faults);
    QVERIFY2(faults.empty(), faults.empty() ? "" : faults.front().what());
    QVERIFY(experiments.size() >= 6);
    QCOMPARE(experiments.front().name, std::string("f450-hover-and-steps"));
    for (const auto& e : experiments)
      QTest::addRow("%s", e.name.c_str()) << QString::fromStdString(e.name);
  }

  void all() {
    QFETCH(QString, name);
    const Experiment experiment = shipped(name.toStdString());
    QVERIFY(!experiment.title.empty() && !experiment.summary.empty());
    QVERIFY(schema::validate(schema::ref(experiment)).empty());
    const std::string text = writeExperiment(experiment);
    QVERIFY(readExperiment(text, "again") == experiment);

    const Simulation& whole = flown(name.toStdString());
    QCOMPARE(whole.state(), SimulationState::Finished);
    QVERIFY(whole.progress().fraction >= 1);
    // What differs from one run to the next differs here too.
    const auto sliced = runToEnd(experiment, 37);
    QCOMPARE(sliced->runs().size(), whole.runs().size());
    for (std::size_t i = 0; i < whole.runs().size(); ++i) {
      const RunOutput& run = whole.runs()[i];
      QVERIFY(run.recording->finished());
      QVERIFY2(run.recording->rows() > 1, run.name.c_str());
      QVERIFY2(sameBits(*run.recording, *sliced->runs()[i].recording), run.name.c_str());
    }
    for (const ChartSpec& chart : experiment.outputs.charts) {
      QVERIFY(!chart.title.empty());
      for (const QString& pattern : undrawn(chart, whole.runs(), Wanted::Values))
        QVERIFY2(explained(pattern, whole.runs()), qPrintable(pattern + " in no run"));
    }
    for (const auto& row : whole.metrics()) {
      for (const auto& metric : row.metrics)
        QVERIFY2(!metric.description.empty(), metric.name.c_str());
    }
  }

  /// Error below 1 mm and 0.01 degree at rest on every set-point, motors within their limits.
  void flagshipSettles() {
    const Simulation& simulation = flownWithoutAir("f450-hover-and-steps");
    const MetricTable table = simulation.metrics();
    QVERIFY(figure(table, "Flight", "altitude_rest_error") < 1e-3);
    for (const char* axis : {"roll", "pitch", "yaw"}) {
      const double error = degrees(figure(table, "Flight", std::string(axis) + "_rest_error"));
      QVERIFY2(error < 0.01, qPrintable(QString("%1: %2 deg").arg(axis).arg(error)));
    }
    const Recording& r = *simulation.runs().front().recording;
    const std::size_t limited = *r.find("control.limited");
    std::size_t rows = 0;
    for (std::size_t i = 0; i < r.rows(); ++i) rows += r.value(limited, i) != 0 ? 1 : 0;
    QVERIFY2(static_cast<double>(rows) < 0.05 * static_cast<double>(r.rows()),
             "saturates for long");
  }

  /// The air pushes at a vehicle whose speed still changes at the end of each part: a centimetre
  /// and half a degree are left where the drag changes, and nothing once it has come to rest.
  void flagshipHoldsInTheAir() {
    const Simulation& simulation = flown("f450-hover-and-steps");
    const MetricTable table = simulation.metrics();
    QVERIFY(figure(table, "Flight", "altitude_rest_error") < 1e-2);
    for (const char* axis : {"roll", "pitch", "yaw"})
      QVERIFY(degrees(figure(table, "Flight", std::string(axis) + "_rest_error")) < 0.5);
    const Recording& r = *simulation.runs().front().recording;
    const std::size_t last = r.rows() - 1;
    QVERIFY(std::abs(r.value(*r.find("position.z"), last) - 2) < 1e-3);
    QVERIFY(std::abs(degrees(r.value(*r.find("attitude.pitch"), last))) < 0.1);
    QVERIFY(simulation.verdicts().empty());
  }

  /// Six and eight rotors fly the flagship's timeline with the same controller, whose gains are
  /// those of poles: they settle as fast, though one vehicle has ten times the mass.
  void otherCountsSettleAlike_data() {
    QTest::addColumn<std::string>("name");
    QTest::addRow("hexacopter") << std::string("hexacopter-hover-and-steps");
    QTest::addRow("octocopter") << std::string("octocopter-hover-and-steps");
  }
  void otherCountsSettleAlike() {
    QFETCH(std::string, name);
    const MetricTable flagship = flownWithoutAir("f450-hover-and-steps").metrics();
    const MetricTable table = flownWithoutAir(name).metrics();
    QVERIFY(figure(table, "Flight", "altitude_rest_error") < 2e-3);
    for (const char* axis : {"altitude", "roll", "pitch"}) {
      const std::string settling = std::string(axis) + "_settling_time";
      const double ratio = figure(table, "Flight", settling) / figure(flagship, "Flight", settling);
      QVERIFY2(std::abs(ratio - 1) < 0.05, qPrintable(QString("%1: %2").arg(axis).arg(ratio)));
      QVERIFY(figure(table, "Flight", std::string(axis) + "_overshoot") < 0.02);
    }
    // Yaw is the weak axis: what the rotors' torques can do differs from vehicle to vehicle.
    QVERIFY(figure(table, "Flight", "yaw_settling_time") < 3.5);
    QVERIFY(flown(name).verdicts().empty());
  }

  /// The wind carries along what does not hold its place.
  void windCarriesTheVehicle() {
    const Recording& r = *flown("f450-in-the-wind").runs().front().recording;
    const std::size_t last = r.rows() - 1;
    const auto end = [&](const char* name) { return r.value(*r.find(name), last); };
    // The law of the file at 3 m: 6 m/s ln(3/0.03)/ln(10/0.03).
    QVERIFY(std::abs(end("wind.x") - 6 * std::log(100) / std::log(10 / 0.03)) < 1e-4);
    QVERIFY(end("velocity.x") > 0.5 * end("wind.x") && end("velocity.x") < 6);
    QVERIFY(std::abs(end("position.y")) < 1e-9);
    QVERIFY(std::abs(end("position.z") - 3) < 1e-3);
  }

  /// Left alone at its set-point the F450 stays where it is: hover is an equilibrium of plant and
  /// controller.
  void flagshipHoversStill() {
    Experiment experiment = shipped("f450-hover-and-steps");
    auto& flight = alternative<Flight>(experiment.setup);
    flight.duration = 5;
    alternative<ControlledInputs>(flight.control).setPoints = {{0, 0, 0, 0, 0}};
    const auto simulation = runToEnd(experiment);
    const Recording& r = *simulation->runs().front().recording;
    for (const char* channel :
         {"position.x", "position.y", "position.z", "attitude.roll", "attitude.pitch"}) {
      const std::size_t c = *r.find(channel);
      for (std::size_t i = 0; i < r.rows(); ++i) QVERIFY2(std::abs(r.value(c, i)) < 1e-10, channel);
    }
  }

  /// Integral action finds the trim the controller does not know: at the end nothing is left; at
  /// the end of each part of the timeline the slow yaw loop may still be on its way.
  void unbalancedStillSettles() {
    const Simulation& simulation = flownWithoutAir("unbalanced-f450");
    const MetricTable table = simulation.metrics();
    QVERIFY(figure(table, "Flight", "altitude_rest_error") < 1e-3);
    const Recording& r = *simulation.runs().front().recording;
    for (const char* axis : {"roll", "pitch", "yaw"}) {
      QVERIFY2(degrees(figure(table, "Flight", std::string(axis) + "_rest_error")) < 0.1, axis);
      const std::size_t last = r.rows() - 1;
      const double end = r.value(*r.find(std::string("attitude.") + axis), last) -
                         r.value(*r.find(std::string("setpoint.") + axis), last);
      QVERIFY2(std::abs(degrees(end)) < 0.01, axis);
    }
  }

  /// The rear rotors speed up first, so the vehicle goes forward and, by symmetry, nearly straight.
  void hummingbirdGoesForward() {
    const Simulation& simulation = flown("hummingbird-open-loop");
    const Recording& r = *simulation.runs().front().recording;
    const double x = r.sampleAt(*r.find("position.x"), 4.5);
    QVERIFY2(x > 0.5, qPrintable(QString::number(x)));
    QVERIFY(std::abs(r.sampleAt(*r.find("position.y"), 4.5)) < 0.05 * x);
    QVERIFY(r.sampleAt(*r.find("position.z"), 2.5) > 1.1);
  }

  /// What the cards of the stands promise.
  void standsKeepTheirWord() {
    const auto stand = flown("thrust-stand-x2216").metrics();
    QVERIFY(figure(stand, "Run", "steady_difference") < 0.01);
    QVERIFY(figure(stand, "Run", "full_thrust") > figure(stand, "Run", "peak_thrust"));
    const auto propeller = flown("propeller-bench-10x47").metrics();
    QVERIFY(figure(propeller, "Run", "figure_of_merit") < 1);
    QVERIFY(figure(propeller, "Run", "zero_thrust_advance_ratio") >
            figure(propeller, "Run", "peak_efficiency_advance_ratio"));
    const auto speed = flown("motor-speed-saturation").metrics();
    const auto both = [&](const char* name) {
      return std::pair(figure(speed, "With saturation", name),
                       figure(speed, "Without saturation", name));
    };
    QVERIFY(both("rise_time").first > 2 * both("rise_time").second);
    QVERIFY(both("peak_current").first < 1.01 * figure(speed, "With saturation", "current_limit"));
    QVERIFY(both("peak_current").second > 5 * both("peak_current").first);
    for (const double overshoot : {both("overshoot").first, both("overshoot").second})
      QVERIFY(overshoot < 0.06);
    QVERIFY(std::isfinite(both("settling_time").first));
  }

  /// A run cut in two equals one run up to the cut; stopping keeps what was recorded.
  void stoppedRunIsAPrefix() {
    const Experiment experiment = shipped("f450-hover-and-steps");
    const auto part = buildSimulation(experiment, EXPERIMENTS_DIR);
    part->advance(1234);
    part->stop();
    QCOMPARE(part->state(), SimulationState::Finished);
    const Recording& cut = *part->runs().front().recording;
    QCOMPARE(cut.rows(), std::size_t{1234});
    const Recording& full = *flown("f450-hover-and-steps").runs().front().recording;
    for (std::size_t c = 0; c < cut.channels().size(); ++c) {
      for (std::size_t i = 0; i < cut.rows(); i += 77) QCOMPARE(cut.value(c, i), full.value(c, i));
    }
  }

  /// A motor winding that no solver step can follow: the run stops with time and component, the
  /// recording stays.
  void divergenceNamesTimeAndComponent() {
    Experiment experiment = shipped("f450-hover-and-steps");
    alternative<Flight>(experiment.setup).solver.method = ode::Method::Euler;
    std::get<EqualRotors>(alternative<Flight>(experiment.setup).vehicle.rotors)
        .rotor.motor.inductance = 1e-6;
    const auto simulation = runToEnd(experiment);
    QCOMPARE(simulation->state(), SimulationState::Failed);
    QVERIFY(simulation->failure()->time > 0);
    // A current of no motor is found before the number overflows.
    QCOMPARE(simulation->failure()->component, std::string("rotor1.current"));
    QVERIFY2(simulation->failure()->message.find("A smaller step") != std::string::npos,
             simulation->failure()->message.c_str());
    QVERIFY(simulation->runs().front().recording->rows() > 1);
  }

  void memoryLimitStopsOrThins() {
    Experiment experiment = shipped("f450-hover-and-steps");
    experiment.outputs.memoryLimit = 5e6;
    experiment.outputs.thinWhenFull = false;
    const auto stopped = runToEnd(experiment);
    QCOMPARE(stopped->state(), SimulationState::Failed);
    QVERIFY(stopped->failure()->message.find("memoryLimit") != std::string::npos);
    experiment.outputs.thinWhenFull = true;
    const auto thinned = runToEnd(experiment);
    QCOMPARE(thinned->state(), SimulationState::Finished);
    QVERIFY(thinned->runs().front().recording->stride() > 1);
    QVERIFY(thinned->runs().front().recording->bytes() <= std::size_t{5'000'000});
  }

  /// Prescribed motor voltages and speeds from a CSV file next to the experiment.
  void inputsFromCsv() {
    QTemporaryDir directory;
    writeFileAtomically(directory.filePath("speeds.csv").toStdString(),
                        "time [s],r1 [rpm],r2 [rpm],r3 [rpm],r4 "
                        "[rpm]\n0,4480,4480,4480,4480\n1,4500,4500,4500,4500\n");
    Experiment experiment = shipped("hummingbird-open-loop");
    auto& flight = alternative<Flight>(experiment.setup);
    flight.duration = 1;
    flight.control =
        SpeedInputs{.source = CsvInputs<RotorSpeedQuantity>{"speeds.csv", Interpolation::Linear}};
    const auto simulation = buildSimulation(experiment, directory.path().toStdString());
    while (simulation->advance(100) == SimulationState::Running) {
    }
    const Recording& r = *simulation->runs().front().recording;
    const std::size_t speed = *r.find("rotor1.speed");
    QVERIFY(std::abs(r.sampleAt(speed, 0.5) - 4490 * std::numbers::pi / 30) < 1e-6);
    std::get<CsvInputs<RotorSpeedQuantity>>(std::get<SpeedInputs>(flight.control).source).file =
        "missing.csv";
    QVERIFY_THROWS_EXCEPTION(InputError,
                             buildSimulation(experiment, directory.path().toStdString()));
  }

  /// An independent validator accepts every shipped experiment under the schema the program prints.
  void jsonSchemaAccepts() {
    QTemporaryDir directory;
    const std::string schema = directory.filePath("schema.json").toStdString();
    writeFileAtomically(schema, experimentJsonSchema());
    QStringList arguments{"-c",
                          "import json,sys,jsonschema\n"
                          "s=json.load(open(sys.argv[1]))\n"
                          "jsonschema.validators.validator_for(s).check_schema(s)\n"
                          "for f in sys.argv[2:]: jsonschema.validate(json.load(open(f)), s)\n",
                          QString::fromStdString(schema)};
    for (const auto& e : shippedExperiments()) arguments << QString::fromStdString(e.file.string());
    QProcess python;
    python.setProcessChannelMode(QProcess::MergedChannels);
    python.start("/usr/bin/python3", arguments);
    QVERIFY(python.waitForFinished(60000));
    QVERIFY2(python.exitCode() == 0, python.readAll().constData());
  }
};

QTEST_GUILESS_MAIN(TestShippedExperiments)
#include "test_shipped_experiments.moc"
