// Tasks in the order of what they read and write, each at its own rate: no hidden tick of delay.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/control/pid_flight.h"
#include "sim/core/random.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/run/builders.h"
#include "sim/run/flight_assembly.h"
#include "sim/run/scheduler.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

using Tasks = std::vector<std::unique_ptr<Task>>;

/// A task whose use of signals and action a test lays down.
class Probe final : public Task {
 public:
  using Act = std::function<void(const ClockTick&, Board&)>;
  Probe(std::string name, SignalUse use, Act act, Timing timing = {})
      : Task(std::move(name), timing), use_(use), act_(std::move(act)) {}
  [[nodiscard]] SignalUse uses() const override { return use_; }
  void act(const ClockTick& tick, Board& board, double* /*row*/) override { act_(tick, board); }

 private:
  SignalUse use_;
  Act act_;
};

std::unique_ptr<Task> probe(const char* name, SignalSet reads, SignalSet writes,
                            Probe::Act act = {}, Timing timing = {}, SignalSet earlier = {}) {
  if (!act) act = [](const ClockTick&, Board&) {};
  return std::make_unique<Probe>(name, SignalUse{reads, writes, earlier}, std::move(act), timing);
}

template <class... Task>
Tasks tasksOf(Task... task) {
  Tasks tasks;
  (tasks.push_back(std::move(task)), ...);
  return tasks;
}

std::string refusal(Tasks tasks, SignalSet given = {}) {
  try {
    const Scheduler scheduler(std::move(tasks), given);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return {};
}

/// A controller that only this file knows: holds height by the square root of what is missing, and
/// the attitude by rates and angles.
class TestController final : public Controller {
 public:
  explicit TestController(const ControlModel& model)
      : Controller("controller", {}), model_(model), allocation_(model) {}
  [[nodiscard]] std::vector<HeldQuantity> held() const override {
    return {{"altitude", "position.z", "setpoint.z", 1, false,
             [](const SetPoint& s) -> const double& { return s.height; },
             [](const Truth& t) -> const double& { return t.body.position[2]; }}};
  }
  [[nodiscard]] std::vector<Channel> channels() const override {
    return {{"test.climb", "m/s^2", "Climb demanded"}};
  }
  void act(const ClockTick& /*tick*/, Board& board, double* row) override {
    const BodyMotion& is = board.estimate.body;
    const double climb = 4 * (board.setPoint.height - is.position[2]) - 4 * is.velocity[2];
    const Eigen::Vector3d turn = -100 * is.attitude - 20 * is.rates;
    Wrench wrench;
    wrench << model_.mass * (model_.gravity + climb), model_.inertia * turn;
    const auto thrust = allocation_.allocate(wrench).thrust;
    for (int i = 0; i < model_.rotors; ++i) {
      board.demand.speed[i] =
          std::sqrt(thrust[i] / model_.thrustFactor[static_cast<std::size_t>(i)]);
    }
    *row = climb;
  }

 private:
  ControlModel model_;
  Allocation allocation_;
};

/// Sensors with noise on what the speed controllers see, drawn from the run's seed.
class NoisySensors final : public Task {
 public:
  explicit NoisySensors(std::uint64_t seed) : Task("sensors", {}), noise_(seed, "rotor speed") {}
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Truth, .writes = Signal::Measurement, .readsEarlier = {}};
  }
  void act(const ClockTick& /*tick*/, Board& board, double* /*row*/) override {
    board.measurement.drives = board.truth.drives;
    for (int i = 0; i < board.rotors; ++i) board.measurement.drives.speed[i] += noise_.normal();
  }

 private:
  RandomStream noise_;
};

std::string bytesOf(const Recording& recording) {
  std::string bytes;
  for (std::size_t c = 0; c < recording.channels().size(); ++c) {
    bytes += recording.channels()[c].name;
    for (std::size_t row = 0; row < recording.rows(); ++row) {
      const double value = recording.value(c, row);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  return bytes;
}

BuildContext contextOf(const Experiment& e, const std::filesystem::path& directory) {
  return {e.outputs, e.seed, directory, Place("setup")};
}

}  // namespace

class TestScheduler : public QObject {
  Q_OBJECT
 private slots:
  void orderFollowsFromSignals() {
    std::string order;
    const auto note = [&order](char c) {
      return [&order, c](const ClockTick&, Board&) { order += c; };
    };
    Tasks tasks =
        tasksOf(probe("a", Signal::RotorDemand, Signal::RotorCommand, note('4')),
                probe("b", Signal::Estimate | Signal::SetPoint, Signal::RotorDemand, note('3')),
                probe("c", Signal::Measurement, Signal::Estimate, note('2')),
                probe("d", Signal::Truth, Signal::Measurement, note('1')),
                probe("e", {}, Signal::SetPoint, note('0')));
    Scheduler scheduler(std::move(tasks), Signal::Truth);
    Board board;
    scheduler.run({}, board, nullptr);
    QVERIFY2(order.find('1') < order.find('2') && order.find('2') < order.find('3') &&
                 order.find('0') < order.find('3') && order.find('3') < order.find('4'),
             order.c_str());
  }

  void faultsAreNamed() {
    QCOMPARE(refusal(tasksOf(probe("eyes", Signal::Truth, Signal::Measurement))),
             std::string("eyes reads Truth, which nobody writes"));
    QCOMPARE(refusal(tasksOf(probe("a", {}, Signal::SetPoint), probe("b", {}, Signal::SetPoint))),
             std::string("SetPoint is written by a and by b"));
    QCOMPARE(refusal(tasksOf(probe("a", {}, Signal::SetPoint), probe("a", {}, Signal::Estimate))),
             std::string("two tasks are named a"));
    const auto circle = refusal(tasksOf(probe("hen", Signal::Estimate, Signal::SetPoint),
                                        probe("egg", Signal::SetPoint, Signal::Estimate)));
    QVERIFY2(circle.find("egg, hen") != std::string::npos, circle.c_str());
    // Whoever says that it reads an earlier value may.
    QCOMPARE(refusal(tasksOf(probe("hen", {}, Signal::SetPoint, {}, {}, Signal::Estimate),
                             probe("egg", Signal::SetPoint, Signal::Estimate))),
             std::string());
    QCOMPARE(refusal(tasksOf(probe("late", {}, Signal::SetPoint, {}, {}, Signal::Estimate))),
             std::string("late reads Estimate, which nobody writes"));
  }

  /// 1 kHz over 250 Hz over 50 Hz: each link hands the time on. What reaches the end is as old as
  /// the holds since, and not a tick older: (t mod 20 ms), whatever the order of registration.
  void unequalRatesMeetTheirDelay_data() {
    QTest::addColumn<int>("permutation");
    for (int i = 0; i < 6; ++i) QTest::addRow("%d", i) << i;
  }
  void unequalRatesMeetTheirDelay() {
    QFETCH(int, permutation);
    Tasks tasks = tasksOf(
        probe("height", Signal::Truth, Signal::SetPoint,
              [](const ClockTick&, Board& b) { b.setPoint.height = b.truth.openCircuit; }, {20}),
        probe("attitude", Signal::SetPoint, Signal::RotorDemand,
              [](const ClockTick&, Board& b) { b.demand.speed[0] = b.setPoint.height; }, {4}),
        probe("speed", Signal::RotorDemand, Signal::RotorCommand,
              [](const ClockTick&, Board& b) { b.command.value[0] = b.demand.speed[0]; }));
    std::array<int, 3> order{0, 1, 2};
    for (int i = 0; i < permutation; ++i) std::next_permutation(order.begin(), order.end());
    Tasks permuted;
    for (const int i : order) permuted.push_back(std::move(tasks[static_cast<std::size_t>(i)]));
    Scheduler scheduler(std::move(permuted), Signal::Truth);
    Board board;
    for (int k = 0; k < 200; ++k) {
      board.truth.openCircuit = k;
      scheduler.run({k * 1e-3, 1e-3}, board, nullptr);
      QCOMPARE(board.command.value[0], static_cast<double>(k - k % 20));
    }
  }

  /// A reading of an earlier tick is one period of its writer older.
  void earlierReadingsAreATickOld() {
    Tasks tasks = tasksOf(
        probe(
            "a reader", {}, Signal::SetPoint,
            [](const ClockTick&, Board& b) { b.setPoint.height = b.estimate.body.position[2]; }, {},
            Signal::Estimate),
        probe(
            "writer", Signal::Truth | Signal::SetPoint, Signal::Estimate,
            [](const ClockTick&, Board& b) { b.estimate.body.position[2] = b.truth.openCircuit; }));
    Scheduler scheduler(std::move(tasks), Signal::Truth);
    Board board;
    for (int k = 0; k < 10; ++k) {
      board.truth.openCircuit = k;
      scheduler.run({}, board, nullptr);
      QCOMPARE(board.setPoint.height, static_cast<double>(std::max(0, k - 1)));
    }
  }

  void offsetsShiftTasks() {
    std::vector<double> times;
    Tasks tasks =
        tasksOf(probe("late", {}, Signal::SetPoint,
                      [&](const ClockTick& t, Board&) { times.push_back(t.time); }, {3, 2}));
    Scheduler scheduler(std::move(tasks), {});
    Board board;
    for (int k = 0; k < 10; ++k) scheduler.run({static_cast<double>(k), 1}, board, nullptr);
    QCOMPARE(times, (std::vector<double>{2, 5, 8}));
  }

  /// The flagship with its tasks registered in another order: the same bytes.
  void registrationDoesNotMatter() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& flight = alternative<Flight>(e.setup);
    flight.duration = 2;
    const std::filesystem::path directory;
    const BuildContext context = contextOf(e, directory);
    const auto& inputs = alternative<ControlledInputs>(flight.control);
    const auto fly = [&](bool reversed) {
      FlightParts parts = controlledFlight(flight, inputs, context, [&](const ControlModel& model) {
        return std::make_unique<PidFlight>(std::get<PidFlightParameters>(inputs.controller), model,
                                           Timing{2});
      });
      if (reversed) std::ranges::reverse(parts.tasks);
      FlightSimulation simulation(flight, e.outputs, std::move(parts));
      while (simulation.advance(500) == SimulationState::Running) {
      }
      return bytesOf(*simulation.runs().front().recording);
    };
    const std::string bytes = fly(false);
    QVERIFY(bytes == fly(true));
    // And they are those of the experiment as the window builds it.
    const auto built = runToEnd(e);
    QVERIFY(bytes == bytesOf(*built->runs().front().recording));
  }

  /// A controller of the test's own: it flies, its channel is recorded, its figures are made.
  void aControllerFromOutside() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& flight = alternative<Flight>(e.setup);
    flight.duration = 7;
    const std::filesystem::path directory;
    const BuildContext context = contextOf(e, directory);
    ControlledInputs inputs;
    inputs.setPoints = {{0, 0, 0, 0, 0}, {1, 2, 0, 0, 0}};
    FlightSimulation simulation(
        flight, e.outputs, controlledFlight(flight, inputs, context, [](const ControlModel& model) {
          return std::make_unique<TestController>(model);
        }));
    while (simulation.advance(500) == SimulationState::Running) {
    }
    const Recording& r = *simulation.runs().front().recording;
    QVERIFY(std::abs(r.value(*r.find("position.z"), r.rows() - 1) - 2) < 0.01);
    QVERIFY(r.find("test.climb") && r.value(*r.find("test.climb"), 1001) > 7);
    QVERIFY(simulation.verdicts().empty());
    const MetricTable table = simulation.metrics();
    QVERIFY(figure(table, "Flight", "altitude_settling_time") > 1);
    QVERIFY(std::isnan(figure(table, "Flight", "roll_overshoot")));
  }

  /// Another seed is another flight, the same seed the same bytes.
  void seedDecidesTheNoise() {
    Experiment e = shipped("f450-hover-and-steps");
    auto& flight = alternative<Flight>(e.setup);
    flight.duration = 0.5;
    const auto fly = [&](std::uint64_t seed) {
      e.seed = seed;
      const std::filesystem::path directory;
      const BuildContext context = contextOf(e, directory);
      const auto& inputs = alternative<ControlledInputs>(flight.control);
      FlightParts parts = controlledFlight(flight, inputs, context, [&](const ControlModel& model) {
        return std::make_unique<PidFlight>(std::get<PidFlightParameters>(inputs.controller), model,
                                           Timing{2});
      });
      std::ranges::find(parts.tasks, "sensors", [](const auto& t) {
        return t->name();
      })->reset(new NoisySensors(context.seed));
      FlightSimulation simulation(flight, e.outputs, std::move(parts));
      while (simulation.advance(500) == SimulationState::Running) {
      }
      return bytesOf(*simulation.runs().front().recording);
    };
    const std::string first = fly(1);
    QVERIFY(first == fly(1));
    QVERIFY(first != fly(2));
  }

  /// Rates that do not fit, inputs without a file, vehicles that cannot be: named where they stand.
  void faultsAreNamedFromTheRoot() {
    const auto pathOf = [](const Experiment& e) {
      try {
        buildSimulation(e);
      } catch (const InputError& error) {
        return error.problems().front().path;
      }
      return std::string();
    };
    Experiment e = shipped("f450-hover-and-steps");
    auto& flight = alternative<Flight>(e.setup);
    auto& inputs = alternative<ControlledInputs>(flight.control);
    auto& pid = std::get<PidFlightParameters>(inputs.controller);
    pid.rate = 300;
    QCOMPARE(pathOf(e), std::string("setup.control.controller.rate"));
    pid.rate = 500;
    inputs.motors.rate = 300;
    QCOMPARE(pathOf(e), std::string("setup.control.motors.rate"));
    inputs.motors.rate = 1000;
    FreeLayout line;
    for (int i = 0; i < 4; ++i)
      line.rotors[static_cast<std::size_t>(i)].position = {0.1 * (i - 1.5), 0, 0};
    flight.vehicle.layout = line;
    QCOMPARE(pathOf(e), std::string("setup.vehicle.layout"));
  }
};

QTEST_GUILESS_MAIN(TestScheduler)
#include "test_scheduler.moc"
