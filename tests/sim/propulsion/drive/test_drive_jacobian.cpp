#include <Eigen/Core>  // AutoDiff does not include it itself
#include <QtTest>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "sim/propulsion/drive/drive_train.h"

using namespace rotorbench;
using State = DriveTrain::State;
using Dual = Eigen::AutoDiffScalar<State>;

class TestDriveJacobian : public QObject {
  Q_OBJECT
 private slots:
  void exactJacobianEqualsCentralDifferences_data();
  void exactJacobianEqualsCentralDifferences();
};

void TestDriveJacobian::exactJacobianEqualsCentralDifferences_data() {
  QTest::addColumn<bool>("quasiStatic");
  QTest::addColumn<bool>("battery");
  QTest::addColumn<double>("current");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("duty");
  QTest::addColumn<bool>("braking");
  for (const bool quasiStatic : {false, true}) {
    for (const bool battery : {false, true}) {
      const auto row = [&](const char* name, double i, double w, double d, bool braking = true) {
        QTest::addRow("%s, %s, %s", name, quasiStatic ? "quasi-static" : "dynamic",
                      battery ? "battery" : "fixed voltage")
            << quasiStatic << battery << i << w << d << braking;
      };
      row("driving", 8, 520, 0.7);
      row("braking", -5, 700, 0.4);
      row("near rest", 2, 0.5, 0.05);
      row("backwards", -6, -300, -0.5);
      row("at the current limit", 29.999, 100, 1);
      row("passive, driving", 8, 520, 0.7, false);
      row("passive, let go", 3, 720, 0.3, false);
      row("passive, against the duty", -40, 320, -0.4, false);
    }
  }
}

/// Speeds are away from the kinks of the propeller's curve, which has a point every 50 rad/s.
void TestDriveJacobian::exactJacobianEqualsCentralDifferences() {
  QFETCH(bool, quasiStatic);
  QFETCH(bool, battery);
  QFETCH(double, current);
  QFETCH(double, speed);
  QFETCH(double, duty);
  QFETCH(bool, braking);
  DriveTrainSetup setup;
  setup.motor = djiE305();
  setup.esc = {.resistance = 0.005, .responseTime = 0.01};
  if (battery) {
    setup.supply = BatteryParameters{};
  } else {
    setup.supply = SupplyParameters{.voltage = 11.1, .internalResistance = 0.03};
  }
  setup.motor.viscousShare = 0.3;
  setup.motor.maxCurrent = 100;
  setup.esc.maxCurrent = 30;
  setup.esc.reverse = true;
  setup.esc.activeBraking = braking;
  setup.load.quadratic = {50, {}};
  for (int k = 0; k <= 20; ++k) setup.load.quadratic.values.push_back(2e-7 * (1 + 0.02 * k));
  setup.load.constant = 0.004;
  setup.quasiStaticCurrent = quasiStatic;
  const DriveTrain train(setup);
  State x;
  x << current, speed, duty, 0.83, 0.07;

  Eigen::Matrix<Dual, DriveTrain::kStates, 1> dual, exact;
  for (int k = 0; k < DriveTrain::kStates; ++k) dual[k] = Dual(x[k], DriveTrain::kStates, k);
  train.derivative(dual, exact);
  State value;
  train.derivative(x, value);
  for (int k = 0; k < DriveTrain::kStates; ++k) {
    const double step = 1e-6 * std::max(1.0, std::abs(x[k]));
    State up = x, down = x, above, below;
    up[k] += step;
    down[k] -= step;
    train.derivative(up, above);
    train.derivative(down, below);
    const State difference = (above - below) / (2 * step);
    for (int i = 0; i < DriveTrain::kStates; ++i) {
      QCOMPARE(exact[i].value(), value[i]);
      // Rates without a dependence carry no derivatives at all.
      const double derivative = exact[i].derivatives().size() > 0 ? exact[i].derivatives()[k] : 0.0;
      const double error = std::abs(derivative - difference[i]);
      const double allowed =
          1e-6 * std::abs(difference[i]) + 1e-7 + 1e-14 * std::abs(value[i]) / step;
      QVERIFY2(error < allowed, qPrintable(QString("d(%1)/d(%2): %3 against %4")
                                               .arg(DriveTrain::componentName(i).data())
                                               .arg(DriveTrain::componentName(k).data())
                                               .arg(derivative)
                                               .arg(difference[i])));
    }
  }
}

QTEST_APPLESS_MAIN(TestDriveJacobian)
#include "test_drive_jacobian.moc"
