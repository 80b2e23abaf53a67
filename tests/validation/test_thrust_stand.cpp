// Battery, speed controller, motor and blade-element propeller together against a log of a thrust stand.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/validation/run_experiment.h"

using namespace rotorbench;
using namespace rotorbench::test;

class TestThrustStand : public QObject {
  Q_OBJECT
 private slots:
  /// RCbenchmark 1580 log of a SunnySky X2216 1100 KV with an APC 10x4.7SF on three cells: mean of the 162 rows at full
  /// throttle. github.com/Darlock7/Nimbus-Package-Delivery-UAV, 'Prop Tests/10x4.7.csv'; Kv, resistance and no-load
  /// current are the authors', the propeller's geometry and the section's constants the UIUC set's.
  void fullThrottle_data() {
    QTest::addColumn<QString>("channel");
    QTest::addColumn<double>("measured");
    QTest::addRow("thrust, N") << "thrust" << 10.6837;
    QTest::addRow("speed, rad/s") << "motor.speed" << 7849.31 * std::numbers::pi / 30;
    QTest::addRow("current, A") << "supply.current" << 22.684;
  }
  void fullThrottle() {
    QFETCH(QString, channel);
    QFETCH(double, measured);
    Experiment experiment = shipped("thrust-stand-x2216");
    auto& bench = std::get<ThrustStand>(experiment.setup);
    bench.stand.supply = SupplyParameters{.voltage = 10.4743};  // as logged at the speed controller
    bench.procedure = ThrottleLevels{{{1.0}}, 1};
    const auto simulation = runToEnd(experiment);
    const Recording& r = *simulation->runs().front().recording;
    const double model = r.value(*r.find(channel.toStdString()), r.rows() - 1);
    qInfo("%s: model %.4g, measured %.4g, %+.1f %%", qPrintable(channel), model, measured,
          100 * (model / measured - 1));
    QVERIFY2(std::abs(model / measured - 1) < 0.08, qPrintable(QString::number(model)));
  }

  /// Held for a second at each level, with a battery that is nearly empty of memory, the stand reaches the points that
  /// are solved directly.
  void solvedAndReachedAgree() {
    Experiment experiment = shipped("thrust-stand-x2216");
    auto& bench = std::get<ThrustStand>(experiment.setup);
    auto& battery = std::get<BatteryParameters>(bench.stand.supply);
    battery.capacity = 1e7;
    battery.polarisationTime = 0.02;
    std::get<ThrottleLevels>(bench.procedure).holdTime = 2;
    const auto simulation = runToEnd(experiment);
    const double difference = figure(simulation->metrics(), "Run", "steady_difference");
    QVERIFY2(difference < 1e-6, qPrintable(QString::number(difference)));
    QCOMPARE(simulation->runs().back().recording->rows(), std::size_t{9});
  }

  /// The curve over the speed is read between its points: what it says there is what blade elements give.
  void curveBetweenItsPoints() {
    Experiment experiment = shipped("thrust-stand-x2216");
    const DriveStand& stand = std::get<ThrustStand>(experiment.setup).stand;
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
