// The shipped thrust stand is computed with what blade elements give. Against its log:
// test_published_data.cpp.
#include <QtTest>
#include <cmath>

#include "sim/document/thrust_stand.h"
#include "sim/run/drive_build.h"
#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

class TestThrustStand : public QObject {
  Q_OBJECT
 private slots:
  /// Held for a second at each level, with a battery that is nearly empty of memory, the stand
  /// reaches the points that are solved directly.
  void solvedAndReachedAgree() {
    Experiment experiment = shipped("thrust-stand-x2216");
    auto& bench = alternative<ThrustStand>(experiment.setup);
    auto& battery = std::get<BatteryParameters>(bench.stand.supply);
    battery.capacity = 1e7;
    battery.polarisationTime = 0.02;
    std::get<ThrottleLevels>(bench.procedure).holdTime = 2;
    const auto simulation = runToEnd(experiment);
    const double difference = figure(simulation->metrics(), "Run", "steady_difference");
    QVERIFY2(difference < 1e-6, qPrintable(QString::number(difference)));
    QCOMPARE(simulation->runs().back().recording->rows(), std::size_t{9});
  }

  /// The curve over the speed is read between its points: what it says there is what blade elements
  /// give.
  void curveBetweenItsPoints() {
    Experiment experiment = shipped("thrust-stand-x2216");
    const DriveStand& stand = alternative<ThrustStand>(experiment.setup).stand;
    const auto& load = std::get<BladeElementLoad>(stand.load);
    const DriveTrain train = buildDriveTrain(stand);
    const BladeElementRotor rotor(load.propeller, load.settings);
    for (const double w : {150.0, 333.3, 517.0, 801.0, 1203.0}) {
      const AxialLoad exact = rotor.axial(w, 0, {load.airDensity, load.airViscosity});
      QVERIFY2(std::abs(train.load().torque(w) / exact.torque - 1) < 2e-3,
               qPrintable(QString::number(train.load().torque(w) / exact.torque - 1)));
      QVERIFY(std::abs(train.load().thrustAt(w) / exact.thrust - 1) < 2e-3);
    }
  }
};

QTEST_APPLESS_MAIN(TestThrustStand)
#include "test_thrust_stand.moc"
