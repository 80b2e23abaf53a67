// The speed controllers of a flying vehicle: lag, direction, braking, limit and energy, and that
// they are those of the stands.
#include <QtTest>
#include <cmath>
#include <random>

#include "sim/ode/solver.h"
#include "sim/propulsion/drive/drive_train.h"
#include "sim/vehicle/multirotor.h"
#include "tests/sim/ode/function_system.h"

using namespace rotorbench;
using test::fixedStep;
using Plant = Multirotor<4>;
using L = Plant::Layout;

namespace {

VehicleParameters vehicle(const EscParameters& esc) {
  VehicleParameters v;
  std::get<EqualRotors>(v.rotors).rotor.esc = esc;
  return v;
}

/// Flies with the command held, showing every `tick` to `watch`.
template <class Watch>
Plant::State fly(Plant& plant, const ode::SolverSettings& settings, Plant::State y,
                 const Plant::Command& command, double seconds, double tick, Watch&& watch) {
  plant.setCommand(command, y);
  ode::Solver<Plant> solver(settings, plant);
  const auto ticks = std::lround(seconds / tick);
  for (long k = 1; k <= ticks; ++k) {
    if (solver.advanceTo(static_cast<double>(k) * tick, y) != ode::Status::Done)
      qFatal("the flight failed");
    watch(solver.time(), y);
  }
  return y;
}

}  // namespace

class TestMultirotorEsc : public QObject {
  Q_OBJECT
 private slots:
  /// d = u + (d0 - u) exp(-t/T), at any T with the exponential method: it may be far below the
  /// step.
  void dutyFollowsItsLag_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<double>("responseTime");
    QTest::addColumn<double>("step");
    QTest::addColumn<double>("allowed");
    const int exponential = int(ode::Method::ExponentialRk4), rk4 = int(ode::Method::Rk4);
    QTest::addRow("20 ms, exponential") << exponential << 0.02 << 1e-3 << 1e-13;
    QTest::addRow("1 ms, exponential") << exponential << 1e-3 << 1e-3 << 1e-13;
    QTest::addRow("10 us, exponential") << exponential << 1e-5 << 1e-3 << 1e-13;
    QTest::addRow("none, exponential") << exponential << 0.0 << 1e-3 << 0.0;
    QTest::addRow("20 ms, RK4") << rk4 << 0.02 << 1e-4 << 1e-11;
    QTest::addRow("none, RK4") << rk4 << 0.0 << 1e-4 << 0.0;
  }
  void dutyFollowsItsLag() {
    QFETCH(int, method);
    QFETCH(double, responseTime);
    QFETCH(double, step);
    QFETCH(double, allowed);
    Plant plant(buildMultirotor<4>(vehicle({.responseTime = responseTime}), {}));
    const Plant::State start = plant.initialState({});
    const Plant::Command from = start.segment<4>(L::kDuty), to(0.2, 0.5, 0.9, 1.0);
    double worst = 0;
    fly(plant, fixedStep(static_cast<ode::Method>(method), step), start, to, 0.05, step,
        [&](double t, const Plant::State& y) {
          const double left = responseTime > 0 ? std::exp(-t / responseTime) : 0;
          const Plant::Command expected = to + (from - to) * left;
          worst = std::max(worst, (y.segment<4>(L::kDuty) - expected).cwiseAbs().maxCoeff());
        });
    QVERIFY2(worst <= allowed, qPrintable(QString::number(worst)));
  }

  /// Hover with the steady duties is an equilibrium with a lag too: the flight starts with the
  /// duties it needs.
  void lagKeepsHover() {
    VehicleParameters v = vehicle({.resistance = 0.01, .responseTime = 0.03});
    std::get<SupplyParameters>(v.supply).internalResistance = 0.02;
    Plant plant(buildMultirotor<4>(v, {}));
    Plant::State y = plant.initialState({}), d;
    plant.setCommand(plant.steadyDuties(plant.hoverSpeeds()), y);
    plant(0, y, d);
    QVERIFY2(d.head<L::kCharge>().cwiseAbs().maxCoeff() < 1e-8,
             qPrintable(QString::number(d.head<L::kCharge>().cwiseAbs().maxCoeff())));
    FlightStart stopped;
    stopped.rotors = RotorStart::Stopped;
    QVERIFY(plant.initialState(stopped).segment<4>(L::kDuty).isZero());
  }

  /// The exponential method is of fourth order with the lag in the state.
  void fourthOrder() {
    Plant plant(buildMultirotor<4>(vehicle({.responseTime = 8e-3}), {}));
    const Plant::State start = plant.initialState({});
    const Plant::Command to(0.55, 0.6, 0.65, 0.6);
    const auto end = [&](const ode::SolverSettings& settings) {
      return fly(plant, settings, start, to, 0.04, 0.04, [](auto&&...) {});
    };
    const Plant::State exact = end(test::adaptive(ode::Method::Rk547M, 1e-13));
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double step = 5e-4 / static_cast<double>(1 << i);  // L/R is 0.43 ms
      errors[i] = (end(fixedStep(ode::Method::ExponentialRk4, step)) - exact).norm();
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const double order = std::log2(errors[i] / errors[i + 1]);
      QVERIFY2(order > 3.5 && order < 5.0, qPrintable(QString("%1: %2").arg(order).arg(errors[i])));
    }
  }

  void commandsAreCutOff_data() {
    QTest::addColumn<bool>("reverse");
    QTest::addRow("one way") << false;
    QTest::addRow("reversible") << true;
  }
  void commandsAreCutOff() {
    QFETCH(bool, reverse);
    for (const double responseTime : {0.0, 0.01}) {
      Plant plant(
          buildMultirotor<4>(vehicle({.responseTime = responseTime, .reverse = reverse}), {}));
      FlightStart stopped;
      stopped.rotors = RotorStart::Stopped;
      const Plant::State end =
          fly(plant, fixedStep(ode::Method::ExponentialRk4, 1e-3), plant.initialState(stopped),
              {-0.5, -7, 0.5, 7}, 0.5, 1e-3, [](auto&&...) {});
      const double least = reverse ? -1 : 0;
      QVERIFY(plant.command() == Plant::Command(std::max(-0.5, least), least, 0.5, 1));
      QVERIFY((end.segment<4>(L::kDuty) - plant.command()).norm() < 1e-12);
      QCOMPARE(end[L::kSpeed + 1] < -400, reverse);
      QCOMPARE(std::abs(end[L::kSpeed + 1]) < 1e-9, !reverse);
      QVERIFY(end[L::kSpeed + 3] > 400);
    }
  }

  /// Throttle closed in flight: a passive speed controller slows the rotor by air and friction
  /// alone, no current flows back, and the supply gains nothing. Both methods tell the same.
  void passiveBrakingLetsGo_data() {
    QTest::addColumn<double>("responseTime");
    QTest::addRow("no lag") << 0.0;
    QTest::addRow("lag") << 5e-3;
  }
  void passiveBrakingLetsGo() {
    QFETCH(double, responseTime);
    struct Seen {
      double speed = 0, least = 0, energy = 0, least2 = 0;
    };
    const auto close = [&](bool braking, const ode::SolverSettings& settings) {
      Plant plant(buildMultirotor<4>(
          vehicle({.responseTime = responseTime, .activeBraking = braking}), {}));
      Seen seen;
      double before = 0;
      const Plant::State end = fly(plant, settings, plant.initialState({}), {0, 0, 0, 0}, 0.05,
                                   1e-3, [&](double, const Plant::State& y) {
                                     seen.least = std::min(seen.least, y[L::kCurrent]);
                                     seen.least2 = std::min(seen.least2, y[L::kEnergy] - before);
                                     before = y[L::kEnergy];
                                   });
      seen.speed = end[L::kSpeed];
      return seen;
    };
    const ode::SolverSettings own = fixedStep(ode::Method::ExponentialRk4, 1e-3),
                              fine = fixedStep(ode::Method::Rk4, 1e-5);
    const Seen braked = close(true, own), coasted = close(false, own), check = close(false, fine);
    QVERIFY2(coasted.speed > 1.1 * braked.speed,
             qPrintable(QString("%1 %2").arg(coasted.speed).arg(braked.speed)));
    QVERIFY(braked.least < -1);
    QCOMPARE(coasted.least, 0.0);
    QCOMPARE(check.least, 0.0);
    QVERIFY2(coasted.least2 >= 0, qPrintable(QString::number(coasted.least2)));
    QVERIFY(check.least2 >= 0);
    QVERIFY2(std::abs(coasted.speed / check.speed - 1) < 1e-4,
             qPrintable(QString("%1 %2").arg(coasted.speed).arg(check.speed)));
  }

  /// What leaves the cells is stored or lost, at any state and with every speed controller; without
  /// active braking no power returns while the currents flow the way they may.
  void energyLedger_data() {
    QTest::addColumn<EscParameters>("esc");
    for (const bool reverse : {false, true}) {
      for (const bool braking : {false, true}) {
        for (const double lag : {0.0, 0.02}) {
          QTest::addRow("%s, %s, %g s", reverse ? "reversible" : "one way",
                        braking ? "braking" : "passive", lag)
              << EscParameters{.resistance = 0.008,
                               .responseTime = lag,
                               .maxCurrent = 18,
                               .reverse = reverse,
                               .activeBraking = braking};
        }
      }
    }
  }
  void energyLedger() {
    QFETCH(EscParameters, esc);
    VehicleParameters v = vehicle(esc);
    v.supply = BatteryParameters{.charge = 0.8};
    v.avionicsPower = 6;
    Plant plant(buildMultirotor<4>(v, {}));
    Plant::State y = plant.initialState({});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 2000; ++k) {
      Plant::Command command;
      for (int i = 0; i < 4; ++i) {
        y[L::kSpeed + i] = 900 * any(random);
        y[L::kCurrent + i] = 25 * any(random);
        y[L::kDuty + i] = plant.allowed(Plant::Command::Constant(any(random)))[i];
        command[i] = any(random);
      }
      y[L::kPolarisation] = 0.2 * any(random);
      // settle() has taken away what a passive speed controller does not let flow.
      plant.setCommand(command, y);
      const FlightPowers p = plant.powers(0, y);
      const double size = std::abs(p.source) + std::abs(p.shaft) + std::abs(p.magnetic) +
                          std::abs(p.kinetic) + p.copperLoss;
      QVERIFY2(std::abs(p.residual()) <= 1e-9 * size,
               qPrintable(QString("%1 of %2 W").arg(p.residual()).arg(size)));
      if (!esc.activeBraking) QVERIFY2(p.source >= 0, qPrintable(QString::number(p.source)));
    }
  }

  /// A rotor of a vehicle too heavy to move is a motor on a stand: same course of speed, current
  /// and duty.
  void rotorEqualsStand_data() {
    QTest::addColumn<EscParameters>("esc");
    QTest::addColumn<double>("second");  // command after half the time
    QTest::addRow("lag") << EscParameters{.resistance = 0.005, .responseTime = 0.01} << 0.2;
    QTest::addRow("no lag") << EscParameters{.responseTime = 0} << 0.2;
    QTest::addRow("passive") << EscParameters{.responseTime = 0, .activeBraking = false} << 0.2;
    QTest::addRow("passive with a lag")
        << EscParameters{.responseTime = 0.01, .activeBraking = false} << 0.1;
    QTest::addRow("limited") << EscParameters{.responseTime = 0.01, .maxCurrent = 8} << 0.9;
    QTest::addRow("reversed") << EscParameters{.responseTime = 0.01, .reverse = true} << -0.5;
    QTest::addRow("reversed, passive")
        << EscParameters{.responseTime = 0, .reverse = true, .activeBraking = false} << -0.5;
  }
  void rotorEqualsStand() {
    QFETCH(EscParameters, esc);
    QFETCH(double, second);
    VehicleParameters v = vehicle(esc);
    std::get<DirectMass>(v.mass).mass = 1e9;
    std::get<DirectMass>(v.mass).inertia = {.xx = 1e9, .yy = 1e9, .zz = 1e9};
    EnvironmentParameters still;
    still.gravity = 0;
    Plant plant(buildMultirotor<4>(v, still));
    const auto& hub = plant.constants().hubs[0];
    const double torque = plant.constants().air.density(0.0) * hub.rotor.torque;
    const RotorParameters& rotor = std::get<EqualRotors>(v.rotors).rotor;
    DriveTrain train({.supply = v.supply,
                      .esc = esc,
                      .motor = rotor.motor,
                      .load = {.quadratic = {1, {torque, torque}}},
                      .inertia = rotor.inertia});
    FlightStart stopped;
    stopped.rotors = RotorStart::Stopped;
    Plant::State y = plant.initialState(stopped);
    DriveTrain::State stand = train.initialState();
    const ode::SolverSettings settings = fixedStep(ode::Method::Rk4, 2e-5);
    ode::Solver<DriveTrain> solver(settings, train);
    double time = 0;
    for (const double command : {0.7, second}) {
      train.setThrottle(command, stand);
      solver.restart();
      y = fly(plant, settings, y, Plant::Command::Constant(command), 0.1, 1e-3,
              [&](double t, const Plant::State& at) {
                solver.advanceTo(time + t, stand);
                QVERIFY2(std::abs(at[L::kSpeed] - stand[DriveTrain::kSpeed]) < 1e-6,
                         qPrintable(QString("%1 s: %2 %3")
                                        .arg(time + t)
                                        .arg(at[L::kSpeed])
                                        .arg(stand[DriveTrain::kSpeed])));
                QVERIFY(std::abs(at[L::kCurrent] - stand[DriveTrain::kCurrent]) < 1e-6);
                QVERIFY(std::abs(at[L::kDuty] - stand[DriveTrain::kDuty]) < 1e-12);
              });
      time += 0.1;
    }
    QVERIFY2((y[L::kSpeed] < 0) == (second < 0), qPrintable(QString::number(y[L::kSpeed])));
  }
};

QTEST_APPLESS_MAIN(TestMultirotorEsc)
#include "test_multirotor_esc.moc"
