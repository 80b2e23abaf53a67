#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>

#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/rotor.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

/// AscTec Hummingbird: RotorPy, vehicles/hummingbird_params.py.
RotorCoefficients hummingbirdRotor() {
  return {.thrust = 5.57e-6,
          .torque = 1.36e-7,
          .inflow = {1.19e-4, 2.32e-4, 3.39e-3, 0},
          .referenceDensity = 1.225,
          .diameter = 0.2032};
}

}  // namespace

class TestMotorRotor : public QObject {
  Q_OBJECT
 private slots:
  void noLoadCurrentIsTheDataSheets_data();
  void noLoadCurrentIsTheDataSheets();
  void stalledMotorDrawsVoltageOverResistance();
  void linearMotorFollowsClosedForm();
  void frictionIsOddAndSmooth();
  void propellerCoefficientsGiveThePublishedFactors();
  void hoverSpeedIsThePublishedOne_data();
  void hoverSpeedIsThePublishedOne();
  void movingAirActsAsPublished();
  void forcesScaleWithDensity();
  void turningBackwardsPullsBackwards();
  void momentAboutTheAxisFollowsTheSpin();
};

void TestMotorRotor::noLoadCurrentIsTheDataSheets_data() {
  QTest::addColumn<double>("viscousShare");
  QTest::addRow("dry") << 0.0;
  QTest::addRow("mixed") << 0.4;
  QTest::addRow("viscous") << 1.0;
}

/// At V0 the motor runs at (V0 - R I0) Kv and draws I0, however the friction is shared.
void TestMotorRotor::noLoadCurrentIsTheDataSheets() {
  QFETCH(double, viscousShare);
  MotorParameters p = djiE305();
  p.viscousShare = viscousShare;
  const MotorConstants m = buildMotor(p);
  const double speed = (10 - 0.117 * 0.45) * 960 * M_PI / 30;
  QVERIFY(std::abs(m.steadyCurrent(speed, 0.0) - 0.45) < 1e-12);
  QVERIFY(std::abs(m.steadyVoltage(speed, 0.45) - 10) < 1e-12);
  QVERIFY(std::abs(m.torqueConstant - 9.947e-3) < 1e-6);  // reference table 6b
}

void TestMotorRotor::stalledMotorDrawsVoltageOverResistance() {
  const MotorConstants m = buildMotor(djiE305());
  QVERIFY(std::abs(m.currentRate(11.1, 11.1 / 0.117, 0.0)) < 1e-8);
  QCOMPARE(m.currentRate(11.1, 0.0, 0.0), 11.1 / 50e-6);
}

/// Viscous friction only, no air: w and i are linear with eigenvalues of [[-f/J, K/J], [-K/L,
/// -R/L]].
void TestMotorRotor::linearMotorFollowsClosedForm() {
  MotorParameters p = djiE305();
  p.viscousShare = 1;
  p.inductance = 1e-3;
  const MotorConstants m = buildMotor(p);
  const double j = 6.05e-5, v = 5, h = 1e-5;
  const double a = -m.viscousFriction / j, b = m.torqueConstant / j, c = -m.torqueConstant / 1e-3,
               d = -0.117 / 1e-3;
  const double root = std::sqrt((a - d) * (a - d) / 4 + b * c);
  const double l1 = (a + d) / 2 + root, l2 = (a + d) / 2 - root;
  // Steady state, then the modes that bring it there from rest.
  const double speed = b * v / 1e-3 / (a * d - b * c), current = -a * speed / b;
  const double x2 = (-b * current - (l1 - a) * -speed) / (l2 - l1), x1 = -speed - x2;

  double w = 0, i = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto rate = [&](double ww, double ii) {
      return std::pair((m.torqueConstant * ii - m.friction(ww)) / j, m.currentRate(v, ii, ww));
    };
    const auto [w1, i1] = rate(w, i);
    const auto [w2, i2] = rate(w + h / 2 * w1, i + h / 2 * i1);
    const auto [w3, i3] = rate(w + h / 2 * w2, i + h / 2 * i2);
    const auto [w4, i4] = rate(w + h * w3, i + h * i3);
    w += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
    i += h / 6 * (i1 + 2 * i2 + 2 * i3 + i4);
  }
  const double t = 20000 * h;
  const double expected = speed + x1 * std::exp(l1 * t) + x2 * std::exp(l2 * t);
  QVERIFY2(std::abs(w - expected) < 1e-7 * speed,
           qPrintable(QString("%1 %2").arg(w).arg(expected)));
}

void TestMotorRotor::frictionIsOddAndSmooth() {
  const MotorConstants m = buildMotor(djiE305());
  QCOMPARE(m.friction(0.0), 0.0);
  QCOMPARE(m.friction(-300.0), -m.friction(300.0));
  QVERIFY(std::abs(m.friction(300.0) - 0.45 * m.torqueConstant) < 1e-5 * m.friction(300.0));
  QVERIFY(std::isfinite(m.friction(1e-300)));
}

/// Reference table 6a, F450 (JSBSim): CT 0.1288 -> 1.327e-5 N s^2, CP 0.0666 -> 2.621e-7 N m s^2 at
/// 1.225 kg/m^3.
void TestMotorRotor::propellerCoefficientsGiveThePublishedFactors() {
  const RotorConstants r = buildRotor({});
  QVERIFY(std::abs(1.225 * r.thrust - 1.327e-5) < 1e-8);
  QVERIFY(std::abs(1.225 * r.torque - 2.621e-7) < 2e-10);
}

void TestMotorRotor::hoverSpeedIsThePublishedOne_data() {
  QTest::addColumn<bool>("hummingbird");
  QTest::addColumn<double>("mass");
  QTest::addColumn<double>("speed");
  QTest::addRow("F450 (JSBSim)") << false << 1.4 << 509.0;
  QTest::addRow("AscTec Hummingbird") << true << 0.5 << 469.0;
}

void TestMotorRotor::hoverSpeedIsThePublishedOne() {
  QFETCH(bool, hummingbird);
  QFETCH(double, mass);
  QFETCH(double, speed);
  RotorParameters p;
  if (hummingbird) p.aerodynamics = hummingbirdRotor();
  const auto load = buildRotor(p).load(speed, Vector3d(0, 0, 0), Vector3d::UnitZ(), 1, 1.225);
  QVERIFY(std::abs(4 * load.thrust / (mass * 9.80665) - 1) < 0.003);
}

/// T = k_eta w^2 + k_h |v_xy|^2 - k_z w v_z; H = -k_d w v_xy; M = -k_flap w (v x axis): RotorPy.
void TestMotorRotor::movingAirActsAsPublished() {
  RotorCoefficients c = hummingbirdRotor();
  c.inflow.flapping = 2e-5;
  RotorParameters p;
  p.aerodynamics = c;
  const double w = 500;
  const Vector3d v(3, -4, 2);
  const auto load = buildRotor(p).load(w, v, Vector3d::UnitZ(), 1, 1.225);
  const double thrust = 5.57e-6 * w * w + 3.39e-3 * 25 - 2.32e-4 * w * 2;
  QVERIFY(std::abs(load.thrust - thrust) < 1e-12);
  QVERIFY((load.force - Vector3d(-1.19e-4 * w * 3, 1.19e-4 * w * 4, thrust)).norm() < 1e-12);
  const Vector3d moment = -2e-5 * w * v.cross(Vector3d::UnitZ()) - Vector3d(0, 0, 1.36e-7 * w * w);
  QVERIFY((load.moment - moment).norm() < 1e-12);
  // The same with everything tilted.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const auto tilted =
      buildRotor(p).load(w, Vector3d(turn * v), Vector3d(turn * Vector3d::UnitZ()), 1, 1.225);
  QVERIFY((tilted.force - turn * load.force).norm() < 1e-12);
  QVERIFY((tilted.moment - turn * load.moment).norm() < 1e-12);
}

void TestMotorRotor::forcesScaleWithDensity() {
  RotorParameters p;
  p.aerodynamics = hummingbirdRotor();
  const RotorConstants r = buildRotor(p);
  const Vector3d v(3, -4, 2);
  const auto thick = r.load(500.0, v, Vector3d::UnitZ(), -1, 1.225);
  const auto thin = r.load(500.0, v, Vector3d::UnitZ(), -1, 0.6125);
  QVERIFY((thick.force - 2 * thin.force).norm() < 1e-12);
  QVERIFY((thick.moment - 2 * thin.moment).norm() < 1e-12);
}

void TestMotorRotor::turningBackwardsPullsBackwards() {
  const RotorConstants r = buildRotor({});
  const auto on = r.load(300.0, Vector3d(0, 0, 0), Vector3d::UnitZ(), 1, 1.225);
  const auto back = r.load(-300.0, Vector3d(0, 0, 0), Vector3d::UnitZ(), 1, 1.225);
  const auto still = r.load(0.0, Vector3d(0, 0, 0), Vector3d::UnitZ(), 1, 1.225);
  QCOMPARE(back.thrust, -on.thrust);
  QCOMPARE(back.torque, -on.torque);
  QVERIFY(still.force.isZero(0) && still.moment.isZero(0));
}

void TestMotorRotor::momentAboutTheAxisFollowsTheSpin() {
  const RotorConstants r = buildRotor({});
  for (const double spin : {1.0, -1.0}) {
    const auto load = r.load(500.0, Vector3d(0, 0, 0), Vector3d::UnitZ(), spin, 1.225);
    QVERIFY(load.torque > 0);
    QCOMPARE(load.moment.z(), -spin * load.torque);
  }
}

QTEST_APPLESS_MAIN(TestMotorRotor)
#include "test_motor_rotor.moc"
