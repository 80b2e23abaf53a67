#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/vehicle/birotor.h"
#include "tests/sim/vehicle/plain_rk4.h"

using namespace rotorbench;

class TestBirotor : public QObject {
  Q_OBJECT
 private slots:
  void springBarStretchesAsInTable21();
  void springBarKeepsEnergy();
  void springBarStartsAtRestLength();
  void rigidBarFollowsClosedForm_data();
  void rigidBarFollowsClosedForm();
  void closedFormWithoutFriction();
  void rigidBarMovesSquareToTheBar();
  void bothModelsAgreeForAStiffBar();
  void defaultsAreValid();
  void unequalMassesAreRefused();
};

/// Physics reference: with table 2.1 and RK4 at 0.05 s the bar passes 0.6 m near 23.5 s, at -18
/// rad/s and -109 N.
void TestBirotor::springBarStretchesAsInTable21() {
  const SpringBarBirotor plant{SpringBarParameters{}};
  auto y = plant.initialState();
  double t = 0;
  while (plant.bar(y).length < 0.6 && t < 60) {
    plainRk4(plant, 0.05, y);
    t += 0.05;
  }
  QVERIFY2(std::abs(t - 23.5) < 0.5, qPrintable(QString::number(t)));
  QVERIFY(std::abs(SpringBarBirotor::angularVelocity(y) + 18) < 0.5);
  QVERIFY(std::abs(plant.bar(y).force + 109) < 10);
}

void TestBirotor::springBarKeepsEnergy() {
  SpringBarParameters p;
  p.force1 = p.force2 = p.friction = p.damping = 0;
  p.gravity = 9.81;
  p.mass2 = 1.7;
  p.angularVelocity = 3;
  p.velocity = {1, 2};
  const SpringBarBirotor plant(p);
  auto y = plant.initialState();
  const double before = plant.energy(y);
  for (int k = 0; k < 20000; ++k) plainRk4(plant, 1e-4, y);
  QVERIFY(std::abs(plant.energy(y) - before) < 1e-8 * std::abs(before));
}

void TestBirotor::springBarStartsAtRestLength() {
  SpringBarParameters p;
  p.angle = 2.5;  // second quadrant: an arctangent of the ratio would lose it
  p.angularVelocity = -1.5;
  p.centre = {3, 2};
  const SpringBarBirotor plant(p);
  const auto y = plant.initialState();
  QVERIFY(std::abs(plant.bar(y).length - 0.5) < 1e-15);
  QVERIFY(std::abs(plant.bar(y).force) < 1e-12);
  QVERIFY(std::abs(SpringBarBirotor::angle(y) - 2.5) < 1e-15);
  QVERIFY(std::abs(SpringBarBirotor::angularVelocity(y) + 1.5) < 1e-14);
}

void TestBirotor::rigidBarFollowsClosedForm_data() {
  QTest::addColumn<bool>("thesis");
  QTest::addColumn<double>("terminal");  // rad/s: (F2 - F1)/(2 D r) or (F2 - F1)/(2 D r^2)
  QTest::addRow("physical damping") << false << 1 / (2 * 0.05 * 0.25);
  QTest::addRow("damping of the thesis") << true << 1 / (2 * 0.05 * 0.25 * 0.25);
}

void TestBirotor::rigidBarFollowsClosedForm() {
  QFETCH(bool, thesis);
  QFETCH(double, terminal);
  RigidBarParameters p;  // table 2.2
  p.angularDamping = thesis ? BirotorDamping::Thesis2014 : BirotorDamping::Physical;
  const RigidBarBirotor plant(p);
  auto y = plant.initialState();
  for (int k = 0; k < 6000; ++k) plainRk4(plant, 0.01, y);
  // alpha'' = (F2 - F1)/(r M) - alpha'/tau with tau = terminal r M/(F2 - F1).
  const double tau = terminal * 0.25 * 2 / 1.0;
  const double rate = terminal + (2 - terminal) * std::exp(-60 / tau);
  const double angle = 5 + terminal * 60 + (2 - terminal) * tau * (1 - std::exp(-60 / tau));
  QVERIFY(std::abs(y[5] - rate) < 1e-9);
  QVERIFY(std::abs(y[4] - angle) < 1e-7);
  QVERIFY(std::abs(plant.angularVelocityAt(60, p.angularDamping) - rate) < 1e-12);
}

void TestBirotor::closedFormWithoutFriction() {
  RigidBarParameters p;
  p.friction = 0;
  const RigidBarBirotor plant(p);
  QCOMPARE(plant.angularVelocityAt(3, BirotorDamping::Physical), 2 + 3 * 1.0 / (0.25 * 2));
  p.friction = 1e-12;  // the limit is reached smoothly
  QVERIFY(std::abs(RigidBarBirotor(p).angularVelocityAt(3, BirotorDamping::Physical) - 8) < 1e-10);
}

/// Equal forces, no rotation: constant thrust against linear drag, v = (2F/D)(1 - exp(-D t/M))
/// along the normal.
void TestBirotor::rigidBarMovesSquareToTheBar() {
  RigidBarParameters p;
  p.force1 = p.force2 = 3;
  p.angle = 0.7;
  p.angularVelocity = 0;
  p.velocity = {0, 0};
  const RigidBarBirotor plant(p);
  auto y = plant.initialState();
  for (int k = 0; k < 1000; ++k) plainRk4(plant, 0.01, y);
  const double speed = 6 / 0.05 * (1 - std::exp(-0.05 * 10 / 2));
  QVERIFY(std::abs(y[1] + speed * std::sin(0.7)) < 1e-9);
  QVERIFY(std::abs(y[3] - speed * std::cos(0.7)) < 1e-9);
}

/// A very stiff bar moves like the rigid one. Without friction, which the two models do not share
/// alike.
void TestBirotor::bothModelsAgreeForAStiffBar() {
  RigidBarParameters rigid;
  rigid.friction = 0;
  rigid.gravity = 9.81;
  SpringBarParameters spring;
  static_cast<BirotorParameters&>(spring) = rigid;
  spring.stiffness = 1e6;
  spring.damping = 500;
  const RigidBarBirotor a(rigid);
  const SpringBarBirotor b(spring);
  auto ya = a.initialState();
  auto yb = b.initialState();
  for (int k = 0; k < 20000; ++k) {
    plainRk4(a, 1e-4, ya);
    plainRk4(b, 1e-4, yb);
  }
  QVERIFY(std::abs(ya[0] - (yb[0] + yb[4]) / 2) < 1e-4);
  QVERIFY(std::abs(ya[2] - (yb[2] + yb[6]) / 2) < 1e-4);
  QVERIFY(std::abs(ya[5] - SpringBarBirotor::angularVelocity(yb)) < 1e-3);
}

void TestBirotor::defaultsAreValid() {
  SpringBarParameters spring;
  RigidBarParameters rigid;
  QVERIFY(schema::validate(schema::ref(std::as_const(spring))).empty());
  QVERIFY(schema::validate(schema::ref(std::as_const(rigid))).empty());
}

void TestBirotor::unequalMassesAreRefused() {
  RigidBarParameters rigid;
  rigid.mass2 = 2;
  QCOMPARE(schema::validate(schema::ref(std::as_const(rigid))).size(), std::size_t{1});
}

QTEST_APPLESS_MAIN(TestBirotor)
#include "test_birotor.moc"
