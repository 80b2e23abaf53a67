// What a real converter does beside sharing the voltage: against a switched winding followed
// through its period, against closed forms, and as part of a drive.
#include <QtTest>
#include <cmath>
#include <random>

#include "sim/ode/solver.h"
#include "sim/propulsion/drive/drive_train.h"

using namespace rotorbench;

namespace {

constexpr double kInductance = 25e-6, kFrequency = 8000;

EscConstants diodes(double resistance) {
  EscConstants esc;
  esc.activeBraking = false;
  esc.ripple = 1 / (kInductance * kFrequency);
  esc.pathResistance = resistance;
  return esc;
}

struct Mean {
  double current = 0, square = 0;
};

/// One period of a winding without resistance that begins without current: the switch on for d of
/// it, the diode for as long as it carries.
Mean followed(double d, double bus, double back) {
  constexpr int kSteps = 200000;
  const double dt = 1 / kFrequency / kSteps;
  double i = 0;
  Mean mean;
  for (int k = 0; k < kSteps; ++k) {
    const double v = k < d * kSteps ? bus : 0;
    i = std::max(0.0, i + (v - back) * dt / kInductance);
    mean.current += i / kSteps;
    mean.square += i * i / kSteps;
  }
  return mean;
}

DriveTrainSetup lossy() {
  DriveTrainSetup setup;
  setup.supply = SupplyParameters{.voltage = 11.5, .internalResistance = 0.03};
  setup.motor.speedConstant = 115;
  setup.motor.resistance = 0.1;
  setup.motor.inductance = kInductance;
  setup.motor.noLoadCurrent = 0.8;
  setup.motor.maxCurrent = 60;
  setup.esc = {.resistance = 0.02,
               .activeBraking = false,
               .throttleStart = 0.15,
               .throttleFull = 0.75,
               .pwmFrequency = kFrequency,
               .switchingLoss = 0.09,
               .leadResistance = 0.01};
  setup.load = {.quadratic = {1, {2.5e-7, 2.5e-7}}, .thrust = {1, {1.5e-5, 1.5e-5}}};
  setup.inertia = 4e-5;
  return setup;
}

}  // namespace

class TestConversion : public QObject {
  Q_OBJECT
 private slots:
  void withoutLossesNothingChanges() {
    const EscConstants esc;
    QVERIFY(!esc.lossy());
    const Conversion<double> c = conversion(esc, 0.37, 5.0, 3.0, 11.0);
    QCOMPARE(c.duty, 0.37);
    QCOMPARE(c.chopped, 0.0);
    QCOMPARE(c.perVoltage, 0.0);
    for (const double u : {-1.0, -0.2, 0.0, 0.4, 1.0}) QCOMPARE(esc.dutyOf(u), u);
  }

  /// The mean of an interrupted current, its mean square, and its share of the voltage.
  void interruptedCurrentIsThatOfTheSwitchedWinding_data() {
    QTest::addColumn<double>("duty");
    QTest::addColumn<double>("back");
    for (const double d : {0.1, 0.2, 0.35})
      for (const double e : {5.0, 7.0, 9.0}) QTest::addRow("d %.2f, e %.0f V", d, e) << d << e;
  }
  void interruptedCurrentIsThatOfTheSwitchedWinding() {
    QFETCH(double, duty);
    QFETCH(double, back);
    constexpr double kBus = 11;
    const Mean mean = followed(duty, kBus, back);
    const double found = interruptedCurrent(diodes(0), duty, back, kBus);
    QVERIFY2(std::abs(found / mean.current - 1) < 1e-3,
             qPrintable(QString("%1, %2").arg(found).arg(mean.current)));
    // A resistance too small to bend the current shows the heat of its ripple.
    constexpr double kSmall = 1e-9;
    const Conversion<double> c = conversion(diodes(kSmall), duty, found, back, kBus);
    QVERIFY(std::abs(c.duty * kBus / back - 1) < 1e-6);
    const double variance = mean.square - mean.current * mean.current;
    QVERIFY2(std::abs(c.perVoltage * kBus * kBus / kSmall / variance - 1) < 2e-3,
             qPrintable(QString("%1, %2").arg(c.perVoltage * kBus * kBus / kSmall).arg(variance)));
  }

  /// A current that never stops: the duty stays, and the ripple D = V d (1 - d)/(L f) adds D^2/12.
  void continuousCurrentKeepsItsDuty() {
    const EscConstants esc = diodes(0.1);
    constexpr double kDuty = 0.6, kBus = 11;
    const Conversion<double> c = conversion(esc, kDuty, 20.0, 4.0, kBus);
    QCOMPARE(c.duty, kDuty);
    const double swing = kBus * kDuty * (1 - kDuty) * esc.ripple;
    QVERIFY(std::abs(c.perVoltage * kBus / (0.1 * swing * swing / 12 / kBus) - 1) < 1e-12);
  }

  void dutyIsFoundBackFromItsShare() {
    const EscConstants esc = diodes(0.1);
    for (const double duty : {0.1, 0.2, 0.3, 0.6, 0.95}) {
      constexpr double kBus = 11;
      const double back = 0.9 * kBus * std::max(duty, 0.3);
      const double held = interruptedCurrent(esc, duty, back, kBus);
      const Conversion<double> c = conversion(esc, duty, held, back, kBus);
      if (!(c.duty > duty)) continue;
      QVERIFY(std::abs(dutyForShare(esc, c.duty, held, kBus) / duty - 1) < 1e-9);
    }
  }

  void throttleHasTwoEnds() {
    EscConstants esc;
    esc.throttleStart = 0.16, esc.throttleFull = 0.72;
    QCOMPARE(esc.dutyOf(0.1), 0.0);
    QCOMPARE(esc.dutyOf(0.8), 1.0);
    QVERIFY(std::abs(esc.dutyOf(0.44) - 0.5) < 1e-12);
    QVERIFY(std::abs(esc.dutyOf(-0.44) + 0.5) < 1e-12);
    for (const double d : {-0.7, 0.0, 0.3, 1.0})
      QVERIFY(std::abs(esc.dutyOf(esc.throttleOf(d)) - d) < 1e-12);
  }

  /// Chopping costs power at part throttle and none at full duty, where only the leads remain.
  void losesAtPartThrottle() {
    DriveTrainSetup setup = lossy();
    const auto escLoss = [&](double throttle, bool chopping) {
      DriveTrainSetup s = setup;
      if (!chopping) s.esc.pwmFrequency = s.esc.switchingLoss = s.esc.leadResistance = 0;
      const DriveTrain train(s);
      const auto y = train.steadyState(throttle, 1, 0);
      const auto at = train.instant(y);
      const double plain = setup.esc.resistance * at.current * at.current;
      return std::pair{train.powers(y).escLoss - plain, at.busCurrent * at.busCurrent};
    };
    QVERIFY(std::abs(escLoss(0.5, false).first) < 1e-9);
    QVERIFY(escLoss(0.5, true).first > 5);
    const auto [full, square] = escLoss(0.75, true);
    QVERIFY2(std::abs(full - setup.esc.leadResistance * square) < 1e-6,
             qPrintable(QString::number(full)));
  }

  /// At any state, and not only on solutions.
  void energyLedgerCloses() {
    for (const bool braking : {false, true}) {
      DriveTrainSetup setup = lossy();
      setup.esc.activeBraking = braking;
      setup.esc.reverse = true;
      DriveTrain train(setup);
      std::mt19937 random(7);
      std::uniform_real_distribution<double> any(-1, 1);
      for (int k = 0; k < 2000; ++k) {
        DriveTrain::State y;
        y << 25 * any(random), 900 * any(random), any(random), 1, 0;
        train.setThrottle(any(random), y);
        const DrivePowers p = train.powers(y);
        const double size = std::abs(p.source) + std::abs(p.load) + std::abs(p.magnetic) +
                            std::abs(p.kinetic) + p.copperLoss;
        QVERIFY(std::abs(p.residual()) <= 1e-9 * size);
      }
    }
  }

  void steadyStateIsReached_data() {
    QTest::addColumn<double>("throttle");
    for (const double u : {0.2, 0.25, 0.4, 0.6, 1.0}) QTest::addRow("throttle %.2f", u) << u;
  }
  void steadyStateIsReached() {
    QFETCH(double, throttle);
    DriveTrain train(lossy());
    ode::Solver<DriveTrain> solver({.method = ode::Method::Rk4, .step = 2e-5}, train);
    DriveTrain::State y = train.initialState();
    train.setThrottle(throttle, y);
    QVERIFY(solver.advanceTo(4, y) == ode::Status::Done);
    const DriveTrain::State solved = train.steadyState(throttle, 1, 0);
    const double apart = y[DriveTrain::kSpeed] / solved[DriveTrain::kSpeed] - 1;
    QVERIFY2(std::abs(apart) < 1e-6, qPrintable(QString::number(apart)));
    const double current = train.instant(y).busCurrent - train.instant(solved).busCurrent;
    QVERIFY2(std::abs(current) < 1e-4, qPrintable(QString::number(current)));
  }
};

QTEST_APPLESS_MAIN(TestConversion)
#include "test_conversion.moc"
