#include <QtTest>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

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
  void otherGainsComeWithoutABump();
  void withoutIntegralOtherGainsActAtOnce();
  void gainsGivenAgainChangeNothing();
  void rateMustDivideTheTick_data();
  void rateMustDivideTheTick();
  void motorReachesItsSpeedWithinTheCurrentLimit_data();
  void motorReachesItsSpeedWithinTheCurrentLimit();
  void slowingIsAsTheSpeedControllerCan_data();
  void slowingIsAsTheSpeedControllerCan();
  void lanesGiveTheBitsOfOne();
  void motorsSideBySideGiveTheBitsOfOne();
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

/// Whatever the gains become, the demand for what was just seen stays, and goes over from there:
/// the derivative within its filter time.
void TestPid::otherGainsComeWithoutABump() {
  constexpr double h = 1e-3;
  const Parameters first{.kp = 5, .ki = 2, .kd = 1, .setPointWeight = 0.6, .limit = 100};
  const Parameters others[] = {
      {.kp = 50, .ki = 2, .kd = 1, .setPointWeight = 0.6, .limit = 100},
      {.kp = 0, .ki = 9, .kd = 4, .setPointWeight = 0.1, .limit = 100},
      {.kp = 5, .ki = 2, .kd = 1, .setPointWeight = 1, .filterTime = 0.1, .limit = 100},
  };
  for (const Parameters& other : others) {
    Pid pid(first, h);
    pid.accept(pid.propose(0, 0));
    double before = 0;
    for (int k = 0; k < 1000; ++k) pid.accept(before = pid.propose(2, 1));
    pid.retune(pidGains(other, h));
    // An error of 1 goes on to be integrated; the derivative of what rests is over.
    QVERIFY(std::abs(pid.propose(2, 1) - before - first.ki * h) < 1e-12);
    pid.accept(before = pid.propose(2, 1));
    QVERIFY(std::abs(pid.propose(2, 1) - before - other.ki * h) < 1e-12);
  }
}

/// Nothing can take the difference up where nothing integrates: as the header says.
void TestPid::withoutIntegralOtherGainsActAtOnce() {
  Pid pid(Parameters{.kp = 5, .ki = 0, .kd = 0, .limit = 100}, 1e-3);
  pid.accept(pid.propose(0, 0));
  pid.accept(pid.propose(1, 0));
  pid.retune(pidGains(Parameters{.kp = 8, .ki = 0, .kd = 0, .limit = 100}, 1e-3));
  QCOMPARE(pid.propose(1, 0), 8.0);
  QCOMPARE(pid.integral(), 0.0);
}

void TestPid::gainsGivenAgainChangeNothing() {
  const Parameters p{.kp = 5.1, .ki = 2.3, .kd = 1.7, .setPointWeight = 0.6, .limit = 100};
  Pid once(p, 1e-3), again(p, 1e-3);
  for (int k = 0; k < 100; ++k) {
    const double seen = std::sin(0.1 * k);
    const double demand = once.propose(0.7, seen);
    QCOMPARE(again.propose(0.7, seen), demand);
    once.accept(demand);
    again.accept(demand);
    again.retune(pidGains(p, 1e-3));
    QVERIFY(again.integral() == once.integral());
  }
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
  MotorParameters p = djiE305();
  p.maxCurrent = 15;
  const MotorConstants m = buildMotor(p);
  MotorSpeedParameters settings;
  settings.feedForward = feedForward;
  const double inertia = 6.05e-5, drag = 2.621e-7, h = 1e-5;
  MotorSpeedController controller(settings, {m, buildEsc({}, m), inertia, drag});
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
  const MotorConstants m = buildMotor(djiE305());
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
  const MotorConstants m = buildMotor(djiE305());
  const EscConstants esc = buildEsc({.reverse = reverse, .activeBraking = braking}, m);
  MotorSpeedParameters settings;
  settings.feedForward = false;
  MotorSpeedController controller(settings, {m, esc, 6.05e-5, 2.6e-7});
  QVERIFY(std::abs(controller.update(-3000, speed, 11.1) - voltage) < 1e-12);
}

/// Controllers side by side are the same controllers: bit for bit, limited and not.
void TestPid::lanesGiveTheBitsOfOne() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0, 1), signal(-2, 2);
  std::array<PidGains<double>, 4> gains;
  std::vector<Pid> alone;
  for (auto& g : gains) {
    Parameters p{.kp = 20 * part(random), .ki = 10 * part(random), .kd = 4 * part(random)};
    p.setPointWeight = part(random), p.limit = 5 * part(random);
    if (alone.size() == 2) p.ki = 0;
    g = pidGains(p, 1e-2);
    alone.emplace_back(g);
  }
  BasicPid<Lanes<4>> together(besides<4>(gains));
  for (int k = 0; k < 1000; ++k) {
    Lanes<4> wanted, measured, carried;
    for (int i = 0; i < 4; ++i) {
      wanted[i] = std::floor(signal(random));
      measured[i] = signal(random);
    }
    const Lanes<4> demand = together.propose(wanted, measured);
    for (int i = 0; i < 4; ++i) {
      Pid& one = alone[static_cast<std::size_t>(i)];
      QCOMPARE(std::bit_cast<std::uint64_t>(one.propose(wanted[i], measured[i])),
               std::bit_cast<std::uint64_t>(demand[i]));
      carried[i] = part(random) * demand[i];
      one.accept(carried[i]);
    }
    together.accept(carried);
    for (int i = 0; i < 4; ++i)
      QCOMPARE(alone[static_cast<std::size_t>(i)].integral(), together.integral()[i]);
  }
}

void TestPid::motorsSideBySideGiveTheBitsOfOne() {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  const MotorSpeedParameters settings;
  std::array<ControlledMotor, 6> motors;
  std::vector<MotorSpeedController> alone;
  for (std::size_t i = 0; i < motors.size(); ++i) {
    MotorParameters p = djiE305();
    p.resistance *= 1 + part(random), p.maxCurrent = 10 + 20 * part(random);
    const MotorConstants m = buildMotor(p);
    const EscConstants esc = buildEsc({.reverse = i % 3 == 0, .activeBraking = i % 2 == 0}, m);
    motors[i] = {m, esc, 6e-5 * (1 + part(random)), 2.6e-7};
    alone.emplace_back(settings, motors[i]);
  }
  BasicMotorSpeedController<Lanes<6>> together(settings, motors);
  for (int k = 0; k < 2000; ++k) {
    Lanes<6> wanted, speed;
    for (int i = 0; i < 6; ++i) {
      wanted[i] = 100 * std::floor(10 * part(random));
      speed[i] = 1000 * part(random);
    }
    const double bus = 10 + part(random);
    const Lanes<6> voltage = together.update(wanted, speed, bus);
    for (int i = 0; i < 6; ++i) {
      auto& one = alone[static_cast<std::size_t>(i)];
      QCOMPARE(std::bit_cast<std::uint64_t>(one.update(wanted[i], speed[i], bus)),
               std::bit_cast<std::uint64_t>(voltage[i]));
    }
  }
}

QTEST_APPLESS_MAIN(TestPid)
#include "test_pid.moc"
