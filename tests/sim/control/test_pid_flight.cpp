#include <QtTest>
#include <cmath>

#include "sim/control/pid_flight.h"
#include "sim/control/speed_controllers.h"
#include "sim/core/schema_tree.h"
#include "sim/run/plant_handle.h"
#include "sim/run/scheduler.h"
#include "sim/vehicle/multirotor.h"
#include "tests/sim/vehicle/plain_rk4.h"

using namespace rotorbench;
using Plant = Multirotor<4>;
using L = MultirotorLayout<4>;

namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kTick = 1e-3;

BodyMotion bodyOf(const Plant::State& y, const MultirotorForces<4>& forces) {
  return {y.segment<3>(L::kPosition), y.segment<3>(L::kVelocity), forces.attitude, forces.rates};
}

/// Controller 1 with its speed controllers, asked at every tick of 1 ms.
struct Cascade {
  ControlModel model;
  PidFlight pid;
  SpeedControllers motors;
  int every = ticksBetween(PidFlightParameters{}.rate, kTick, {}), count = 0;

  explicit Cascade(const VehicleParameters& v)
      : model(controlModel(v, {}, {})), pid({}, model, {}), motors({}, model, {}) {}
  Eigen::Vector4d update(const Plant::State& y, const MultirotorForces<4>& forces,
                         const SetPoint& setPoint) {
    if (count++ % every == 0) pid.update(bodyOf(y, forces), setPoint);
    DriveReadings drives;
    drives.speed.head<4>() = y.segment<4>(L::kSpeed);
    drives.busVoltage = forces.busVoltage;
    PerRotor duties;
    motors.update({pid.rotorSpeedSetPoints()}, drives, duties);
    return duties.head<4>();
  }
};

/// A flight with controller 1, stepped by a plain RK4.
struct Flight4 {
  Plant plant;
  Cascade controller;
  Plant::State y;
  int substeps;
  int limited = 0;
  double mostCurrent = 0;
  double lowestHeight = 0, highestHeight = 0;

  explicit Flight4(const VehicleParameters& v, const FlightStart& start = {}, int steps = 1)
      : plant(buildMultirotor<4>(v, {})),
        controller(v),
        y(plant.initialState(start)),
        substeps(steps) {}

  void fly(double seconds, const SetPoint& setPoint) {
    Plant::State d;
    MultirotorForces<4> forces;
    const auto ticks = std::lround(seconds / kTick);
    limited = 0;
    for (long k = 0; k < ticks; ++k) {
      plant.derivativeAndForces(0, y, d, forces);
      plant.setCommand(controller.update(y, forces, setPoint));
      limited += controller.pid.limited() ? 1 : 0;
      mostCurrent = std::max(mostCurrent, y.segment<4>(L::kCurrent).cwiseAbs().maxCoeff());
      lowestHeight = std::min(lowestHeight, y[L::kPosition + 2]);
      highestHeight = std::max(highestHeight, y[L::kPosition + 2]);
      for (int s = 0; s < substeps; ++s) plainRk4(plant, kTick / substeps, y);
    }
  }
  [[nodiscard]] Eigen::Vector3d attitude() const { return eulerAngles(y.segment<4>(L::kAttitude)); }
  /// Below 1 mm and 0.01 degree.
  [[nodiscard]] bool settledAt(const SetPoint& s) const {
    const Eigen::Vector3d error = attitude() - Eigen::Vector3d(s.roll, s.pitch, s.yaw);
    return std::abs(y[L::kPosition + 2] - s.height) < 1e-3 &&
           error.cwiseAbs().maxCoeff() < 0.01 * kDegree;
  }
};

}  // namespace

class TestPidFlight : public QObject {
  Q_OBJECT
 private slots:
  void settlesOnEverySetPoint_data();
  void settlesOnEverySetPoint();
  void hoverNeedsNoCorrection();
  void yawTakesTheShortWay();
  void recoversFromAnImpossibleDemand();
  void loopsRunAtTheirOwnRates();
  void defaultsAreValid();
};

void TestPidFlight::settlesOnEverySetPoint_data() {
  QTest::addColumn<VehicleParameters>("vehicle");
  QTest::addColumn<int>("substeps");  // the plain RK4 needs them where a circuit is quick
  VehicleParameters unbalanced, soft, parts, small;
  unbalanced.deviations = {{1, {0.02, 0.02, 0}, 0}, {3, Eigen::Vector3d::Zero(), 0.03}};
  std::get<SupplyParameters>(soft.supply).internalResistance = 0.03;
  parts.layout = PlusLayout{};
  parts.mass = PartsMass{};
  parts.payloads = {{0.1, {0.02, 0, -0.05}}};
  small.layout = CrossLayout{.arm = 0.15};
  DirectMass mass;
  mass.mass = 0.9;
  mass.inertia = {.xx = 0.006, .yy = 0.007, .zz = 0.011};
  small.mass = mass;
  QTest::addRow("F450") << VehicleParameters{} << 1;
  QTest::addRow("unbalanced F450: one arm longer, one motor heavier") << unbalanced << 1;
  QTest::addRow("F450 on a soft supply") << soft << 4;
  QTest::addRow("plus layout from parts with a payload") << parts << 1;
  QTest::addRow("half the size") << small << 1;
}

void TestPidFlight::settlesOnEverySetPoint() {
  QFETCH(VehicleParameters, vehicle);
  QFETCH(int, substeps);
  Flight4 flight(vehicle, {}, substeps);
  SetPoint s;
  s.height = 2;
  flight.fly(8, s);
  QVERIFY(flight.settledAt(s));
  QVERIFY2(flight.highestHeight < 2.1, qPrintable(QString::number(flight.highestHeight)));
  s.roll = 10 * kDegree;
  flight.fly(5, s);
  QVERIFY(flight.settledAt(s));
  QVERIFY(flight.y[L::kVelocity + 1] < -1);
  s.roll = 0;
  s.pitch = -8 * kDegree;
  flight.fly(5, s);
  QVERIFY(flight.settledAt(s));
  s.pitch = 0;
  s.yaw = 90 * kDegree;
  flight.fly(10, s);
  QVERIFY(flight.settledAt(s));
  QCOMPARE(flight.limited, 0);
  QVERIFY2(flight.mostCurrent < 21, qPrintable(QString::number(flight.mostCurrent)));
}

void TestPidFlight::hoverNeedsNoCorrection() {
  Flight4 flight{VehicleParameters{}};
  flight.fly(5, {});
  QVERIFY(flight.y.segment<3>(L::kPosition).norm() < 1e-9);
  QVERIFY(flight.attitude().norm() < 1e-9);
}

void TestPidFlight::yawTakesTheShortWay() {
  FlightStart start;
  start.attitude = {0, 0, 170 * kDegree};
  Flight4 flight(VehicleParameters{}, start);
  SetPoint s;
  s.yaw = -170 * kDegree;
  flight.fly(0.5, s);
  const double turned = flight.attitude().z();
  QVERIFY(turned > 170 * kDegree || turned < 0);  // onwards through 180 degrees
  flight.fly(10, s);
  QVERIFY(flight.settledAt(s));
}

/// A climb the motors cannot deliver at once, with every angle stepping together, ends at rest all
/// the same.
void TestPidFlight::recoversFromAnImpossibleDemand() {
  VehicleParameters v;
  v.payloads = {{1.2, {0, 0, 0}}};
  Flight4 flight{v};
  SetPoint s{.height = 20, .roll = 0.3, .pitch = -0.3, .yaw = 2};
  flight.fly(1, s);
  QVERIFY(flight.limited > 0);
  s = {.height = 20, .roll = 0, .pitch = 0, .yaw = 2};
  flight.fly(20, s);
  QVERIFY(flight.settledAt(s));
  QCOMPARE(flight.lowestHeight >= -0.5, true);
}

void TestPidFlight::loopsRunAtTheirOwnRates() {
  PidFlightParameters p;
  p.rate = 250;
  std::vector<std::unique_ptr<Task>> tasks;
  tasks.push_back(std::make_unique<PidFlight>(p, controlModel({}, {}, {}),
                                              Timing{ticksBetween(p.rate, kTick, {})}));
  Scheduler scheduler(std::move(tasks), Signal::Estimate | Signal::SetPoint);
  std::vector<double> row(scheduler.channels().size());
  Board board;
  int changes = 0;
  PerRotor last = PerRotor::Zero();
  for (int k = 0; k < 40; ++k) {
    board.estimate.body.position[2] = -0.001 * k;  // every tick brings another height
    scheduler.run({k * kTick, kTick}, board, row.data());
    if (board.demand.speed != last) ++changes;
    last = board.demand.speed;
  }
  QCOMPARE(changes, 10);
  QCOMPARE(row.back(), last[3]);
}

void TestPidFlight::defaultsAreValid() {
  const PidFlightParameters p;
  QVERIFY(schema::validate(schema::ref(p)).empty());
  const VehicleParameters v;
  QVERIFY(schema::validate(schema::ref(v)).empty());
  const FlightStart start;
  QVERIFY(schema::validate(schema::ref(start)).empty());
}

QTEST_APPLESS_MAIN(TestPidFlight)
#include "test_pid_flight.moc"
