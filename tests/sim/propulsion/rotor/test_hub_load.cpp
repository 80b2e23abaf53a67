// Force and moment at a hub, by the words of hub_load.h in vectors, and what holds in any frame.
#include <Eigen/Geometry>
#include <QtTest>
#include <numbers>

#include "sim/core/random.h"
#include "sim/propulsion/rotor/hub_load.h"
#include "sim/propulsion/rotor/lumped_rotor.h"
#include "sim/propulsion/rotor/measured_propeller.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

/// Any velocity, axis, thrust, torque and coefficients of drag and flapping.
struct Any {
  Vector3d v, axis;
  double spin, thrust, torque, drag, flapping;

  explicit Any(RandomStream& random) {
    const auto number = [&] { return random.normal(); };
    v = {10 * number(), 10 * number(), 10 * number()};
    axis = Vector3d(number(), number(), number()).normalized();
    spin = number() < 0 ? -1 : 1;
    thrust = 5 * number(), torque = 0.1 * number();
    drag = 0.02 * std::abs(number()), flapping = 0.001 * std::abs(number());
  }
  [[nodiscard]] RotorLoad<double> load() const {
    return hubLoad<double>(v, axis, spin, hubStream<double>(v, axis).axial, thrust, torque, drag,
                           flapping);
  }
};

}  // namespace

class TestHubLoad : public QObject {
  Q_OBJECT
 private slots:
  void equationsInVectors() {
    RandomStream random(1, "hub");
    for (int i = 0; i < 200; ++i) {
      const Any any(random);
      const Vector3d across = any.v - any.v.dot(any.axis) * any.axis;
      const HubStream<double> stream = hubStream<double>(any.v, any.axis);
      QVERIFY(std::abs(stream.axial - any.v.dot(any.axis)) < 1e-13);
      QVERIFY(std::abs(stream.acrossSquared - across.squaredNorm()) < 1e-11);
      const RotorLoad<double> l = any.load();
      QVERIFY((l.force - (any.thrust * any.axis - any.drag * across)).norm() < 1e-13);
      const Vector3d moment =
          -any.spin * any.torque * any.axis - any.flapping * any.v.cross(any.axis);
      QVERIFY((l.moment - moment).norm() < 1e-14);
      QCOMPARE(l.thrust, any.thrust);
      QCOMPARE(l.torque, any.torque);
      // Air from the side takes power and gives none.
      QVERIFY((l.force - any.thrust * any.axis).dot(any.v) < 1e-14);
    }
  }

  void turnsWithItsFrame() {
    RandomStream random(2, "hub");
    for (int i = 0; i < 50; ++i) {
      Any any(random);
      const RotorLoad<double> before = any.load();
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(random.normal(), Vector3d(1, -2, 0.5).normalized()).matrix();
      any.v = turn * any.v;
      any.axis = turn * any.axis;
      const RotorLoad<double> after = any.load();
      QVERIFY((after.force - turn * before.force).norm() < 1e-13);
      QVERIFY((after.moment - turn * before.moment).norm() < 1e-14);
    }
  }

  /// The lumped and the measured rotor differ in thrust and torque only: what the air from the side
  /// does is the same with the same coefficients, but for the thrust it adds.
  void modelsAgreeOnAirFromTheSide() {
    const double density = 1.1, w = 600, spin = -1;
    const InPlaneFlow flow{.drag = 1e-4, .translationalLift = 0.004, .flapping = 2e-6};
    RotorCoefficients lumped;
    lumped.inflow = {
        .drag = flow.drag, .translationalLift = flow.translationalLift, .flapping = flow.flapping};
    lumped.referenceDensity = kStandardDensity;
    const RotorModel<double> a = lumpedModel(lumped);
    MeasuredPropeller propeller;
    propeller.inPlane = flow;
    const CoefficientTable b(propeller);
    const Vector3d axis = Vector3d(0.1, -0.2, 1).normalized(), along = 3 * axis;
    const Vector3d v = along + Vector3d(2, 1, 0).cross(axis) * 4;
    const auto loads = [&](const Vector3d& velocity) {
      return std::pair(a.load<double, Vector3d>(w, velocity, axis, spin, density),
                       b.load<double, Vector3d>(w, velocity, axis, spin, density));
    };
    const auto [a0, b0] = loads(along);
    const auto [a1, b1] = loads(v);
    QVERIFY(std::abs((a1.thrust - a0.thrust) - (b1.thrust - b0.thrust)) < 1e-12);
    QVERIFY(a1.thrust - a0.thrust > 0.1);
    QVERIFY(((a1.force - a0.force) - (b1.force - b0.force)).norm() < 1e-12);
    QVERIFY(((a1.moment - a0.moment) - (b1.moment - b0.moment)).norm() < 1e-13);
    QVERIFY((a1.moment - a0.moment).norm() > 1e-3);
  }
};

QTEST_GUILESS_MAIN(TestHubLoad)
#include "test_hub_load.moc"
