#include <QtTest>

#include "sim/control/allocation.h"
#include "sim/run/plant_handle.h"

using namespace rotorbench;

class TestAllocation : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip_data();
  void roundTrip();
  void plusLayoutUsesThePublishedSigns();
  void limitsKeepRollAndPitchFirst_data();
  void limitsKeepRollAndPitchFirst();
  void topSpeedIsLimitedByCurrentOrVoltage();
  void uncontrollableLayoutIsRefused();

 private:
  static ControlModel model(int layout) {
    VehicleParameters v;
    if (layout == 1) v.layout = PlusLayout{};
    if (layout == 2) {
      FreeLayout free;
      free.rotors[0].axis = {0.1, 0.05, 1};
      free.rotors[1].position = {0.02, 0.25, 0.03};
      v.layout = free;
    }
    return controlModel(v, {}, {});
  }
};

void TestAllocation::roundTrip_data() {
  QTest::addColumn<int>("layout");
  QTest::addRow("cross") << 0;
  QTest::addRow("plus") << 1;
  QTest::addRow("free, one rotor tilted") << 2;
}

void TestAllocation::roundTrip() {
  QFETCH(int, layout);
  const auto m = model(layout);
  const Allocation allocation(m);
  for (const Wrench& demand : {Wrench(13.7, 0, 0, 0), Wrench(16, 0.3, -0.2, 0.05)}) {
    const auto r = allocation.allocate(demand);
    QVERIFY(!r.limited);
    QVERIFY((m.effect * r.thrust - demand).norm() < 1e-12);
  }
}

/// Physics section 0: roll r (T2 - T4), pitch r (T3 - T1), yaw k (T2 + T4 - T1 - T3).
void TestAllocation::plusLayoutUsesThePublishedSigns() {
  const auto m = model(1);
  const double r = 0.225, k = m.torqueFactor[0] / m.thrustFactor[0];
  Eigen::Matrix4d expected;
  expected << 1, 1, 1, 1, 0, r, 0, -r, -r, 0, r, 0, -k, k, -k, k;
  QCOMPARE(m.rotors, 4);
  QVERIFY((m.effect.leftCols<4>() - expected).norm() < 1e-12);
  QVERIFY(m.effect.rightCols<4>().isZero(0));
}

void TestAllocation::limitsKeepRollAndPitchFirst_data() {
  QTest::addColumn<Eigen::Vector4d>("demand");
  QTest::addColumn<bool>("thrustKept");
  QTest::addRow("yaw gives way") << Eigen::Vector4d(14, 0.5, -0.4, 3) << true;
  QTest::addRow("yaw the other way") << Eigen::Vector4d(14, 0.5, -0.4, -3) << true;
  QTest::addRow("no thrust wanted") << Eigen::Vector4d(0, 0.5, 0.4, 0) << false;
  QTest::addRow("too much thrust wanted") << Eigen::Vector4d(60, 0.5, 0.4, 0.1) << false;
  QTest::addRow("negative thrust wanted") << Eigen::Vector4d(-20, -0.5, 0.4, 0.1) << false;
}

void TestAllocation::limitsKeepRollAndPitchFirst() {
  QFETCH(Eigen::Vector4d, demand);
  QFETCH(bool, thrustKept);
  const auto m = model(0);
  const auto r = Allocation(m).allocate(demand);
  QVERIFY(r.limited);
  QVERIFY(r.thrust.minCoeff() >= 0 && r.thrust.maxCoeff() <= m.maxThrust[0] + 1e-12);
  QVERIFY((r.achieved - m.effect * r.thrust).norm() < 1e-12);
  QVERIFY((r.achieved.segment<2>(1) - demand.segment<2>(1)).norm() < 1e-12);
  QCOMPARE(std::abs(r.achieved[0] - demand[0]) < 1e-12, thrustKept);
  // Never more yaw than asked for and never the wrong way.
  QVERIFY(r.achieved[3] * demand[3] >= -1e-12);
  QVERIFY(std::abs(r.achieved[3]) <= std::abs(demand[3]) + 1e-12);
  // What is kept back is kept back by a rotor at its limit.
  const bool atLimit = r.thrust.minCoeff() < 1e-9 || r.thrust.maxCoeff() > m.maxThrust[0] - 1e-9;
  QVERIFY(atLimit);

  // Beyond reach even alone, roll and pitch shrink together and keep their direction.
  const auto wild = Allocation(m).allocate(Wrench(14, 60, -30, 1));
  QVERIFY(wild.achieved[1] > 1 && std::abs(wild.achieved[2] / wild.achieved[1] + 0.5) < 1e-9);
}

void TestAllocation::topSpeedIsLimitedByCurrentOrVoltage() {
  MotorParameters p = djiE305();
  const double drag = 2.621e-7;
  const MotorConstants m = buildMotor(p);
  const double byCurrent = topSpeed(m, drag, 20);
  QVERIFY(std::abs(m.steadyCurrent(byCurrent, drag * byCurrent * byCurrent) - 20) < 1e-9);
  const double byVoltage = topSpeed(m, drag, 6);
  const double current = m.steadyCurrent(byVoltage, drag * byVoltage * byVoltage);
  QVERIFY(current < 20);
  QVERIFY(std::abs(m.steadyVoltage(byVoltage, current) - 6) < 1e-9);
}

void TestAllocation::uncontrollableLayoutIsRefused() {
  VehicleParameters v;
  FreeLayout line;
  for (int i = 0; i < 4; ++i) {
    line.rotors[static_cast<std::size_t>(i)].position = {0.1 * (i - 1.5), 0, 0};
  }
  v.layout = line;
  bool refused = false;
  try {
    const Allocation allocation(controlModel(v, {}, {}), Place("setup.vehicle"));
  } catch (const InputError& error) {
    QCOMPARE(error.problems().front().path, std::string("setup.vehicle.layout"));
    refused = true;
  }
  QVERIFY(refused);
}

QTEST_APPLESS_MAIN(TestAllocation)
#include "test_allocation.moc"
