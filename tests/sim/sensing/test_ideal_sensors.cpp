#include <QtTest>

#include "sim/sensing/measurement.h"

using namespace rotorbench;
using Eigen::Vector3d;

class TestIdealSensors : public QObject {
  Q_OBJECT
 private slots:
  void readTheTrueState();
  void accelerometerFeelsThrustAndNotGravity();
};

void TestIdealSensors::readTheTrueState() {
  Multirotor<4> plant(buildMultirotor<4>({}, {}));
  FlightStart start;
  start.position = {1, 2, 3};
  start.velocity = {4, 5, 6};
  start.attitude = {0.1, -0.2, 3};
  start.rates = {0.7, 0.8, 0.9};
  const auto y = plant.initialState(start);
  Multirotor<4>::State d;
  MultirotorForces<4> forces;
  plant.derivativeAndForces(y, d, forces);
  const auto m = IdealSensors{}.measure<4>(y, forces);
  QVERIFY((m.position - start.position).norm() < 1e-14);
  QVERIFY((m.velocity - start.velocity).norm() < 1e-14);
  QVERIFY((m.attitude - start.attitude).norm() < 1e-14);
  QVERIFY((m.rates - start.rates).norm() < 1e-12);
  QVERIFY(m.rotorSpeed[3] == y[3] && m.motorCurrent[3] == y[7]);
  QCOMPARE(m.busVoltage, 11.1);
}

void TestIdealSensors::accelerometerFeelsThrustAndNotGravity() {
  Multirotor<4> plant(buildMultirotor<4>({}, {}));
  FlightStart start;
  start.attitude = {0.4, 0.3, -1};
  Multirotor<4>::State d;
  MultirotorForces<4> forces;
  plant.derivativeAndForces(plant.initialState(start), d, forces);
  // Rotors at hover speed, vehicle at rest: the whole thrust, along body z.
  QVERIFY((forces.specificForce - Vector3d(0, 0, 9.80665)).norm() < 1e-10);
  start.rotors = RotorStart::Stopped;
  plant.derivativeAndForces(plant.initialState(start), d, forces);
  QVERIFY(forces.specificForce.norm() < 1e-10);
}

QTEST_APPLESS_MAIN(TestIdealSensors)
#include "test_ideal_sensors.moc"
