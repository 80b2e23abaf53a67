// A flight that is changed while it goes on: every parameter that says it is live acts, from its
// tick on and not before, and the experiment with its changes repeats the run bit for bit.
#include <QTest>
#include <bit>
#include <cmath>
#include <random>
#include <thread>

#include "sim/core/schema_tree.h"
#include "sim/run/run_worker.h"
#include "tests/sim/run/finished_run.h"
#include "tests/sim/run/hard_flight.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

/// First row in which two recordings differ in any bit; the number of rows if in none.
std::size_t firstDifference(const Recording& a, const Recording& b) {
  if (a.channels().size() != b.channels().size() || a.rows() != b.rows()) return 0;
  for (std::size_t row = 0; row < a.rows(); ++row) {
    for (std::size_t c = 0; c < a.channels().size(); ++c) {
      const auto bits = [c, row](const Recording& r) {
        return std::bit_cast<std::uint64_t>(r.value(c, row));
      };
      if (bits(a) != bits(b)) return row;
    }
  }
  return a.rows();
}

/// Another allowed value of a live parameter, as a person would type it.
std::string another(const schema::Field& field, const schema::Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "off" : "on";
  if (const auto* number = std::get_if<double>(&value)) {
    // A row that holds only from later on.
    if (field.key == "time") return schema::toText(field, 3 * *number);
    const double half = *number == 0 ? 0.01 : *number / 2;
    return schema::toText(field, field.range.contains(half) ? half : *number * 2);
  }
  auto numbers = std::get<std::vector<double>>(value);
  for (double& n : numbers) n += 1;
  return schema::toText(field, numbers);
}

}  // namespace

class TestLiveFlight : public QObject {
  Q_OBJECT
 private slots:
  void everyLiveParameterActs_data();
  void everyLiveParameterActs();
  void changesActAtTheirTick_data();
  void changesActAtTheirTick();
  void timesOfChangesNeverFall();
  void windThatRisesIsAMovingFrame();
  void handsTakeSetPoints();
  void figuresKnowWhatWasAsked();
  void onlyFlightsChange();
  void liveRunsRepeat();
};

/// Every parameter that says so, of every part of a flight: had one been forgotten in run/, its row
/// would fail.
void TestLiveFlight::everyLiveParameterActs_data() {
  QTest::addColumn<Experiment>("experiment");
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("value");
  const auto add = [](const char* name, Experiment e, const std::string& below) {
    schema::walk(schema::ref(std::as_const(flightOf(e))),
                 [&](const std::string& path, const schema::Field& field, const void* owner) {
                   if (!field.live || !path.starts_with(below)) return;
                   QTest::addRow("%s: %s", name, path.c_str())
                       << e << QString::fromStdString(path)
                       << QString::fromStdString(another(field, field.read(owner)));
                 });
  };
  add("timeline", hardFlight(kSteady), "control.controller");
  add("timeline", hardFlight(kSteady), "control.motors");
  // The row that holds from 0.25 s on; the one before is over when the change comes.
  add("timeline", hardFlight(kSteady), "control.setPoints[1]");
  add("hands", hardFlight(kSteady, kAllByHand), "control.byHand");
  add("steady", hardFlight(kSteady), "environment");
  add("over height", hardFlight(kOverHeight), "environment");
}

void TestLiveFlight::everyLiveParameterActs() {
  QFETCH(Experiment, experiment);
  QFETCH(QString, path);
  QFETCH(QString, value);
  constexpr double kTime = 0.3;
  const auto as = finished(experiment);
  flightOf(experiment).changes = {{kTime, path.toStdString(), value.toStdString()}};
  QVERIFY(schema::validate(schema::ref(std::as_const(experiment))).empty());
  const auto changed = finished(experiment);
  const std::size_t first =
      firstDifference(*as->runs().front().recording, *changed->runs().front().recording);
  // A set-point acts in the tick itself, a gain when its controller next acts, and a limit when the
  // demand next reaches it.
  QVERIFY2(first >= std::size_t{300} && first < std::size_t{1001},
           qPrintable(QString::number(first)));
}

void TestLiveFlight::changesActAtTheirTick_data() {
  QTest::addColumn<double>("time");
  QTest::addColumn<int>("tick");
  QTest::addRow("at a tick") << 0.3 << 300;  // 0.3 is not 300 times 0.001
  QTest::addRow("late by rounding") << std::nextafter(0.3, 1) << 300;
  QTest::addRow("between two") << 0.3002 << 301;
  QTest::addRow("at the start") << 0.0 << 0;
}

void TestLiveFlight::changesActAtTheirTick() {
  QFETCH(double, time);
  QFETCH(int, tick);
  Experiment e = hardFlight(kSteady);
  flightOf(e).changes = {{time, "environment.wind.velocity", "[2, 3, 0]"}};
  const auto simulation = finished(e);
  const Recording& r = *simulation->runs().front().recording;
  if (tick > 0) QCOMPARE(value(r, "wind.y", static_cast<std::size_t>(tick - 1)), 1.0);
  QCOMPARE(value(r, "wind.y", static_cast<std::size_t>(tick)), 3.0);
  // What holds from the start is what the experiment could have said at once.
  if (tick > 0) return;
  Experiment atOnce = hardFlight(R"("type": "steady", "velocity": [2, 3, 0])");
  const auto same = finished(atOnce);
  QCOMPARE(firstDifference(r, *same->runs().front().recording), r.rows());
}

/// Also where one that was laid down acts a rounding late, before one made by hand at its tick.
void TestLiveFlight::timesOfChangesNeverFall() {
  Experiment e = hardFlight(kSteady);
  flightOf(e).changes = {{std::nextafter(0.3, 1), "environment.wind.velocity.x", "1"}};
  const auto simulation = buildSimulation(e);
  simulation->advance(300);
  QVERIFY(!simulation->change({0, "environment.wind.velocity.x", "4"}));
  QVERIFY(simulation->change({1e300, "environment.wind.velocity.x", "4"}).has_value());
  QVERIFY(!simulation->change({0.5, "environment.wind.velocity.x", "5"}));
  while (simulation->advance(1000) == SimulationState::Running) {
  }
  const Recording& r = *simulation->runs().front().recording;
  QCOMPARE(value(r, "wind.x", 299), 2.0);
  QCOMPARE(value(r, "wind.x", 300), 4.0);
  QCOMPARE(value(r, "wind.x", 500), 5.0);
  setChanges(e, simulation->changes());
  QVERIFY(schema::validate(schema::ref(std::as_const(e))).empty());
  QCOMPARE(firstDifference(r, *finished(e)->runs().front().recording), r.rows());
}

/// Galilei again: a wind that rises by d in a wind w is, for who moves with w, one that rises by d
/// in still air.
void TestLiveFlight::windThatRisesIsAMovingFrame() {
  const auto fly = [](const char* before, const char* after, const char* velocity) {
    Experiment e = readExperiment(
        std::string(R"({"rotorbench": 1, "setup": {"type": "flight", "duration": 1.5,
      "control": {"type": "motor-voltages", "source": {"type": "constant",
        "voltages": [6.0, 6.2, 6.1, 6.3]}}, "start": {"position": [0, 0, 10], "velocity": )") +
            velocity + R"(}, "environment": {"wind": {"type": "steady", "velocity": )" + before +
            R"(}}, "changes": [{"time": 0.7, "parameter": "environment.wind.velocity", "value": ")" +
            after + R"("}]}})",
        "flight.json");
    return finished(e);
  };
  const auto inWind = fly("[3, -2, 0.5]", "[7, 3, 1.5]", "[3, -2, 0.5]");
  const auto inStill = fly("[0, 0, 0]", "[4, 5, 1]", "[0, 0, 0]");
  const Recording& windy = *inWind->runs().front().recording;
  const Recording& still = *inStill->runs().front().recording;
  const std::pair<const char*, double> axes[] = {{"x", 3}, {"y", -2}, {"z", 0.5}};
  for (std::size_t row = 0; row < windy.rows(); row += 100) {
    const double time = value(windy, "time", row);
    for (const auto& [axis, w] : axes) {
      const std::string position = std::string("position.") + axis;
      QVERIFY(std::abs(value(windy, position, row) - value(still, position, row) - w * time) <
              1e-10);
    }
    QVERIFY(std::abs(value(windy, "attitude.roll", row) - value(still, "attitude.roll", row)) <
            1e-10);
  }
  // And it was felt.
  const std::size_t last = still.rows() - 1;
  QVERIFY(std::abs(value(still, "velocity.y", last) - value(still, "velocity.y", 700)) > 0.1);
}

void TestLiveFlight::handsTakeSetPoints() {
  Experiment e = hardFlight(kSteady);
  flightOf(e).changes = {{0.1, "control.byHand.height", "0.7"},
                         {0.2, "control.byHand.heightByHand", "on"},
                         {0.4, "control.byHand.height", "90 cm"},
                         {0.6, "control.byHand.heightByHand", "off"}};
  const auto simulation = finished(e);
  const Recording& r = *simulation->runs().front().recording;
  const std::pair<std::size_t, double> heights[] = {{150, 0.4}, {199, 0.4}, {200, 0.7}, {399, 0.7},
                                                    {400, 0.9}, {599, 0.9}, {600, 2.0}};
  for (const auto& [row, height] : heights) QCOMPARE(value(r, "setpoint.z", row), height);
  // The other set-points stay the timeline's.
  QCOMPARE(value(r, "setpoint.roll", 249), 0.0);
  QCOMPARE(value(r, "setpoint.roll", 250), 0.3);
}

/// Steps made by hand have their figures; those of the timeline that hands withheld have none.
void TestLiveFlight::figuresKnowWhatWasAsked() {
  Experiment e = loadExperiment(EXPERIMENTS_DIR "/f450-hover-and-steps.json");
  flightOf(e).duration = 7;
  flightOf(e).start.position.z() = 1;
  auto& inputs = alternative<ControlledInputs>(flightOf(e).control);
  inputs.setPoints = {{0, 1, 0, 0, 0}, {5, 1, 0.5, 0, 0}};
  inputs.byHand.rollByHand = true;
  const auto withheld = finished(e);
  QVERIFY(std::isnan(figure(*withheld, "roll_settling_time")));
  flightOf(e).changes = {{1, "control.byHand.height", "2"},
                         {1, "control.byHand.heightByHand", "on"}};
  const auto climbed = finished(e);
  inputs.setPoints = {{0, 1, 0, 0, 0}, {1, 2, 0, 0, 0}, {5, 2, 0, 0, 0}};
  flightOf(e).changes.clear();
  const auto laidDown = finished(e);
  for (const char* name : {"altitude_overshoot", "altitude_settling_time", "altitude_rest_error"})
    QCOMPARE(figure(*climbed, name), figure(*laidDown, name));
  QVERIFY(figure(*climbed, "altitude_settling_time") > 1);
}

void TestLiveFlight::onlyFlightsChange() {
  const auto bench = buildSimulation(loadExperiment(EXPERIMENTS_DIR "/motor-bench-e305.json"));
  const auto problem = bench->change({0, "setup.duration", "3"});
  QVERIFY(problem.has_value());
  QCOMPARE(problem->message(),
           std::string("setup.duration: cannot change while this experiment runs; only flights "
                       "take changes; all else needs a new run"));
  QVERIFY(bench->changes().empty());
  // A flight that has ended takes none either.
  Experiment e = hardFlight(kSteady);
  const auto flight = finished(e);
  QVERIFY(flight->change({0, "control.controller.roll.kp", "3"}).has_value());
}

/// Runs as people and programs drive them: set-points, gains and wind changed at any moment from
/// another thread, pauses, steps, another pace, a reader. Each repeats bit for bit from its
/// experiment as saved.
void TestLiveFlight::liveRunsRepeat() {
  constexpr int kRuns = 100;
  int changed = 0;
  for (int run = 0; run < kRuns; ++run) {
    Experiment e = hardFlight(run % 2 == 0 ? kSteady : kOverHeight);
    flightOf(e).solver.method = run % 3 == 0   ? ode::Method::Abm4
                                : run % 3 == 1 ? ode::Method::ExponentialRk4
                                               : ode::Method::Rk547M;
    // One that was laid down, among those that come.
    flightOf(e).changes = {{0.45, "control.controller.pitch.kp", "40"}};
    const Experiment asked = e;
    RunWorker worker([asked] { return buildSimulation(asked); }, Pace{8.0});
    std::thread hands([&worker, run] {
      std::mt19937 random(static_cast<unsigned>(run));
      const auto any = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
      };
      while (isActive(worker.status().state)) {
        const std::string number = std::to_string(any(0.2, 1));
        switch (std::uniform_int_distribution<int>(0, 9)(random)) {
          case 0:
            worker.change({0, "control.byHand.height", number});
            break;
          case 1:
            worker.change({0, "control.byHand.heightByHand", any(0, 1) < 0.5 ? "on" : "off"});
            break;
          case 2:
            worker.change({0, "control.setPoints[1].roll", number});
            break;
          case 3:
            worker.change({0, "control.controller.roll.kp", std::to_string(any(5, 80))});
            break;
          case 4:
            worker.change({0, "control.controller.yaw.ki", std::to_string(any(0, 10))});
            break;
          case 5:
            worker.change({0, "control.motors.pid.kp", std::to_string(any(20, 80))});
            break;
          case 6:
            worker.change({any(0, 1), "environment.wind.velocity.x", number});
            break;
          case 7:
            worker.setPace({any(2, 30)});
            break;
          case 8:
            worker.pause();
            worker.step(any(0.001, 0.02));
            worker.resume();
            break;
          default:
            worker.pause();
            worker.change({0, "control.byHand.rollByHand", "on"});
            worker.resume();
            break;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(any(0, 8000))));
      }
    });
    double seen = 0;  // a reader looks at what has been published
    while (isActive(worker.status().state)) {
      const RunStatus status = worker.status();
      if (status.outputs.empty()) continue;
      const Recording& r = *status.outputs.front().recording;
      if (r.rows() > 0) seen = std::max(seen, r.value(0, r.rows() - 1));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    hands.join();
    worker.wait();
    const RunStatus status = worker.status();
    QCOMPARE(status.state, RunState::Finished);
    QVERIFY(seen > 0);
    setChanges(e, *status.changes);
    changed += static_cast<int>(status.changes->size()) - 1;
    const auto repeated = finished(readExperiment(writeExperiment(e), "saved.json"));
    const Recording& live = *status.outputs.front().recording;
    const std::size_t first = firstDifference(live, *repeated->runs().front().recording);
    QVERIFY2(first == live.rows(),
             qPrintable(QStringLiteral("run %1 differs from row %2 on").arg(run).arg(first)));
    QCOMPARE(repeated->changes(), *status.changes);
  }
  QVERIFY2(changed > 4 * kRuns, qPrintable(QString::number(changed)));
}

QTEST_GUILESS_MAIN(TestLiveFlight)
#include "test_live_flight.moc"
