// Battery, speed controller, motor and load coupled: the energy ledger, closed forms, limits and
// symmetries.
#include <QtTest>
#include <cmath>
#include <random>

#include "sim/ode/solver.h"
#include "sim/propulsion/drive/drive_train.h"

using namespace rotorbench;

namespace {

using State = DriveTrain::State;

DriveTrainSetup e305() {
  DriveTrainSetup setup;
  setup.supply = BatteryParameters{};
  setup.motor = djiE305();
  setup.esc = {.resistance = 0.005, .responseTime = 0.01};
  setup.load = {.quadratic = {1, {2.0e-7, 2.0e-7}}, .thrust = {1, {1e-5, 1e-5}}};
  setup.inertia = 6.05e-5;
  return setup;
}

/// From rest with the throttle given, for `seconds`.
State run(DriveTrain& train, double throttle, double seconds, double step = 2e-5) {
  ode::SolverSettings settings{.method = ode::Method::Rk4, .step = step};
  ode::Solver<DriveTrain> solver(settings, train);
  State y = train.initialState();
  train.setThrottle(throttle, y);
  if (solver.advanceTo(seconds, y) != ode::Status::Done) qFatal("the run failed");
  return y;
}

}  // namespace

class TestDriveTrain : public QObject {
  Q_OBJECT
 private slots:
  /// What leaves the cells is stored or lost, at any state and not only on solutions.
  void energyLedgerCloses_data() {
    QTest::addColumn<bool>("quasiStatic");
    QTest::addColumn<bool>("braking");
    for (const bool quasiStatic : {false, true})
      for (const bool braking : {false, true})
        QTest::addRow("%s, %s", quasiStatic ? "quasi-static" : "dynamic",
                      braking ? "braking" : "coasting")
            << quasiStatic << braking;
  }
  void energyLedgerCloses() {
    QFETCH(bool, quasiStatic);
    QFETCH(bool, braking);
    DriveTrainSetup setup = e305();
    setup.quasiStaticCurrent = quasiStatic;
    setup.esc.activeBraking = braking;
    setup.esc.reverse = true;
    DriveTrain train(setup);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 2000; ++k) {
      State y;
      y << 25 * any(random), 900 * any(random), any(random), 0.5 + 0.5 * any(random),
          0.2 * any(random);
      train.setThrottle(any(random), y);
      const DrivePowers p = train.powers(y);
      const double size = std::abs(p.source) + std::abs(p.load) + std::abs(p.magnetic) +
                          std::abs(p.kinetic) + p.copperLoss;
      QVERIFY2(std::abs(p.residual()) <= 1e-9 * size,
               qPrintable(QString::number(p.residual() / size)));
    }
  }

  /// Free motor on an ideal supply: I0 at the no-load voltage, stall current V/R.
  void dataSheetPoints() {
    DriveTrainSetup setup;
    setup.supply = SupplyParameters{.voltage = 10};
    setup.motor = djiE305();
    setup.motor.noLoadVoltage = 10;
    setup.motor.maxCurrent = setup.esc.maxCurrent = 1000;
    setup.esc.resistance = 0;
    const DriveTrain train(setup);
    const State y = train.steadyState(1, 1, 0);
    QVERIFY(std::abs(train.instant(y).current - 0.45) < 1e-6);
    QVERIFY(std::abs(y[DriveTrain::kSpeed] - (10 - 0.117 * 0.45) * setup.motor.speedConstant) <
            1e-6);
    State stalled = train.steadyState(1, 1, 0);
    stalled[DriveTrain::kSpeed] = 0;
    setup.quasiStaticCurrent = true;
    QVERIFY(std::abs(DriveTrain(setup).instant(stalled).current - 10 / 0.117) < 1e-9);
  }

  /// Without friction and load the quasi-static motor is first order: w = V/K (1 - exp(-t/tau)),
  /// tau = J R/K^2.
  void stepResponseMeetsClosedForm() {
    DriveTrainSetup setup;
    setup.supply = SupplyParameters{.voltage = 10};
    setup.motor.noLoadCurrent = 0;
    setup.motor.maxCurrent = setup.esc.maxCurrent = 1e4;
    setup.esc = {.resistance = 0, .responseTime = 0, .maxCurrent = 1e4};
    setup.inertia = 6e-5;
    setup.quasiStaticCurrent = true;
    DriveTrain train(setup);
    const double k = 1 / setup.motor.speedConstant;
    const double tau = setup.inertia * setup.motor.resistance / (k * k);
    const double t = 0.1;
    const State y = run(train, 1, t, 1e-3);
    const double expected = 10 / k * -std::expm1(-t / tau);
    QVERIFY2(std::abs(y[DriveTrain::kSpeed] / expected - 1) < 1e-9,
             qPrintable(QString::number(y[DriveTrain::kSpeed] / expected - 1)));
  }

  /// The inductance delays, it does not change where the motor ends; steady points solved directly
  /// are those reached.
  void steadyStateIsReached_data() {
    QTest::addColumn<double>("throttle");
    for (const double u : {0.1, 0.4, 0.7, 1.0}) QTest::addRow("throttle %.1f", u) << u;
  }
  void steadyStateIsReached() {
    QFETCH(double, throttle);
    for (const bool quasiStatic : {false, true}) {
      DriveTrainSetup setup = e305();
      setup.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.02};
      setup.quasiStaticCurrent = quasiStatic;
      DriveTrain train(setup);
      const State reached = run(train, throttle, 5);
      const State solved = train.steadyState(throttle, 1, 0);
      const auto a = train.instant(reached), b = train.instant(solved);
      QVERIFY2(std::abs(reached[DriveTrain::kSpeed] / solved[DriveTrain::kSpeed] - 1) < 1e-8,
               qPrintable(
                   QString::number(reached[DriveTrain::kSpeed] / solved[DriveTrain::kSpeed] - 1)));
      QVERIFY(std::abs(a.current - b.current) < 1e-6);
      QVERIFY(std::abs(a.busVoltage - b.busVoltage) < 1e-8);
      QVERIFY(std::abs(a.busVoltage - (11.1 - 0.02 * a.busCurrent)) < 1e-12);
    }
  }

  void currentStaysWithinItsLimit() {
    DriveTrainSetup setup = e305();
    setup.supply = SupplyParameters{.voltage = 16.8};
    setup.motor.maxCurrent = 12;
    setup.esc.responseTime = 0;
    DriveTrain train(setup);
    ode::Solver<DriveTrain> solver({.method = ode::Method::Rk4, .step = 2e-5}, train);
    State y = train.initialState();
    train.setThrottle(1, y);
    double most = 0, least = 0;
    for (int k = 1; k <= 6000; ++k) {
      if (k == 3000) {
        train.setThrottle(0, y);
        solver.restart();
      }
      QCOMPARE(solver.advanceTo(k * 1e-4, y), ode::Status::Done);
      most = std::max(most, y[DriveTrain::kCurrent]);
      least = std::min(least, y[DriveTrain::kCurrent]);
    }
    QVERIFY2(most <= 12 * (1 + 1e-9) && most > 11.9, qPrintable(QString::number(most)));
    QVERIFY2(least >= -12 * (1 + 1e-9) && least < -5, qPrintable(QString::number(least)));
  }

  void withoutBrakingNoCurrentFlowsBack() {
    DriveTrainSetup setup = e305();
    setup.esc.activeBraking = false;
    setup.esc.responseTime = 0;
    DriveTrain coasting(setup);
    setup.esc.activeBraking = true;
    DriveTrain braking(setup);
    const auto slowed = [](DriveTrain& train, double& least) {
      ode::Solver<DriveTrain> solver({.method = ode::Method::Rk4, .step = 2e-5}, train);
      State y = train.steadyState(0.8, 1, 0);
      train.setThrottle(0.2, y);
      for (int k = 1; k <= 500; ++k) {
        solver.advanceTo(k * 1e-4, y);
        least = std::min(least, y[DriveTrain::kCurrent]);
      }
      return y[DriveTrain::kSpeed];
    };
    double leastCoasting = 0, leastBraking = 0;
    const double coasted = slowed(coasting, leastCoasting), braked = slowed(braking, leastBraking);
    QVERIFY2(leastCoasting == 0, qPrintable(QString::number(leastCoasting)));
    QVERIFY(leastBraking < -5);
    QVERIFY2(coasted > 1.1 * braked, qPrintable(QString("%1 %2").arg(coasted).arg(braked)));
  }

  void reverseIsTheMirrorImage() {
    DriveTrainSetup setup = e305();
    setup.esc.reverse = true;
    DriveTrain forward(setup), backward(setup);
    const State a = run(forward, 0.6, 0.3), b = run(backward, -0.6, 0.3);
    QCOMPARE(b[DriveTrain::kSpeed], -a[DriveTrain::kSpeed]);
    QCOMPARE(b[DriveTrain::kCurrent], -a[DriveTrain::kCurrent]);
    QCOMPARE(b[DriveTrain::kCharge], a[DriveTrain::kCharge]);
  }

  /// Charge taken out equals the integral of the bus current; voltage sags by R_0 at once and by
  /// R_1 in the end.
  void batteryCountsCharge() {
    BatteryParameters battery;
    battery.openCircuit = {{0, 4}, {1, 4}};
    battery.capacity = 500;
    battery.polarisationTime = 0.05;
    DriveTrainSetup setup = e305();
    setup.supply = battery;
    DriveTrain train(setup);
    ode::Solver<DriveTrain> solver({.method = ode::Method::Rk4, .step = 2e-5}, train);
    State y = train.initialState();
    train.setThrottle(0.7, y);
    double charge = 0, before = 0;
    for (int k = 1; k <= 20000; ++k) {
      solver.advanceTo(k * 1e-4, y);
      const double current = train.instant(y).busCurrent;
      charge += 0.5e-4 * (before + current);
      before = current;
    }
    QVERIFY2(std::abs((1 - y[DriveTrain::kCharge]) * 500 / charge - 1) < 1e-5,
             qPrintable(QString::number((1 - y[DriveTrain::kCharge]) * 500 / charge - 1)));
    const auto at = train.instant(y);
    QVERIFY(std::abs(at.busVoltage - (12 - 3 * (0.006 + 0.003) * at.busCurrent)) < 1e-4);
  }

  /// Chen and Rincon-Mora, eq. (2), gone on with to 1.09499 of their charge, where a cell has
  /// 4.20 V: the values at empty, half and full.
  void lithiumPolymerCurve() {
    BatteryParameters battery;
    battery.series = 1;
    const Supply supply{SupplyModel(battery)};
    QVERIFY(std::abs(supply.openCircuit(0.0) - (3.685 - 1.031)) < 1e-3);
    QVERIFY(std::abs(supply.openCircuit(0.5) - (3.685 + 0.11804 - 0.03531 + 0.05253)) < 1e-3);
    QVERIFY(std::abs(supply.openCircuit(1.0) - 4.2) < 1e-3);
    double before = 0;
    for (int k = 0; k <= 1000; ++k) {
      const double v = supply.openCircuit(k / 1000.0);
      QVERIFY(v >= before);
      before = v;
    }
  }

  /// A state that is no number stays one, so that the solver finds it.
  void notANumberGoesOn() {
    const DriveTrain train(e305());
    for (int i = 0; i < DriveTrain::kStates; ++i) {
      State y = train.steadyState(0.5, 1, 0), rate;
      y[i] = std::numeric_limits<double>::quiet_NaN();
      train.derivative(y, rate);
      QVERIFY2(!rate.allFinite(), DriveTrain::componentName(i).data());
    }
  }

  /// The pole is that of the matrix: a small disturbance decays with it. Methods are stable below
  /// the limit and not above.
  void fastestPole() {
    DriveTrainSetup setup = e305();
    setup.supply = SupplyParameters{.voltage = 11.1};
    const DriveTrain train(setup);
    // Two real poles: their sum is r/L + drag/J and the slow one is near K^2/(r J).
    const double r = 0.117 + 0.005, k = 1 / setup.motor.speedConstant;
    const double fast = train.fastestPole(500);
    QVERIFY(fast < r / 50e-6 + 1000 && fast > 0.5 * r / 50e-6);
    setup.quasiStaticCurrent = true;
    const double slow = DriveTrain(setup).fastestPole(500);
    QVERIFY2(slow > k * k / (r * 6.05e-5) && slow < 2 * k * k / (r * 6.05e-5),
             qPrintable(QString::number(slow)));
  }
};

QTEST_APPLESS_MAIN(TestDriveTrain)
#include "test_drive_train.moc"
