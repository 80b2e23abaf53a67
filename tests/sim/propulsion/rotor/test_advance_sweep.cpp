// Coefficients over the advance ratio against their definitions, worked out here from thrust and
// torque.
#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/propulsion/rotor/advance_sweep.h"

using namespace rotorbench;
using std::numbers::pi;

class TestAdvanceSweep : public QObject {
  Q_OBJECT

  const PropellerGeometry geometry;
  const BladeElementRotor rotor{geometry};
  const AirState air;
  static constexpr double kOmega = 500;  // rad/s

 private slots:
  void pointMeetsDefinition_data() {
    QTest::addColumn<double>("speed");
    for (const double v : {-3.0, 0.0, 4.0, 9.0, 20.0}) QTest::addRow("%g m/s", v) << v;
  }
  void pointMeetsDefinition() {
    QFETCH(double, speed);
    const AxialLoad load = rotor.axial(kOmega, speed, air);
    const AdvancePoint point = advancePoint(rotor, kOmega, speed, air);
    const double n = kOmega / (2 * pi), d = geometry.diameter;
    QCOMPARE(point.advanceRatio, speed / (n * d));
    QCOMPARE(point.thrustCoefficient * air.density * n * n * std::pow(d, 4), load.thrust);
    // P = Q omega.
    QCOMPARE(point.powerCoefficient * air.density * n * n * n * std::pow(d, 5),
             load.torque * kOmega);
    if (speed > 0 && load.thrust > 0 && load.torque > 0) {
      QCOMPARE(point.efficiency, load.thrust * speed / (load.torque * kOmega));
    } else {
      QCOMPARE(point.efficiency, 0.0);
    }
  }

  void curvesEndBeyondZeroThrust() {
    const AdvanceSweep curves = advanceSweep(rotor, kOmega, air);
    QVERIFY(curves.zeroThrust && curves.best);
    const double speed = *curves.zeroThrust * kOmega / (2 * pi) * geometry.diameter;
    const double rest = curves.points.front().thrustCoefficient;
    QVERIFY(std::abs(advancePoint(rotor, kOmega, speed, air).thrustCoefficient) < 0.002 * rest);
    QVERIFY(curves.points.back().thrustCoefficient < 0);
    QVERIFY(curves.best->efficiency > 0.4 && curves.best->efficiency < 1);
    QVERIFY(curves.best->advanceRatio < *curves.zeroThrust);
  }

  void figureOfMeritIsIdealOverActualPower() {
    const AdvanceSweep curves = advanceSweep(rotor, kOmega, air);
    const AxialLoad rest = rotor.axial(kOmega, 0, air);
    const double area = pi * geometry.diameter * geometry.diameter / 4;
    const double ideal = std::pow(rest.thrust, 1.5) / std::sqrt(2 * air.density * area);
    QCOMPARE(curves.figureOfMerit, ideal / (rest.torque * kOmega));
    QVERIFY(curves.figureOfMerit < 1);
  }

  void withoutAirThereIsNothing() {
    const AdvanceSweep curves = advanceSweep(rotor, kOmega, {0, 1.8e-5});
    for (const AdvancePoint& p : curves.points) {
      QVERIFY(std::isfinite(p.thrustCoefficient) && std::isfinite(p.powerCoefficient));
    }
    QVERIFY(!curves.best && !curves.zeroThrust);
  }
};

QTEST_APPLESS_MAIN(TestAdvanceSweep)
#include "test_advance_sweep.moc"
