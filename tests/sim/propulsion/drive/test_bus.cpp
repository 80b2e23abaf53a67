// The bus under a power, and a motor whose torques are polynomials: their equations put back in.
#include <Eigen/Core>
#include <QtTest>
#include <unsupported/Eigen/AutoDiff>

#include "sim/propulsion/drive/bus.h"
#include "sim/propulsion/drive/drive_train.h"
#include "sim/propulsion/drive/steady_motor.h"

using namespace rotorbench;

class TestBus : public QObject {
  Q_OBJECT
 private slots:
  /// b (E - b)/R_0 = P, b in the upper half; nothing is lost without a resistance, and power that
  /// returns lifts the bus.
  void powerAndSupplyAgree() {
    for (const double inner : {3.7, 11.1, 50.0}) {
      for (const double resistance : {0.001, 0.02, 0.5}) {
        const double most = inner * inner / (4 * resistance);
        for (const double part : {-0.5, 0.0, 1e-9, 0.3, 0.99}) {
          const double power = part * most, bus = busVoltage(inner, power, resistance);
          QVERIFY(busReserve(inner, power, resistance) > 0);
          QVERIFY(bus >= inner / 2);
          QVERIFY(std::abs(bus * (inner - bus) / resistance - power) < 1e-11 * most);
          QCOMPARE(bus > inner, power < 0);
        }
        QCOMPARE(busVoltage(inner, 0.7 * most, 0.0), inner);
        // More than there is: the voltage of the most there is.
        QVERIFY(busReserve(inner, 1.01 * most, resistance) < 0);
        QCOMPARE(busVoltage(inner, 1.01 * most, resistance), inner / 2);
      }
    }
  }

  /// Implicit differentiation: db/dP = -R_0/(2 b - E), db/dE = b/(2 b - E).
  void slopesOfTheBus() {
    using Slope = Eigen::AutoDiffScalar<Eigen::Vector2d>;
    const double resistance = 0.03;
    const Slope inner(11.1, 2, 0), power(250, 2, 1);
    const Slope bus = busVoltage(inner, power, resistance);
    const double width = 2 * bus.value() - 11.1;
    QVERIFY(std::abs(bus.derivatives()[0] - bus.value() / width) < 1e-12);
    QVERIFY(std::abs(bus.derivatives()[1] + resistance / width) < 1e-12);
  }

  /// All lanes at once are each alone.
  void convertersInLanes() {
    using Lanes = Eigen::Array4d;
    const Lanes v(0, 3.5, -2, 11), r(0, 0.005, 0.1, 0.02), i(5, 12, -7, 0.3);
    const Lanes all = converterPower(v, r, i);
    for (int k = 0; k < 4; ++k) {
      QCOMPARE(all[k], converterPower(double{v[k]}, double{r[k]}, double{i[k]}));
      QVERIFY(std::abs(all[k] - (v[k] * i[k] + r[k] * i[k] * i[k])) < 1e-12);
    }
  }

  void steadySpeedSolvesItsEquation_data() {
    QTest::addColumn<double>("constant");
    QTest::addColumn<double>("linear");
    QTest::addColumn<double>("quadratic");
    QTest::addRow("propeller") << 0.5 << 0.0 << 2e-5;
    QTest::addRow("propeller and viscous friction") << 0.5 << 1e-3 << 2e-5;
    QTest::addRow("hardly any load") << 0.5 << 0.0 << 1e-14;
    QTest::addRow("no load") << 0.5 << 1e-3 << 0.0;
    QTest::addRow("nothing at all") << 0.0 << 0.0 << 0.0;
  }
  void steadySpeedSolvesItsEquation() {
    QFETCH(double, constant);
    QFETCH(double, linear);
    QFETCH(double, quadratic);
    const SteadyCurrent current{constant, linear, quadratic};
    constexpr double k = 0.01, r = 0.1;
    for (const double v : {0.2, 3.0, 11.1, 50.0}) {
      const double w = steadySpeed(current, k, r, v);
      QVERIFY(w > 0);
      QVERIFY(std::abs(r * current.at(w) + k * w - v) < 1e-13 * v);
    }
    // What does not turn it at rest.
    QCOMPARE(steadySpeed(current, k, r, 0.5 * r * constant) < 0, constant > 0);
  }

  /// The search for any load finds the same where friction is as constant as it is here: its smooth
  /// sign differs from 1 by (1/w)^2/2.
  void searchAgrees() {
    MotorParameters parameters = djiE305();
    parameters.viscousShare = 0.4;
    const MotorConstants m = buildMotor(parameters);
    constexpr double kLoad = 2.6e-7;
    const SteadyCurrent current{m.dryFriction / m.torqueConstant,
                                m.viscousFriction / m.torqueConstant, kLoad / m.torqueConstant};
    const ShaftLoad load{.quadratic = {1, {kLoad, kLoad}}};
    for (const double v : {2.0, 6.0, 11.1}) {
      const double w = steadySpeed(m, load, v);
      QVERIFY(std::abs(steadySpeed(current, m.torqueConstant, m.resistance, v) / w - 1) < 1e-5);
    }
  }
};

QTEST_GUILESS_MAIN(TestBus)
#include "test_bus.moc"
