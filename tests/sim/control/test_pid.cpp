#include <QtTest>
#include <cmath>

#include "sim/control/motor_speed.h"
#include "sim/control/pid.h"

using namespace rotorbench;

namespace {

using Parameters = PidParameters<PidUse::Angle>;

}  // namespace

class TestPid : public QObject {
  Q_OBJECT
 private slots:
  void stepOnFirstOrderPlantIsExponential();
  void derivativeOfARampSettlesThroughTheFilter();
  void derivativeIgnoresTheSetPoint();
  void startsWithoutABump();
  void outputStaysWithinTheLimit();
  void backCalculationPreventsWindUp();
  void withoutIntegralGainNothingIntegrates();
  void rateMustDivideTheTick_data();
  void rateMustDivideTheTick();
  void motorReachesItsSpeedWithinTheCurrentLimit_data();
  void motorReachesItsSpeedWithinTheCurrentLimit();
  void slowingIsAsTheSpeedControllerCan_data();
  void slowingIsAsTheSpeedControllerCan();
};

/// Plant T y' = u - y, gains kp/ki = T: the zero cancels the pole, and y = 1 - exp(-kp t/T).
void TestPid::stepOnFirstOrderPlantIsExponential() {
  const double t1 = 0.5, kp = 2, h = 1e-4;
  Pid pid(Parameters{.kp = kp, .ki = kp / t1, .kd = 0, .limit = 100}, h);
  double y = 0;
  for (int k = 0; k < 5000; ++k) {
    const double u = pid.propose(1, y);
    pid.accept(u);
    y = u + (y - u) * std::exp(-h / t1);
    const double expected = 1 - std::exp(-kp * (k + 1) * h / t1);
    QVERIFY(std::abs(y - expected) < 1e-3);
  }
}

/// Measurement s t: the derivative part goes to -kd s with the time constant of the filter.
void TestPid::derivativeOfARampSettlesThroughTheFilter() {
  const double h = 1e-4, filter = 0.05;
  Pid pid(Parameters{.kp = 0, .ki = 0, .kd = 3, .filterTime = filter, .limit = 100}, h);
  for (int k = 0; k < 4000; ++k) {
    const double u = pid.propose(0, 2 * k * h);
    pid.accept(u);
    QVERIFY(std::abs(u + 6 * (1 - std::exp(-k * h / filter))) < 6e-3);
  }
}

void TestPid::derivativeIgnoresTheSetPoint() {
  Pid pid(Parameters{.kp = 0, .ki = 0, .kd = 3, .limit = 100}, 1e-3);
  QCOMPARE(pid.propose(0, 1), 0.0);
  pid.accept(0);
  QCOMPARE(pid.propose(50, 1), 0.0);
}

void TestPid::startsWithoutABump() {
  Pid pid(Parameters{.kp = 5, .ki = 2, .kd = 1, .setPointWeight = 0.3, .limit = 100}, 1e-3);
  QCOMPARE(pid.propose(10, 10), 0.0);
  pid.accept(0);
  QCOMPARE(pid.propose(10, 10), 0.0);
}

void TestPid::outputStaysWithinTheLimit() {
  Pid pid(Parameters{.kp = 5, .ki = 2, .kd = 0, .limit = 3}, 1e-3);
  pid.propose(0, 0);
  pid.accept(0);
  QCOMPARE(pid.propose(100, 0), 3.0);
  QCOMPARE(pid.propose(-100, 0), -3.0);
}

/// Double integrator with little authority and a large step: without back-calculation the overshoot
/// is far larger.
void TestPid::backCalculationPreventsWindUp() {
  const auto overshoot = [](double trackingTime) {
    const double h = 1e-3;
    Pid pid(Parameters{.kp = 12, .ki = 8, .kd = 6, .trackingTime = trackingTime, .limit = 2}, h);
    double y = 0, v = 0, most = 0;
    for (int k = 0; k < 30000; ++k) {
      const double u = pid.propose(10, y);
      pid.accept(u);
      y += h * v + h * h / 2 * u;
      v += h * u;
      most = std::max(most, y - 10);
    }
    return std::pair(most, std::abs(y - 10));
  };
  const auto [with, rest] = overshoot(0.2);
  const auto [without, ignored] = overshoot(1e9);
  QVERIFY2(with < 0.3 * without, qPrintable(QString("%1 %2").arg(with).arg(without)));
  QVERIFY(rest < 1e-6);
}

void TestPid::withoutIntegralGainNothingIntegrates() {
  Pid pid(Parameters{.kp = 5, .ki = 0, .kd = 0, .limit = 1}, 1e-3);
  for (int k = 0; k < 100; ++k) pid.accept(pid.propose(10, k == 0 ? 0 : 1));
  QCOMPARE(pid.integral(), 0.0);
}

void TestPid::rateMustDivideTheTick_data() {
  QTest::addColumn<double>("rate");
  QTest::addColumn<int>("ticks");  // 0: refused
  QTest::addRow("every tick") << 1000.0 << 1;
  QTest::addRow("every second") << 500.0 << 2;
  QTest::addRow("every fourth") << 250.0 << 4;
  QTest::addRow("faster than the tick") << 2000.0 << 0;
  QTest::addRow("between ticks") << 300.0 << 0;
}

void TestPid::rateMustDivideTheTick() {
  QFETCH(double, rate);
  QFETCH(int, ticks);
  int got = 0;
  try {
    got = ticksBetween(rate, 1e-3, Place("controller") / "rate");
  } catch (const InputError& e) {
    QCOMPARE(e.problems().at(0).path, std::string("controller.rate"));
  }
  QCOMPARE(got, ticks);
}

void TestPid::motorReachesItsSpeedWithinTheCurrentLimit_data() {
  QTest::addColumn<bool>("feedForward");
  QTest::addColumn<double>("from");
  QTest::addColumn<double>("to");
  QTest::addRow("spin up") << true << 0.0 << 509.0;
  QTest::addRow("spin up without feed-forward") << false << 0.0 << 509.0;
  QTest::addRow("small step") << true << 500.0 << 520.0;
  QTest::addRow("slow down") << true << 700.0 << 300.0;
}

void TestPid::motorReachesItsSpeedWithinTheCurrentLimit() {
  QFETCH(bool, feedForward);
  QFETCH(double, from);
  QFETCH(double, to);
  MotorParameters p;
  p.maxCurrent = 15;
  const MotorConstants m = buildMotor(p);
  MotorSpeedParameters settings;
  settings.feedForward = feedForward;
  const double inertia = 6.05e-5, drag = 2.621e-7, h = 1e-5;
  MotorSpeedController controller(settings, m, buildEsc({}, m), inertia, drag);
  double w = from, i = m.steadyCurrent(from, drag * from * from), v = 0, most = 0, least = 100;
  for (int k = 0; k < 500000; ++k) {
    if (k % 100 == 0) v = controller.update(to, w, 11.1);
    QVERIFY(v >= 0 && v <= 11.1);
    // Semi-implicit in the current, whose pole is fast.
    i = (i + h / m.inductance * (v - m.torqueConstant * w)) / (1 + h * m.resistance / m.inductance);
    w += h / inertia * (m.torqueConstant * i - m.friction(w) - drag * w * w);
    most = std::max(most, i);
    least = std::min(least, i);
  }
  QVERIFY2(std::abs(w - to) < 1e-6 * to, qPrintable(QString::number(w)));
  // Between two updates the back-EMF moves on a little.
  QVERIFY2(most < 15.5 && least > -15.5, qPrintable(QString("%1 %2").arg(most).arg(least)));
}

/// A rotor far too fast: full braking within the current's band, by reversing where the speed
/// controller can, and nothing below the back-EMF where it does not brake.
void TestPid::slowingIsAsTheSpeedControllerCan_data() {
  QTest::addColumn<bool>("braking");
  QTest::addColumn<bool>("reverse");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("voltage");
  const MotorConstants m = buildMotor({});
  const double back = 300 * m.torqueConstant, band = m.resistance * m.maxCurrent;
  QTest::addRow("braking") << true << false << 300.0 << back - band;
  QTest::addRow("braking at low speed") << true << false << 100.0 << 0.0;
  QTest::addRow("reversing") << true << true << 100.0 << 100 * m.torqueConstant - band;
  QTest::addRow("passive") << false << false << 300.0 << back;
  QTest::addRow("passive, turning backwards") << false << false << -100.0 << 0.0;
}

void TestPid::slowingIsAsTheSpeedControllerCan() {
  QFETCH(bool, braking);
  QFETCH(bool, reverse);
  QFETCH(double, speed);
  QFETCH(double, voltage);
  const MotorConstants m = buildMotor({});
  const EscConstants esc = buildEsc({.reverse = reverse, .activeBraking = braking}, m);
  MotorSpeedParameters settings;
  settings.feedForward = false;
  MotorSpeedController controller(settings, m, esc, 6.05e-5, 2.6e-7);
  QVERIFY(std::abs(controller.update(-3000, speed, 11.1) - voltage) < 1e-12);
}

QTEST_APPLESS_MAIN(TestPid)
#include "test_pid.moc"
