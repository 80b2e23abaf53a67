// A constant power that flight controller, radio and camera draw besides the motors: it is taken
// from the bus at every instant, shortens the flight and counts in what a vehicle can do.
#include <QTest>
#include <cmath>

#include "sim/sizing/performance.h"

using namespace rotorbench;

namespace {

using Plant = Multirotor<4, RotorDrive::Motors>;
constexpr double kPower = 12;  // W

VehicleParameters withAvionics(double power) {
  VehicleParameters vehicle;
  vehicle.supply = BatteryParameters{};
  vehicle.avionicsPower = power;
  return vehicle;
}

MultirotorForces<4> hovering(const VehicleParameters& vehicle) {
  Plant plant(buildMultirotor<4>(vehicle, {}));
  Plant::State y = plant.initialState({}), rate;
  plant.setCommand(plant.steadyDuties(plant.hoverSpeeds()), y);
  MultirotorForces<4> forces{};
  plant.derivativeAndForces(0, y, rate, forces);
  return forces;
}

}  // namespace

class TestAvionics : public QObject {
  Q_OBJECT

 private slots:
  /// Steady duties hold the same motors' voltages at the lower bus; what the supply gives is more
  /// by the avionics' power, and the bus satisfies b = E - R_0 i.
  void busCarriesIt() {
    const auto without = hovering(withAvionics(0)), with = hovering(withAvionics(kPower));
    const double before = without.busVoltage * without.supplyCurrent;
    QVERIFY(std::abs(with.busVoltage * with.supplyCurrent - before - kPower) < 1e-6);
    QVERIFY(with.busVoltage < without.busVoltage);
    const Supply supply{BatteryParameters{}};
    const double bus = supply.openCircuit(1.0) - supply.resistance * with.supplyCurrent;
    QVERIFY(std::abs(with.busVoltage - bus) < 1e-9);
    for (std::size_t i = 0; i < 4; ++i)
      QVERIFY(std::abs(with.voltage[i] - without.voltage[i]) < 1e-6);
  }

  void standingVehicleDrawsNothingElse() {
    Plant plant(buildMultirotor<4>(withAvionics(kPower), {}));
    FlightStart stopped;
    stopped.rotors = RotorStart::Stopped;
    Plant::State y = plant.initialState(stopped), rate;
    plant.setCommand(Plant::Command::Zero(), y);
    MultirotorForces<4> forces{};
    plant.derivativeAndForces(0, y, rate, forces);
    QVERIFY(std::abs(forces.busVoltage * forces.supplyCurrent - kPower) < 1e-9);
    QCOMPARE(rate[Plant::Layout::kCharge], forces.supplyCurrent);
  }

  void sheetCountsIt() {
    const FigureSheet without = performanceSheet(withAvionics(0), {}),
                      with = performanceSheet(withAvionics(kPower), {});
    const double power = without.at("hover.power").value;
    QVERIFY(std::abs(with.at("hover.power").value - power - kPower) < 1e-6);
    // At the same capacity the time goes with the inverse of the power, a little less with the sag.
    const double ratio = with.at("endurance.hover").value / without.at("endurance.hover").value;
    QVERIFY2(std::abs(ratio / (power / (power + kPower)) - 1) < 0.02,
             qPrintable(QString::number(ratio)));
  }
};

QTEST_APPLESS_MAIN(TestAvionics)
#include "test_avionics.moc"
