#include <QtTest>
#include <cmath>
#include <numbers>

#include "sim/analysis/trim.h"

using namespace rotorbench;

namespace {

/// A vehicle whose only resistance is the linear one of its body.
VehicleParameters draggy(double mass, double drag) {
  VehicleParameters v;
  v.layout = CrossLayout{.height = 0};
  DirectMass body;
  body.mass = mass;
  body.centreOfMass.setZero();
  body.inertia = {.xx = 3e-3, .yy = 3e-3, .zz = 5e-3};
  v.mass = body;
  v.drag.linear = drag;
  return v;
}

}  // namespace

class TestTrim : public QObject {
  Q_OBJECT
 private slots:
  /// Leaning into 5 m/s with k = 0.153 N s/m and 0.547 kg: tan(tilt) = k v/(m g), 8.1136 degrees
  /// with g = 9.81 m/s^2 (closed form).
  void tiltAgainstTheWind() {
    EnvironmentParameters earth;
    earth.gravity = 9.81;
    const auto vehicle = buildMultirotor<4>(draggy(0.547, 0.153), earth);
    const auto hover = trimmedHover(vehicle);
    QVERIFY(hover.has_value());
    QCOMPARE(hover->tilt(), 0.0);
    const auto trim = trimmedFlight(vehicle, 5, *hover);
    QVERIFY(trim.has_value());
    QVERIFY(std::abs(trim->tilt() * 180 / std::numbers::pi - 8.1136) < 1e-4);
    QVERIFY(trim->pitch > 0 && std::abs(trim->roll) < 1e-12);
    QVERIFY(trim->residual < 1e-9);
    // Four equal thrusts carry weight and drag.
    const double force = std::hypot(0.547 * 9.81, 5 * 0.153);
    QVERIFY(std::abs(trim->thrust.sum() - force) < 1e-9 * force);
  }

  /// Six rotors share what four do not need: of all ways to hover the search stays near the one it
  /// begins at.
  void moreRotorsThanNeeded() {
    VehicleParameters v = draggy(1, 0.1);
    v.layout = PlusLayout{.count = RingCount::Six};
    const auto vehicle = buildMultirotor<6>(v, {});
    const auto hover = trimmedHover(vehicle);
    QVERIFY(hover.has_value());
    QVERIFY(hover->rotors().maxCoeff() - hover->rotors().minCoeff() < 1e-9);
    Trim uneven = *hover;
    // Opposite rotors of a hexagon turn oppositely: this pattern changes neither force nor moment
    // to first order.
    for (int i = 0; i < 6; ++i) uneven.speeds[i] += (i % 3 == 0 ? 10 : -5);
    const auto found = trimmedFlight(vehicle, 0, uneven);
    QVERIFY(found.has_value());
    QVERIFY(found->residual < 1e-9);
    QVERIFY((found->rotors() - uneven.rotors()).norm() <
            0.5 * (hover->rotors() - uneven.rotors()).norm());
  }

  /// Rotors that all lean forward hover with the nose up, where the level search finds nothing.
  void leaningRotorsTiltTheVehicle() {
    VehicleParameters v = draggy(1, 0);
    FreeLayout layout{placeRotors(CrossLayout{.height = 0})};
    for (auto& rotor : layout.rotors) rotor.axis = {0.2, 0, 1};
    v.layout = layout;
    const auto hover = trimmedHover(buildMultirotor<4>(v, {}));
    QVERIFY(hover.has_value());
    QVERIFY(std::abs(hover->pitch + std::atan(0.2)) < 1e-9);
  }

  void impossibleOnesAreEmpty() {
    VehicleParameters aside = draggy(1, 0);
    FreeLayout layout{placeRotors(CrossLayout{.height = 0})};
    for (auto& rotor : layout.rotors) rotor.position.x() += 1;
    aside.layout = layout;
    QVERIFY(!trimmedHover(buildMultirotor<4>(aside, {})).has_value());
    EnvironmentParameters airless;
    airless.air = UniformAir{0};
    QVERIFY(!trimmedHover(buildMultirotor<4>(draggy(1, 0), airless)).has_value());
    QVERIFY_THROWS_EXCEPTION(InputError, hoverToStartIn(buildMultirotor<4>(aside, {})));
  }
};

QTEST_APPLESS_MAIN(TestTrim)
#include "test_trim.moc"
