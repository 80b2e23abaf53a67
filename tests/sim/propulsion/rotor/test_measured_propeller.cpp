// A propeller by measured coefficients: exact at its points, smooth and finite everywhere.
#include <Eigen/Core>
#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/core/schema_tree.h"
#include "sim/propulsion/rotor/blade_element.h"
#include "sim/propulsion/rotor/measured_propeller.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using std::numbers::pi;

namespace {

constexpr double kDensity = 1.2;

/// CT and CP of a table at a speed in rad/s and an advance ratio.
std::pair<double, double> coefficients(const CoefficientTable& table, double w, double advance) {
  const double d = 2 * table.radius(), n = w / (2 * pi);
  const auto load = table.axialLoad(w, advance * n * d, kDensity);
  return {load.thrust / (kDensity * n * n * std::pow(d, 4)),
          load.torque * 2 * pi / (kDensity * n * n * std::pow(d, 5))};
}

MeasuredPropeller of(std::vector<CoefficientPoint> points) {
  MeasuredPropeller p;
  p.points = std::move(points);
  return p;
}

}  // namespace

class TestMeasuredPropeller : public QObject {
  Q_OBJECT
 private slots:
  /// Every measured point comes back, whatever the order of the rows.
  void exactAtItsPoints() {
    MeasuredPropeller p;
    std::reverse(p.points.begin(), p.points.end());
    const CoefficientTable table(p);
    for (const CoefficientPoint& point : p.points) {
      const auto [ct, cp] = coefficients(table, point.speed, point.advanceRatio);
      QVERIFY(std::abs(ct - point.thrustCoefficient) < 1e-12);
      QVERIFY(std::abs(cp - point.powerCoefficient) < 1e-12);
    }
  }

  /// Half-way between two speeds is the mean; slower and faster than any the nearest holds.
  void speedsAreInterpolated() {
    const CoefficientTable table(of({{300, 0, 0.10, 0.04},
                                     {300, 0.5, 0.04, 0.03},
                                     {500, 0, 0.12, 0.05},
                                     {500, 0.5, 0.06, 0.04}}));
    QVERIFY(std::abs(coefficients(table, 400, 0).first - 0.11) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 400, 0.5).second - 0.035) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 10, 0.5).first - 0.04) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 5000, 0).second - 0.05) < 1e-12);
  }

  /// A static test beside a tunnel's: at rest the static values hold, in the stream those of the
  /// tunnel.
  void staticTestCompletesACurve() {
    const CoefficientTable table(of({{400, 0.2, 0.10, 0.045},
                                     {401, 0.6, 0.02, 0.025},
                                     {200, 0, 0.11, 0.047},
                                     {600, 0, 0.13, 0.051}}));
    QVERIFY(std::abs(coefficients(table, 400.5, 0).first - 0.12) < 1e-4);
    QVERIFY(std::abs(coefficients(table, 600, 0).first - 0.13) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 200, 0).second - 0.047) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 400.5, 0.6).first - 0.02) < 1e-12);
    QVERIFY(std::abs(coefficients(table, 600, 0.6).first - 0.02) < 1e-12);
  }

  /// Value and slope meet at the ends of the measured range.
  void smoothBeyondTheRange() {
    const CoefficientTable table{MeasuredPropeller{}};
    for (const double w : {420.3, 681.9, 550.0}) {
      for (const double edge : {0.0, w > 600 ? 0.755 : 0.719}) {
        const double chi = std::atan(edge / (0.75 * pi)), h = 1e-6;
        const auto a = table.coefficients(chi - h, w), b = table.coefficients(chi, w),
                   c = table.coefficients(chi + h, w);
        QVERIFY(std::abs(a.thrust - b.thrust) < 1e-5 && std::abs(c.torque - b.torque) < 1e-5);
        QVERIFY(std::abs((c.thrust - b.thrust) - (b.thrust - a.thrust)) / h < 1e-3);
        QVERIFY(std::abs((c.torque - b.torque) - (b.torque - a.torque)) / h < 1e-3);
      }
    }
  }

  /// Past zero thrust the propeller brakes, and in the end the stream drives it; in descent it
  /// still lifts.
  void windmillAndDescent() {
    const CoefficientTable table{MeasuredPropeller{}};
    for (double advance = 0.8; advance <= 2; advance += 0.05)
      QVERIFY(coefficients(table, 500, advance).first < 0);
    QVERIFY(coefficients(table, 500, 2).second < 0);
    for (double advance = -2; advance <= 0; advance += 0.05)
      QVERIFY(coefficients(table, 500, advance).first > 0);
  }

  /// The parked propeller of the extrapolation is the mean of blade elements over 101 propellers,
  /// written with two digits. (One propeller is off by more: their standard deviation is 36 % of
  /// the mean thrust and 45 % of the mean torque.)
  void parkedValuesAreThoseOfBladeElements() {
    double thrust = 0, torque = 0, count = 0;
    for (const auto& set : uiuc::sets()) {
      const BladeElementRotor rotor(set.geometry);
      const double area = pi * rotor.radius() * rotor.radius(), speed = 10;
      const AxialLoad load = rotor.axial(0, speed, {});
      const double scale = 1 / (0.5 * 1.225 * speed * speed * area);
      thrust -= load.thrust * scale, torque -= load.torque * scale / rotor.radius(), ++count;
    }
    qInfo("thrust %.4f, torque %.4f", thrust / count, torque / count);
    QVERIFY(std::abs(thrust / count - kParkedThrust) < 0.005);
    QVERIFY(std::abs(torque / count - kParkedTorque) < 0.0005);
  }

  void finiteEverywhere() {
    const CoefficientTable table{MeasuredPropeller{}};
    const Eigen::Vector3d axis(0, 0, 1);
    for (const double w : {-1e5, -500.0, -1e-9, 0.0, 1e-12, 1.0, 500.0, 1e5}) {
      for (const double axial : {-1e4, -20.0, 0.0, 1e-12, 20.0, 1e4}) {
        for (const double side : {0.0, 15.0, 1e4}) {
          for (const double density : {0.0, 1.2}) {
            const auto l = table.load(w, Eigen::Vector3d(side, 0, axial), axis, 1, density);
            QVERIFY(l.force.allFinite() && l.moment.allFinite() && std::isfinite(l.thrust) &&
                    std::isfinite(l.torque));
            if (density == 0) QVERIFY(l.force.isZero() && l.moment.isZero());
          }
        }
      }
    }
    // Where it stops turning the loads have a limit.
    const auto still = table.axialLoad(0.0, 8.0, kDensity),
               slow = table.axialLoad(1e-6, 8.0, kDensity);
    QVERIFY(std::abs(still.thrust - slow.thrust) < 1e-6 && still.thrust < 0);
    QCOMPARE(table.axialLoad(-400.0, 2.0, kDensity).thrust,
             -table.axialLoad(400.0, -2.0, kDensity).thrust);
    QCOMPARE(table.axialLoad(-1e-9, 8.0, kDensity).torque,
             -table.axialLoad(1e-9, -8.0, kDensity).torque);
  }

  /// Between measured points no overshoot: a curve that only falls stays falling.
  void monotone() {
    const CoefficientTable table(
        of({{0, 0, 0.1, 0.05}, {0, 0.1, 0.1, 0.05}, {0, 0.2, 0.02, 0.04}, {0, 0.9, 0.0, 0.01}}));
    double last = 1;
    for (double j = 0; j <= 0.9; j += 0.001) {
      const double ct = coefficients(table, 300, j).first;
      QVERIFY(ct <= last + 1e-12 && ct >= -1e-12);
      last = ct;
    }
  }

  void faultsAreNamed_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<std::vector<CoefficientPoint>>("points");
    using P = std::vector<CoefficientPoint>;
    QTest::addRow("only at rest") << "no curve" << P{{300, 0, 0.1, 0.04}, {400, 0, 0.1, 0.04}};
    QTest::addRow("the same point twice") << "no curve" << P{{0, 0, 0.1, 0.04}, {0, 0, 0.11, 0.04}};
    QTest::addRow("speed in some rows")
        << "some have none" << P{{0, 0, 0.1, 0.04}, {300, 0.4, 0.1, 0.04}};
    QTest::addRow("alone in the stream")
        << "alone" << P{{300, 0, 0.1, 0.04}, {300, 0.4, 0.1, 0.04}, {500, 0.3, 0.1, 0.04}};
  }
  void faultsAreNamed() {
    QFETCH(QString, what);
    QFETCH(std::vector<CoefficientPoint>, points);
    const auto p = of(points);
    const auto problems = schema::validate(schema::ref(p));
    QCOMPARE(problems.size(), std::size_t(1));
    QVERIFY2(QString::fromStdString(problems.front().message()).contains(what),
             problems.front().message().c_str());
    const MeasuredPropeller good;
    QVERIFY(schema::validate(schema::ref(good)).empty());
  }
};

QTEST_GUILESS_MAIN(TestMeasuredPropeller)
#include "test_measured_propeller.moc"
