// The four rotor models made of one propeller agree; none of them gives nonsense anywhere.
#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/AutoDiff>

#include "sim/propulsion/rotor/rotor.h"
#include "tests/sim/run/quick_map.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double kDensity = 1.225,
                 kHover = 520;  // rad/s: 4 N from the default propeller, a 10 x 4.7

const BladeElementRotor& bladeElements() {
  static const BladeElementRotor rotor{PropellerGeometry{}};
  return rotor;
}

/// The default propeller as a wind tunnel would see it that measures what blade elements compute.
MeasuredPropeller measured() {
  MeasuredPropeller p;
  p.points.clear();
  const double d = 2 * bladeElements().radius();
  for (const double w : {300.0, 450.0, 600.0, 750.0}) {
    for (double advance = -0.1; advance < 0.75; advance += 0.05) {
      const double n = w / (2 * pi);
      const AxialLoad load = bladeElements().axial(w, advance * n * d, {kDensity, kAirViscosity});
      p.points.push_back({w, advance, load.thrust / (kDensity * n * n * std::pow(d, 4)),
                          load.torque * 2 * pi / (kDensity * n * n * std::pow(d, 5))});
    }
  }
  return p;
}

/// Static coefficients about hover, and the loss of thrust in a slow climb.
RotorCoefficients lumped() {
  const AxialLoad still = bladeElements().axial(kHover, 0, {}),
                  climb = bladeElements().axial(kHover, 1, {});
  RotorCoefficients c;
  c.thrust = still.thrust / (kHover * kHover);
  c.torque = still.torque / (kHover * kHover);
  c.inflow = {0, (still.thrust - climb.thrust) / kHover, 0, 0};
  c.diameter = 0.254;
  return c;
}

RotorConstants rotor(const RotorAerodynamics& aerodynamics) {
  RotorParameters p;
  p.aerodynamics = aerodynamics;
  return buildRotor(p);
}

RotorLoad<double> loadOf(const RotorConstants& r, double w, const Vector3d& v,
                         const Vector3d& axis = Vector3d::UnitZ(), double spin = 1,
                         double density = kDensity) {
  if (r.model != nullptr) return r.model->load<double>(w, v, axis, spin, density);
  return r.load<double, Vector3d>(w, v, axis, spin, density);
}

const std::vector<std::pair<const char*, RotorAerodynamics>>& models() {
  static const std::vector<std::pair<const char*, RotorAerodynamics>> all = {
      {"lumped", lumped()},
      {"lumped, CT and CP", PropellerCoefficients{.inflow = {1e-4, 2e-4, 3e-3, 1e-5}}},
      {"measured", measured()},
      {"map", test::quickMap()},
      {"blade-element", BladeElementPropeller{}}};
  return all;
}

void addModels() {
  QTest::addColumn<int>("model");
  for (std::size_t i = 0; i < models().size(); ++i)
    QTest::addRow("%s", models()[i].first) << static_cast<int>(i);
}

RotorConstants fetched() {
  QFETCH(int, model);
  return rotor(models()[static_cast<std::size_t>(model)].second);
}

/// Largest differences between blade elements and map, as parts of static thrust and torque.
struct ObliqueErrors {
  double thrust = 0, torque = 0, inPlane = 0, moment = 0;

  void compare(const BladeElementRotor& exact, const PropellerMap& map, double w, const Vector3d& v,
               const AirState& air, const AxialLoad& still) {
    const auto a = exact.load(w, v, Vector3d::UnitZ(), -1, air);
    const auto b =
        map.load<double, Vector3d>(w, v, Vector3d::UnitZ(), -1, air.density, air.viscosity);
    const double radius = exact.radius();
    thrust = std::max(thrust, std::abs(a.thrust - b.thrust) / still.thrust);
    torque = std::max(torque, std::abs(a.torque - b.torque) / still.torque);
    inPlane = std::max(inPlane, (a.force - b.force).head<2>().norm() / still.thrust);
    moment = std::max(moment, (a.moment - b.moment).head<2>().norm() / (still.thrust * radius));
  }
  /// What the issue asks for: 0.2 % and 1 %. In-plane force and hub moment are held to the thrust's
  /// limit.
  [[nodiscard]] bool small() const {
    qInfo("thrust %.3f %%, torque %.3f %%, in-plane force %.3f %%, moments %.3f %%", 100 * thrust,
          100 * torque, 100 * inPlane, 100 * moment);
    return thrust <= 2e-3 && torque <= 1e-2 && inPlane <= 2e-3 && moment <= 2e-3;
  }
};

/// Rotor speeds about hover, climb and sink, edgewise flight to 20 m/s; static thrust at the same
/// rotor speed.
ObliqueErrors errorsInFlight(const BladeElementRotor& exact, const PropellerMap& map) {
  const AirState air{kDensity, kAirViscosity};
  const double hover = 66 / exact.radius();  // tip speed of the default propeller in hover
  ObliqueErrors e;
  for (const double w : {0.7 * hover, hover, 1.4 * hover}) {
    const AxialLoad still = exact.axial(w, 0, air);
    for (const double axial : {-6.0, -3.3, -1.0, 0.0, 1.7, 4.1}) {
      for (const double side : {0.05, 0.3, 1.0, 2.5, 4.0, 7.0, 11.0, 15.0, 20.0})
        e.compare(exact, map, w, {side * 0.6, side * 0.8, axial}, air, still);
    }
  }
  return e;
}

/// All directions of the air and Reynolds numbers, spread evenly and off the grid: from straight
/// descent to straight climb, from no in-plane speed to nothing else; static thrust at the same air
/// speed. Thin air.
ObliqueErrors errorsEverywhere(const BladeElementRotor& exact, const PropellerMap& map) {
  constexpr int kStates = 2000;
  // Steps of a lattice that fills the cube (M. Roberts, R3: powers of the inverse of 1.2207...,
  // root of x^4 = x + 1).
  constexpr double kSteps[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const AirState air{1.1, 1.9e-5};
  const double radius = exact.radius();
  ObliqueErrors e;
  for (int i = 1; i <= kStates; ++i) {
    const auto part = [&](int k) { return std::fmod(0.5 + i * kSteps[k], 1.0); };
    const double chi = (part(0) - 0.5) * pi, side = part(1) * pi / 2;
    const double speed = 1e4 * std::pow(1e3, part(2)) * air.viscosity / (air.density * radius);
    const double hover = speed / (0.75 * radius), rest = speed * std::cos(side);
    e.compare(exact, map, hover * std::cos(side) * std::cos(chi),
              {speed * std::sin(side), 0, rest * std::sin(chi)}, air, exact.axial(hover, 0, air));
  }
  return e;
}

}  // namespace

class TestRotorModels : public QObject {
  Q_OBJECT
 private slots:
  /// Against blade elements, in percent of the static thrust and torque: hover at +-10 % of its
  /// speed, climb to 3 m/s.
  void modelsAgree_data() {
    QTest::addColumn<int>("model");
    QTest::addColumn<double>("thrust");
    QTest::addColumn<double>("torque");
    QTest::addRow("map") << 3 << 0.2 << 1.0;
    QTest::addRow("measured") << 2 << 0.5 << 1.0;
    QTest::addRow("lumped") << 0 << 2.0 << 3.6;
  }
  void modelsAgree() {
    QFETCH(double, thrust);
    QFETCH(double, torque);
    const RotorConstants r = fetched();
    const AxialLoad still = bladeElements().axial(kHover, 0, {});
    double worstThrust = 0, worstTorque = 0;
    for (const double w : {0.9 * kHover, kHover, 1.1 * kHover}) {
      for (const double climb : {0.0, 1.0, 2.0, 3.0}) {
        const AxialLoad exact = bladeElements().axial(w, climb, {});
        const auto l = loadOf(r, w, {0, 0, climb});
        worstThrust = std::max(worstThrust, 100 * std::abs(l.thrust - exact.thrust) / still.thrust);
        worstTorque = std::max(worstTorque, 100 * std::abs(l.torque - exact.torque) / still.torque);
      }
    }
    qInfo("thrust %.3f %%, torque %.3f %%", worstThrust, worstTorque);
    QVERIFY(worstThrust < thrust && worstTorque < torque);
  }

  /// Map against blade elements with air from the side: in flight, and over the whole map. The one
  /// that came out worst, in the full set also the next; the validation suite has seven.
  void mapFollowsObliqueFlow_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"da4052_9x8.95", "gwsdd_4x2.5"}) {
      QTest::addRow("%s", name) << name;
      if (!test::fullSet()) break;
    }
  }
  void mapFollowsObliqueFlow() {
    QFETCH(QString, name);
    const BladeElementRotor exact(uiuc::propeller(name));
    const PropellerMap map(exact);
    QVERIFY(errorsInFlight(exact, map).small());
    QVERIFY(errorsEverywhere(exact, map).small());
  }
  /// No step in the load where the axial table ends: hover and a breath of wind.
  void sidewindSetsInSmoothly() {
    const RotorConstants r = rotor(test::quickMap());
    for (const double climb : {-2.0, 0.0, 3.0}) {
      const auto still = loadOf(r, kHover, {0, 0, climb});
      double last = 0;
      for (const double side : {1e-9, 1e-6, 1e-3, 0.05}) {
        const auto l = loadOf(r, kHover, {side, 0, climb});
        const double change = (l.force - still.force).norm() / still.thrust;
        QVERIFY(change >= last && change < 1e-2 * side);
        last = change;
      }
    }
  }

  void finiteEverywhere_data() { addModels(); }
  void finiteEverywhere() {
    const RotorConstants r = fetched();
    const Vector3d axis = Vector3d(0.1, -0.2, 1).normalized();
    for (const double w : {-700.0, -1.0, -1e-9, 0.0, 1e-9, 1.0, 700.0}) {
      for (double advance = -2; advance <= 2; advance += 0.25) {
        // J = 2 at 700 rad/s, whatever the speed.
        const double speed = advance * 700 / (2 * pi) * 0.254;
        for (const double side : {0.0, 1e-12, 20.0}) {
          for (const double density : {0.0, kDensity}) {
            const Vector3d v = speed * axis + side * axis.unitOrthogonal();
            const auto l = loadOf(r, w, v, axis, -1, density);
            QVERIFY(l.force.allFinite() && l.moment.allFinite());
            QVERIFY(std::isfinite(l.thrust) && std::isfinite(l.torque));
            if (density == 0) QVERIFY(l.force.isZero() && l.moment.isZero());
          }
        }
      }
    }
  }

  /// The mirror image of a rotor turns the other way: force mirrored, moment mirrored as a
  /// rotation.
  void mirrorSymmetry_data() { addModels(); }
  void mirrorSymmetry() {
    const RotorConstants r = fetched();
    for (const Vector3d& v : {Vector3d(5, 3, 1), Vector3d(0, 8, -2), Vector3d(-2, 0, 3)}) {
      const auto a = loadOf(r, 500, v, Vector3d::UnitZ(), 1);
      const auto b = loadOf(r, 500, {v[0], -v[1], v[2]}, Vector3d::UnitZ(), -1);
      QVERIFY((a.force - Vector3d(b.force[0], -b.force[1], b.force[2])).norm() < 1e-9);
      QVERIFY((a.moment - Vector3d(-b.moment[0], b.moment[1], -b.moment[2])).norm() < 1e-9);
    }
  }

  /// Turned with its axis and the air, the load turns with it.
  void turnsWithTheAxis_data() { addModels(); }
  void turnsWithTheAxis() {
    const RotorConstants r = fetched();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
    const Vector3d v(4, -3, 1.5);
    const auto a = loadOf(r, 480, v), b = loadOf(r, 480, turn * v, turn * Vector3d::UnitZ());
    QVERIFY((turn * a.force - b.force).norm() < 1e-8 && (turn * a.moment - b.moment).norm() < 1e-8);
  }

  /// No rotor hovers on less than the ideal power.
  void figureOfMerit() {
    int count = 0;
    double best = 0;
    for (const auto& set : uiuc::sets()) {
      const BladeElementRotor exact(set.geometry);
      const bool mapped = count++ % 20 == 0;
      std::optional<PropellerMap> map;
      if (mapped)
        map.emplace(exact, PropellerMapSettings{.directions = 121,
                                                .reynoldsNumbers = 8,
                                                .sideDirections = 16,
                                                .sideAngles = 4,
                                                .sideReynoldsNumbers = 4,
                                                .sideRefinements = 0});
      const double area = pi * exact.radius() * exact.radius();
      for (const double tip : {5.0, 20.0, 60.0, 150.0}) {
        const double w = tip / exact.radius();
        const auto merit = [&](double thrust, double torque) {
          return thrust > 0 ? std::pow(thrust, 1.5) / std::sqrt(2 * kDensity * area) / (torque * w)
                            : 0.0;
        };
        const AxialLoad a = exact.axial(w, 0, {});
        best = std::max(best, merit(a.thrust, a.torque));
        if (!mapped) continue;
        const ThrustAndTorque b = map->axial(w, 0, {});
        best = std::max(best, merit(b.thrust, b.torque));
      }
    }
    qInfo("best of %d propellers %.3f", count, best);
    QVERIFY(best < 1 && best > 0.5);
  }

  /// Derivatives of every model over a differentiating scalar against differences.
  void derivatives_data() { addModels(); }
  void derivatives() {
    using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 5, 1>>;
    const RotorConstants r = fetched();
    Eigen::Matrix<double, 5, 1> x;
    x << 510, 4, -2.5, 1.3, 1.2;
    const auto at = [&](const Eigen::Matrix<double, 5, 1>& p) {
      return loadOf(r, p[0], p.segment<3>(1), Vector3d::UnitZ(), 1, p[4]);
    };
    Dual in[5];
    for (int k = 0; k < 5; ++k) in[k] = Dual(x[k], 5, k);
    const Eigen::Matrix<Dual, 3, 1> v(in[1], in[2], in[3]);
    const Vector3d axis = Vector3d::UnitZ();
    const RotorLoad<Dual> exact =
        r.model != nullptr ? r.model->load<Dual>(in[0], v, axis, 1, in[4])
                           : r.load<Dual, Eigen::Matrix<Dual, 3, 1>>(in[0], v, axis, 1, in[4]);
    for (int k = 0; k < 5; ++k) {
      const double h = 1e-5 * std::abs(x[k]);
      auto up = x, down = x;
      up[k] += h, down[k] -= h;
      const auto a = at(up), b = at(down);
      const auto close = [&](const Dual& d, double high, double low) {
        const double slope = (high - low) / (2 * h);
        return std::abs(d.derivatives()[k] - slope) < 2e-4 * std::abs(slope) + 1e-6;
      };
      for (int i = 0; i < 3; ++i) {
        QVERIFY(close(exact.force[i], a.force[i], b.force[i]));
        QVERIFY(close(exact.moment[i], a.moment[i], b.moment[i]));
      }
      QVERIFY(close(exact.thrust, a.thrust, b.thrust) && close(exact.torque, a.torque, b.torque));
    }
    QVERIFY(std::abs(exact.thrust.value() - at(x).thrust) < 1e-12);
  }

  void equalRotorsShareAMap() {
    QVERIFY(rotor(test::quickMap()).model == rotor(test::quickMap()).model);
    MapPropeller other = test::quickMap();
    other.map.directions = 61;
    QVERIFY(rotor(other).model != rotor(test::quickMap()).model);
  }

  void geometryIsThereToDraw() {
    QCOMPARE(rotorRadius(MapPropeller{}), 0.127);
    QCOMPARE(rotorRadius(MeasuredPropeller{}), 0.127);
    QCOMPARE(rotorRadius(RotorCoefficients{.diameter = 0.2032}), 0.1016);
    // Not known: the one with CT = 0.1, (5.57e-6 4 pi^2/(0.1 1.225))^(1/4) = 0.2058 m.
    QVERIFY(std::abs(rotorRadius(RotorCoefficients{.thrust = 5.57e-6}) - 0.1029) < 5e-5);
    QVERIFY(rotorGeometry(PropellerCoefficients{}) == nullptr);
    QCOMPARE(rotorGeometry(BladeElementPropeller{})->stations.size(),
             PropellerGeometry{}.stations.size());
  }
};

QTEST_GUILESS_MAIN(TestRotorModels)
#include "test_rotor_models.moc"
