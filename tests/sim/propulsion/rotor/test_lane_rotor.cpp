// Blade elements several annuli at a time against those one at a time: over all directions of the
// air with some of it from the side, in percent of the static thrust and torque at the same air
// speed. In-plane force and hub moment are taken over the sine of the side angle, as the map holds
// them.
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim/propulsion/rotor/lane_rotor.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;

namespace {

using Errors = std::array<double, 4>;  // thrust, torque, in-plane force, hub moment; %

constexpr double kLeastReynolds = 1e4, kMostReynolds = 1e7;

/// In climb, or in descent, where the vortex ring state is.
Errors worst(const BladeElementRotor& exact, bool descent) {
  constexpr int kStates = 700;
  // Steps of a lattice that fills the cube (M. Roberts, R3).
  constexpr double kSteps[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  constexpr double kLeastSide = 0.01;  // rad, as in the map
  const LaneRotor lanes(exact, kLeastReynolds, kMostReynolds);
  const AirState air{1.1, 1.9e-5};
  const double radius = exact.radius();
  Errors most{};
  for (int i = 1; i <= kStates; ++i) {
    const auto part = [&](int k) { return std::fmod(0.5 + i * kSteps[k], 1.0); };
    const double chi = (descent ? -1 : 1) * part(0) * M_PI / 2;
    const double side = kLeastSide + part(1) * (M_PI / 2 - kLeastSide);
    const double reynolds = kLeastReynolds * std::pow(kMostReynolds / kLeastReynolds, part(2));
    const double speed = reynolds * air.viscosity / (air.density * radius);
    const double rest = speed * std::cos(side), sine = std::sin(side);
    const double w = rest * std::cos(chi) / (0.75 * radius);
    const AxialLoad still = exact.axial(speed / (0.75 * radius), 0, air);
    const ObliqueLoad a = exact.oblique(w, rest * std::sin(chi), speed * sine, air);
    const ObliqueLoad b = lanes.oblique(w, rest * std::sin(chi), speed * sine, air);
    const Errors off{(a.thrust - b.thrust) / still.thrust, (a.torque - b.torque) / still.torque,
                     (a.drag - b.drag) / (sine * still.thrust),
                     (a.rollMoment - b.rollMoment) / (sine * still.thrust * radius)};
    for (std::size_t q = 0; q < most.size(); ++q)
      most[q] = std::max(most[q], 100 * std::abs(off[q]));
  }
  return most;
}

/// Measured polars along half of the blade, blended with the typical section.
PropellerGeometry withPolars() {
  PropellerGeometry g;
  PolarSection polars;
  polars.stallDelay = 3;
  g.sections = {{0.3, AnalyticSection{}}, {0.7, polars}};
  return g;
}

}  // namespace

class TestLaneRotor : public QObject {
  Q_OBJECT
 private slots:
  /// Limits: up to twice what was measured. Where polars end they have kinks, which the finer
  /// table of the polars themselves follows more closely.
  void lanesFollowBladeElements_data() {
    QTest::addColumn<bool>("polars");
    QTest::addColumn<bool>("descent");
    QTest::addColumn<Errors>("limits");
    QTest::addRow("climb") << false << false << Errors{0.05, 0.07, 0.1, 0.05};
    QTest::addRow("descent") << false << true << Errors{0.06, 0.08, 0.2, 0.4};
    QTest::addRow("climb, polars") << true << false << Errors{0.15, 0.7, 1, 1.2};
    QTest::addRow("descent, polars") << true << true << Errors{0.08, 0.15, 0.15, 0.3};
  }
  void lanesFollowBladeElements() {
    QFETCH(bool, polars);
    QFETCH(bool, descent);
    QFETCH(Errors, limits);
    const std::vector<PropellerGeometry> blades =
        polars ? std::vector{withPolars()}
               : std::vector{PropellerGeometry{}, uiuc::propeller("da4052_9x8.95")};
    for (const PropellerGeometry& g : blades) {
      // 22 annuli: the last block has lanes to spare.
      for (const BladeElementSettings& s :
           {BladeElementSettings{}, BladeElementSettings{.elements = 22, .azimuths = 16}}) {
        const Errors e = worst(BladeElementRotor(g, s), descent);
        qInfo("thrust %.4f, torque %.4f, in-plane force %.4f, moment %.4f %%", e[0], e[1], e[2],
              e[3]);
        for (std::size_t q = 0; q < e.size(); ++q) QVERIFY(e[q] <= limits[q]);
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestLaneRotor)
#include "test_lane_rotor.moc"
