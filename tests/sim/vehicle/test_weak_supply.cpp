// A supply too weak for its converters, on a stand and in a vehicle: whatever the state, the bus is
// not below 0, its current is what the resistance lets through, and the energy ledger closes.
#include <QTest>
#include <cmath>

#include "sim/core/random.h"
#include "sim/propulsion/drive/drive_train.h"
#include "sim/vehicle/multirotor.h"

using namespace rotorbench;

namespace {

using Plant = Multirotor<4>;
using L = Plant::Layout;

/// -1..1, mostly with some of every decade down to 1e-3.
double signedDecades(RandomStream& random) {
  const double size = std::pow(10.0, -3 * random.uniform());
  return random.uniform() < 0.2 ? -size : size;
}

EscParameters escWith(int kind) {
  return {.resistance = 0.01,
          .responseTime = 0,
          .maxCurrent = 15,
          .reverse = kind == 2,
          .activeBraking = kind != 1};
}

void addKinds() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<double>("resistance");
  for (const double r : {0.05, 0.5, 5.0, 50.0}) {
    QTest::addRow("braking, %g Ohm", r) << 0 << r;
    QTest::addRow("passive, %g Ohm", r) << 1 << r;
    QTest::addRow("reversible, %g Ohm", r) << 2 << r;
  }
}

}  // namespace

class TestWeakSupply : public QObject {
  Q_OBJECT
 private slots:
  void onAStand_data() { addKinds(); }
  void onAStand() {
    QFETCH(int, kind);
    QFETCH(double, resistance);
    RandomStream random(7, "stand");
    int weak = 0;
    for (const bool quasiStatic : {false, true}) {
      DriveTrain train({.supply = SupplyParameters{11.1, resistance},
                        .esc = escWith(kind),
                        .motor = {},
                        .load = {},
                        .quasiStaticCurrent = quasiStatic});
      for (int k = 0; k < 2000; ++k) {
        DriveTrain::State y = train.initialState();
        y[DriveTrain::kSpeed] = 1200 * signedDecades(random);
        y[DriveTrain::kCurrent] = 40 * signedDecades(random);
        train.setThrottle(signedDecades(random), y);
        const auto at = train.instant(y);
        QVERIFY(at.busVoltage >= 0);
        if (at.busVoltage < 11.1 / 2) ++weak;
        // The ledger's parts add up, beside the largest of them.
        const DrivePowers p = train.powers(y);
        const double size = std::abs(p.source) + std::abs(p.supplyLoss) + std::abs(p.magnetic) +
                            std::abs(p.kinetic) + std::abs(p.copperLoss);
        QVERIFY2(std::abs(p.residual()) <= 1e-9 * size + 1e-12,
                 qPrintable(QString("%1 W of %2 W").arg(p.residual()).arg(size)));
        if (at.busCurrent >= 0)
          QVERIFY(std::abs(at.busVoltage + resistance * at.busCurrent - 11.1) < 1e-8 * 11.1);
      }
    }
    // Else nothing of it was weak.
    QVERIFY(weak > 0 || resistance < 1);
  }

  void inAVehicle_data() { addKinds(); }
  void inAVehicle() {
    QFETCH(int, kind);
    QFETCH(double, resistance);
    VehicleParameters vehicle;
    vehicle.supply = SupplyParameters{11.1, resistance};
    std::get<EqualRotors>(vehicle.rotors).rotor.esc = escWith(kind);
    Plant plant(buildMultirotor<4>(vehicle, {}));
    RandomStream random(8, "vehicle");
    int empty = 0;
    for (int k = 0; k < 4000; ++k) {
      Plant::State y = Plant::State::Zero();
      y[L::kAttitude] = 1;
      Plant::Command command;
      for (int i = 0; i < 4; ++i) {
        y[L::kSpeed + i] = 1200 * signedDecades(random);
        y[L::kCurrent + i] = 40 * signedDecades(random);
        command[i] = signedDecades(random);
      }
      plant.setCommand(command, y);
      Plant::State rate;
      MultirotorForces<4> forces{};
      plant.derivativeAndForces(0, y, rate, forces);
      QVERIFY(rate.allFinite());
      QVERIFY(forces.busVoltage >= 0);
      if (forces.busVoltage == 0) ++empty;
      QVERIFY(std::abs(forces.busVoltage + resistance * forces.supplyCurrent - 11.1) < 1e-8 * 11.1);
      const FlightPowers p = plant.powers(0, y);
      const double left = p.residual();
      const double size = std::abs(p.source) + std::abs(p.supplyLoss) + std::abs(p.magnetic) +
                          std::abs(p.kinetic) + p.copperLoss + std::abs(p.shaft);
      QVERIFY2(std::abs(left) <= 1e-9 * size + 1e-12,
               qPrintable(QString("%1 W of %2 W").arg(left).arg(size)));
    }
    QVERIFY(empty > 0 || resistance < 1);
  }
};

QTEST_GUILESS_MAIN(TestWeakSupply)
#include "test_weak_supply.moc"
