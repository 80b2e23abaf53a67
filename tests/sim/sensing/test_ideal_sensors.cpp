#include <QtTest>
#include <cmath>

#include "sim/document/flight.h"
#include "sim/run/plant_handle.h"
#include "sim/sensing/sensor_tasks.h"
#include "sim/sensing/true_state.h"
#include "sim/vehicle/multirotor.h"

using namespace rotorbench;
using Eigen::Vector3d;

class TestIdealSensors : public QObject {
  Q_OBJECT
 private slots:
  void readTheTrueState();
  void accelerometerFeelsThrustAndNotGravity();
};

void TestIdealSensors::readTheTrueState() {
  Flight flight;
  flight.start.position = {1, 2, 3};
  flight.start.velocity = {4, 5, 6};
  flight.start.attitude = {0.1, -0.2, 3};
  flight.start.rates = {0.7, 0.8, 0.9};
  const auto plant = makePlant(flight, RotorDrive::Motors, {});
  Board board;
  plant->observe(board.truth);
  makeSensors(flight.sensors, 1)->act({}, board, nullptr);
  TrueState().act({}, board, nullptr);
  for (const BodyMotion& m : {board.truth.body, board.measurement.body, board.estimate.body}) {
    QVERIFY((m.position - flight.start.position).norm() < 1e-14);
    QVERIFY((m.velocity - flight.start.velocity).norm() < 1e-14);
    QVERIFY((m.attitude - flight.start.attitude).norm() < 1e-14);
    QVERIFY((m.rates - flight.start.rates).norm() < 1e-12);
  }
  const Multirotor<4> same(buildMultirotor<4>(flight.vehicle, {}));
  const auto y = same.initialState(flight.start);
  QVERIFY(board.measurement.drives.speed[3] == y[3] && board.measurement.drives.current[3] == y[7]);
  QCOMPARE(board.measurement.drives.busVoltage, 11.1);
  // Lanes of rotors that are not there stay as they were.
  QVERIFY(board.measurement.drives.speed.tail<4>().isZero(0));
  QVERIFY(std::abs(board.truth.tiltCosine - std::cos(0.1) * std::cos(0.2)) < 1e-14);
}

void TestIdealSensors::accelerometerFeelsThrustAndNotGravity() {
  Multirotor<4> plant(buildMultirotor<4>({}, {}));
  FlightStart start;
  start.attitude = {0.4, 0.3, -1};
  Multirotor<4>::State d;
  MultirotorForces<4> forces;
  plant.derivativeAndForces(0, plant.initialState(start), d, forces);
  // Rotors at hover speed, vehicle at rest: the whole thrust, along body z.
  QVERIFY((forces.specificForce - Vector3d(0, 0, 9.80665)).norm() < 1e-10);
  start.rotors = RotorStart::Stopped;
  plant.derivativeAndForces(0, plant.initialState(start), d, forces);
  QVERIFY(forces.specificForce.norm() < 1e-10);
}

QTEST_APPLESS_MAIN(TestIdealSensors)
#include "test_ideal_sensors.moc"
