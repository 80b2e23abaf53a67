// What holds for a vehicle of four, six or eight rotors alike.
#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/analysis/trim.h"
#include "sim/core/schema_tree.h"
#include "sim/numerics/dual.h"
#include "sim/vehicle/multirotor.h"
#include "tests/sim/vehicle/plain_rk4.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

RingCount ringOf(int n) {
  return static_cast<RingCount>(n);
}

/// Arms, axes, spins, masses and rotors all a little off, each in its own way.
VehicleParameters lopsided(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> off(-1, 1);
  VehicleParameters v;
  v.layout = CrossLayout{.count = ringOf(n)};
  FreeLayout layout{placeRotors(v.layout)};
  IndividualRotors own{std::vector<RotorParameters>(static_cast<std::size_t>(n))};
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    layout.rotors[i].position += 0.02 * Vector3d(off(random), off(random), off(random));
    layout.rotors[i].axis += 0.08 * Vector3d(off(random), off(random), off(random));
    auto& propeller = std::get<PropellerCoefficients>(own.rotors[i].aerodynamics);
    propeller.thrustCoefficient *= 1 + 0.1 * off(random);
    propeller.inflow = {1e-4, 2e-4, 3e-3, 1e-6};
  }
  v.layout = layout;
  v.rotors = own;
  v.payloads = {{0.2, 0.03 * Vector3d(off(random), off(random), off(random))}};
  v.drag.quadratic = {0.01, 0.012, 0.02};
  return v;
}

void counts() {
  QTest::addColumn<int>("rotors");
  for (const int n : {4, 6, 8}) QTest::addRow("%d rotors", n) << n;
}

/// A motion with everything in it.
template <class Plant>
typename Plant::State someMotion(const Plant& plant) {
  FlightStart start;
  start.position = {1, -2, 3};
  start.velocity = {3, -1, 0.5};
  start.attitude = {0.2, -0.1, 0.7};
  start.rates = {0.4, -0.3, 0.2};
  return plant.initialState(start, Plant::Command::Constant(450));
}

}  // namespace

class TestRotorCounts : public QObject {
  Q_OBJECT
 private slots:
  void rings_data();
  void rings();
  void hoverIsAnEquilibrium_data() { counts(); }
  void hoverIsAnEquilibrium();
  void slopesAreDifferences_data() { counts(); }
  void slopesAreDifferences();
  void steadyWindIsAMovingFrame_data() { counts(); }
  void steadyWindIsAMovingFrame();
  void otherCountsAreRefused();
};

void TestRotorCounts::rings_data() {
  QTest::addColumn<int>("rotors");
  QTest::addColumn<bool>("cross");
  for (const int n : {4, 6, 8}) {
    QTest::addRow("plus, %d", n) << n << false;
    QTest::addRow("cross, %d", n) << n << true;
  }
}

/// The first rotor ahead, or the nose between the two front ones; counter-clockwise from there at
/// equal angles, neighbours turning oppositely.
void TestRotorCounts::rings() {
  QFETCH(int, rotors);
  QFETCH(bool, cross);
  const RotorLayout layout =
      cross ? RotorLayout(CrossLayout{.count = ringOf(rotors), .arm = 0.3, .height = 0.1})
            : RotorLayout(PlusLayout{.count = ringOf(rotors), .arm = 0.3, .height = 0.1});
  QCOMPARE(rotorCount(layout), rotors);
  const auto places = placeRotors(layout);
  QCOMPARE(static_cast<int>(places.size()), rotors);
  Vector3d sum = Vector3d::Zero();
  double spins = 0;
  for (int i = 0; i < rotors; ++i) {
    const auto& place = places[static_cast<std::size_t>(i)];
    const double angle = 2 * std::numbers::pi * (i + (cross ? 0.5 : 0)) / rotors;
    const Vector3d expected(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.1);
    QVERIFY((place.position - expected).norm() < 1e-15);
    QCOMPARE(spinSign(place.spin), i % 2 == 0 ? 1.0 : -1.0);
    sum += place.position;
    spins += spinSign(place.spin);
  }
  QVERIFY(sum.head<2>().norm() < 1e-14);
  QCOMPARE(spins, 0.0);
  // Of a cross the first and the last rotor are the front ones, as far to each side.
  if (cross) QVERIFY(std::abs(places.front().position.y() + places.back().position.y()) < 1e-15);
}

/// Whatever is lopsided: speeds and attitude are found at which nothing accelerates or turns.
void TestRotorCounts::hoverIsAnEquilibrium() {
  QFETCH(int, rotors);
  withRotorCount(rotors, [](auto count) {
    using Plant = Multirotor<count>;
    using L = typename Plant::Layout;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Plant plant(buildMultirotor<count>(lopsided(count, seed), {}));
      const Trim hover = hoverToStartIn(plant.constants());
      QVERIFY(hover.tilt() > 1e-4);  // these rotors pull aside
      FlightStart start;
      start.attitude = {hover.roll, hover.pitch, 0};
      const auto y = plant.initialState(start, hover.speeds.template head<count>());
      Plant held = plant;
      held.setCommand(y.template segment<count>(L::kDuty));
      typename Plant::State rate;
      held(0, y, rate);
      QVERIFY(rate.template segment<3>(L::kVelocity).norm() < 1e-10);
      QVERIFY(rate.template segment<3>(L::kMomentum).norm() < 1e-10);
      QVERIFY(rate.template segment<count>(L::kSpeed).norm() < 1e-7);
    }
  });
}

/// The derivatives that come with the equations against central differences.
void TestRotorCounts::slopesAreDifferences() {
  QFETCH(int, rotors);
  withRotorCount(rotors, [](auto count) {
    using Plant = Multirotor<count>;
    constexpr int kStates = Plant::kStates;
    EnvironmentParameters windy;
    windy.air = StandardAir{.elevation = 1500};
    windy.wind = LogarithmicWind{.velocity = {6, -2}};
    const Plant plant(buildMultirotor<count>(lopsided(count, 5), windy));
    const auto y = someMotion(plant);
    const typename Plant::Command u = Plant::Command::Constant(0.6);
    const auto rates = [&](const typename Plant::State& at) {
      typename Plant::State rate;
      plant.template derivative<double>(0, u, at, rate);
      return rate;
    };
    for (int k = 0; k < kStates; ++k) {
      typename Plant::template StateOf<Dual> seeded = y.template cast<Dual>(), exact;
      seeded[k] = Dual(y[k], 1);
      plant.template derivative<Dual>(0, u.template cast<Dual>().eval(), seeded, exact);
      const double step = 1e-5 * std::max(1.0, std::abs(y[k]));
      typename Plant::State up = y, down = y;
      up[k] += step;
      down[k] -= step;
      const typename Plant::State slope = (rates(up) - rates(down)) / (2 * step);
      for (int i = 0; i < kStates; ++i) {
        const double scale = std::max({1.0, std::abs(slope[i]), 1e-3 * std::abs(exact[i].value())});
        QVERIFY2(std::abs(exact[i].slope() - slope[i]) < 1e-5 * scale,
                 qPrintable(QStringLiteral("d %1 / d %2: %3, %4")
                                .arg(i)
                                .arg(k)
                                .arg(exact[i].slope())
                                .arg(slope[i])));
      }
    }
  });
}

/// Galilei: the flight in a steady wind is the flight in still air, seen by who moves with the air.
void TestRotorCounts::steadyWindIsAMovingFrame() {
  QFETCH(int, rotors);
  withRotorCount(rotors, [](auto count) {
    using Plant = Multirotor<count>;
    using L = typename Plant::Layout;
    const Vector3d wind(4, -7, 1.5);
    EnvironmentParameters windy;
    windy.wind = SteadyWind{wind};
    const VehicleParameters v = lopsided(count, 7);
    Plant inWind(buildMultirotor<count>(v, windy)), inStill(buildMultirotor<count>(v, {}));
    auto y = someMotion(inWind);
    auto still = y;
    still.template segment<3>(L::kVelocity) -= wind;
    const typename Plant::Command duties = Plant::Command::LinSpaced(0.5, 0.7);
    inWind.setCommand(duties, y);
    inStill.setCommand(duties, still);
    constexpr double kStep = 1e-4;
    constexpr int kSteps = 10000;
    for (int k = 0; k < kSteps; ++k) {
      plainRk4(inWind, kStep, y);
      plainRk4(inStill, kStep, still);
    }
    still.template segment<3>(L::kVelocity) += wind;
    still.template segment<3>(L::kPosition) += kSteps * kStep * wind;
    for (int i = 0; i < Plant::kStates; ++i) {
      QVERIFY2(std::abs(y[i] - still[i]) < 1e-10 * std::max(1.0, std::abs(y[i])),
               Plant::componentName(i).c_str());
    }
    // It was a wind to be noticed.
    QVERIFY(
        (y.template segment<3>(L::kVelocity) - someMotion(inWind).template segment<3>(L::kVelocity))
            .norm() > 1);
  });
}

void TestRotorCounts::otherCountsAreRefused() {
  for (const int n : {3, 5, 7, 9}) {
    try {
      withRotorCount(n, [](auto) { QFAIL("was taken"); });
      QFAIL("no error");
    } catch (const InputError& error) {
      QVERIFY(error.problems().front().message().find("4, 6 or 8") != std::string::npos);
    }
  }
  VehicleParameters v;
  FreeLayout five;
  five.rotors.emplace_back();
  v.layout = five;
  const auto problems = schema::validate(schema::ref(std::as_const(v)));
  QVERIFY(!problems.empty());
  QCOMPARE(problems.front().path, std::string("layout.rotors"));
}

QTEST_APPLESS_MAIN(TestRotorCounts)
#include "test_rotor_counts.moc"
