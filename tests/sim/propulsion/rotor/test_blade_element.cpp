#include <QtTest>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/propulsion/rotor/blade_element.h"
#include "sim/propulsion/rotor/momentum_inflow.h"
#include "tests/validation/uiuc_data.h"

using namespace rotorbench;
using Eigen::Vector3d;
using uiuc::propeller;

namespace {

constexpr AirState kAir{1.18, 1.83e-5};

double omegaOf(double rpm) {
  return rpm * M_PI / 30;
}

constexpr BladeElementSettings kReferenceSettings{24, 0.8, 12};

/// The constants an independent implementation of the same equations was run with.
SectionConstants referenceConstants() {
  SectionConstants c;
  c.liftSlope = 6.28, c.liftSlopeReynolds = 0.05;
  c.zeroLift = -0.058, c.zeroLiftReynolds = -0.0125, c.zeroLiftChord = 0.27;
  c.slowFlyerCamber = 0.05;
  c.stallLift = 1.63, c.stallLiftReynolds = 0.15, c.negativeStallLift = 0.85;
  c.stallWidth = 0.055, c.stallDelay = 6, c.stallDelayLimit = 0.95, c.stallDelayFade = 0.6;
  c.profileDrag = 0.0175, c.profileDragReynolds = -0.25, c.separatedDragFactor = 7.5,
  c.broadside = 2;
  return c;
}

/// Straight lift 2 pi a without camber, Reynolds number or drag: what closed forms are made for.
SectionConstants idealSection() {
  SectionConstants c;
  c.liftSlope = 2 * M_PI;
  c.zeroLift = c.zeroLiftReynolds = c.zeroLiftChord = c.liftSlopeReynolds = 0;
  c.stallLift = c.negativeStallLift = 5;
  c.profileDrag = 0;
  return c;
}

/// The reference took the printed pitch with a weight of one half, the program takes it with 0.41:
/// the rest as an offset.
PropellerGeometry withReferenceBlend(PropellerGeometry g) {
  g.twistOffset = -(0.5 / 0.41 - 1) * nominalPitchBlend(g);
  return g;
}

PropellerGeometry withSection(PropellerGeometry g, const SectionConstants& constants) {
  g.sections = {{0, AnalyticSection{constants}}};
  return g;
}

bool near(double value, double expected, double relative) {
  const bool close = std::abs(value - expected) <= relative * std::abs(expected);
  if (!close) qWarning("%.10g is not %.10g", value, expected);
  return close;
}

}  // namespace

class TestBladeElement : public QObject {
  Q_OBJECT
 private slots:
  void agreesWithReference_data();
  void agreesWithReference();
  void standingStillInWind();
  void inducedVelocityFollowsMomentumTheory();
  void inducedVelocityIsSmoothThroughTheVortexRing();
  void lightlyLoadedRotorMeetsClosedForm();
  void distributionAddsUp();
  void powerIsNeverWonFromNothing();
  void figureOfMeritStaysBelowOne();
  void elementsConverge();
  void nothingIsNotANumber();
  void noSpeedAndNoAirGiveNoLoad();
  void turningBackwardsIsTurningOver();
  void loadsPassSmoothlyThroughStandstill();
  void descentIsFlagged();
  void warmStartChangesNothing();
  void obliqueFlowWithoutInPlaneSpeedIsAxial();
  void levelFlightLiftsAndDrags();
  void loadTurnsWithTheRotor();
  void otherSpinIsTheMirrorImage();
  void sectionsMayChangeAlongTheBlade();
  void settingsAreChecked();
};

/// Volume 1, 10 x 4.7 slow flyer and 10 x 5 of APC, air of 1.18 kg/m^3 and 1.83e-5 Pa s.
void TestBladeElement::agreesWithReference_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("rpm");
  QTest::addColumn<double>("advance");
  QTest::addColumn<double>("thrust");
  QTest::addColumn<double>("power");
  QTest::addRow("hover") << "apcsf_10x4.7" << 4800.0 << 0.0 << 0.11121 << 0.04659;
  QTest::addRow("climb") << "apcsf_10x4.7" << 4800.0 << 0.3 << 0.07018 << 0.04093;
  QTest::addRow("fast climb") << "apcsf_10x4.7" << 4800.0 << 0.6 << 0.01195 << 0.01781;
  QTest::addRow("windmill") << "apcsf_10x4.7" << 4800.0 << 0.9 << -0.06163 << -0.02563;
  QTest::addRow("descent") << "apcsf_10x4.7" << 4800.0 << -0.3 << 0.13666 << 0.04471;
  QTest::addRow("slow") << "apcsf_10x4.7" << 2400.0 << 0.0 << 0.10440 << 0.04537;
  QTest::addRow("another line") << "apce_10x5" << 6000.0 << 0.0 << 0.08813 << 0.03469;
}

void TestBladeElement::agreesWithReference() {
  QFETCH(QString, name);
  QFETCH(double, rpm);
  QFETCH(double, advance);
  const PropellerGeometry g =
      withSection(withReferenceBlend(propeller(name)), referenceConstants());
  const double n = rpm / 60, d = g.diameter;
  const AxialLoad load =
      BladeElementRotor(g, kReferenceSettings).axial(omegaOf(rpm), advance * n * d, kAir);
  const double scale = kAir.density * n * n * std::pow(d, 4);
  QTEST(std::round(load.thrust / scale * 1e5) / 1e5, "thrust");
  QTEST(std::round(load.torque * 2 * M_PI / (scale * d) * 1e5) / 1e5, "power");
}

/// The reference cuts the Reynolds number off at 5000, where we round the corner: 1e-4 N.
void TestBladeElement::standingStillInWind() {
  const BladeElementRotor rotor(
      withSection(withReferenceBlend(propeller("apcsf_10x4.7")), referenceConstants()),
      kReferenceSettings);
  const AxialLoad load = rotor.axial(0, 10, kAir);
  QVERIFY(std::abs(load.thrust + 0.59359) < 1e-4);
  QVERIFY(std::abs(load.torque + 0.009551) < 2e-6);
}

/// v (V + v) = h in climb, v (V + v) = -h in the windmill brake state, v sqrt(Vi^2 + (V + v)^2) = h
/// (Glauert).
void TestBladeElement::inducedVelocityFollowsMomentumTheory() {
  for (double axial : {-1.0, 0.0, 0.3, 5.0, 1e4}) {
    const double v = axialInducedVelocity(4, axial);
    QVERIFY(near(v * (axial + v), 4, 1e-12));
    for (double inPlane : {0.1, 1.0, 30.0}) {
      const double w = inducedVelocity(4, axial, inPlane);
      QVERIFY(near(w * std::hypot(inPlane, axial + w), 4, 1e-10));
    }
  }
  for (double axial : {-5.0, -7.0, -300.0}) {
    const double v = axialInducedVelocity(4, axial);
    QVERIFY(near(v * (axial + v), -4, 1e-12));
    const double w = inducedVelocity(4, axial, 3);
    QVERIFY(near(w * std::hypot(3, axial + w), 4, 1e-10));
  }
  QCOMPARE(axialInducedVelocity(-4, 5), -axialInducedVelocity(4, -5));
}

void TestBladeElement::inducedVelocityIsSmoothThroughTheVortexRing() {
  constexpr double kStep = 1e-6;
  for (double inPlane : {0.0, 0.2, 2.0}) {
    for (double axial = -4; axial < 1; axial += 0.01) {
      const double a = inducedVelocity(1, axial, inPlane);
      const double b = inducedVelocity(1, axial + kStep, inPlane);
      QVERIFY(a > 0 && a < 2.2);
      QVERIFY(std::abs(b - a) < 5 * kStep);
    }
    for (double end : {-1.5, -2.5}) {  // slopes meet
      const auto slope = [&](double from) {
        return (inducedVelocity(1, from + kStep, inPlane) - inducedVelocity(1, from, inPlane)) /
               kStep;
      };
      QVERIFY(std::abs(slope(end) - slope(end - kStep)) < 1e-3);
    }
  }
}

/// Inflow ratio of the blade-element-momentum theory in hover without tip loss, swirl and drag,
/// Leishman (3.61): lambda = sigma a/16 (sqrt(1 + 32 theta r/(sigma a)) - 1), a the lift slope.
void TestBladeElement::lightlyLoadedRotorMeetsClosedForm() {
  PropellerGeometry g;
  g.blades = 12;
  g.pitch = 0;
  g.line = BladeLine::Standard;
  g.stations = {{0, 0.01, 0.06}, {1, 0.01, 0.06}};
  BladeElementSettings settings;
  settings.elements = 60;
  settings.momentumFactor = 1;
  const BladeElementRotor rotor(withSection(g, idealSection()), settings);
  std::vector<ElementLoad> elements(60);
  const double omega = 400, tip = omega * rotor.radius();
  static_cast<void>(rotor.axial(omega, 0, kAir, nullptr, elements));
  const double solidity = 12 * 0.01 / M_PI, a = 2 * M_PI;
  for (const ElementLoad& e : elements) {
    if (e.radius < 0.3 || e.radius > 0.6) continue;  // tip loss and swirl are small there
    const double lambda =
        solidity * a / 16 * (std::sqrt(1 + 32 * 0.06 * e.radius / (solidity * a)) - 1);
    QVERIFY(near(e.inducedVelocity / tip, lambda, 0.01));
  }
}

void TestBladeElement::distributionAddsUp() {
  const PropellerGeometry g = propeller("apce_10x5");
  const BladeElementRotor rotor(g);
  std::vector<ElementLoad> elements(static_cast<std::size_t>(rotor.elements()));
  const AxialLoad load = rotor.axial(600, 5, kAir, nullptr, elements);
  const double width = rotor.radius() * (1 - g.rootRadius) / rotor.elements();
  double thrust = 0, torque = 0;
  for (const ElementLoad& e : elements) {
    thrust += e.thrustPerRadius * width;
    torque += e.torquePerRadius * width;
    QVERIFY(near(std::tan(e.inflowAngle) * (600 * e.radius * rotor.radius() - e.swirl),
                 5 + e.inducedVelocity, 1e-9));
  }
  QVERIFY(near(thrust, load.thrust, 1e-12) && near(torque, load.torque, 1e-12));
}

/// Shaft power covers useful and induced power, thrust times (V + v), of every annulus whose thrust
/// is positive; the rest is swirl and profile drag.
void TestBladeElement::powerIsNeverWonFromNothing() {
  for (const char* name : {"apcsf_10x4.7", "apce_10x5", "gwsdd_9x5", "apce_17x12"}) {
    const BladeElementRotor rotor(propeller(name));
    std::vector<ElementLoad> elements(static_cast<std::size_t>(rotor.elements()));
    for (double omega : {100.0, 400.0, 900.0}) {
      for (double advance = 0; advance < 1.5; advance += 0.05) {
        const double axial = advance * omega / (2 * M_PI) * 2 * rotor.radius();
        static_cast<void>(rotor.axial(omega, axial, kAir, nullptr, elements));
        for (const ElementLoad& e : elements) {
          const double spent = e.torquePerRadius * omega;
          const double used = e.thrustPerRadius * (axial + e.inducedVelocity);
          QVERIFY(spent >= used - 1e-9 * std::abs(used));
        }
      }
    }
  }
}

/// T sqrt(T/(2 rho A)) is the least power that hovers with thrust T.
void TestBladeElement::figureOfMeritStaysBelowOne() {
  int seen = 0;
  for (const auto& set : uiuc::sets()) {
    const BladeElementRotor rotor(set.geometry);
    const double area = M_PI * rotor.radius() * rotor.radius();
    for (double rpm : {1500.0, 6000.0, 20000.0}) {
      const AxialLoad load = rotor.axial(omegaOf(rpm), 0, kAir);
      const double ideal = load.thrust * std::sqrt(load.thrust / (2 * kAir.density * area));
      const double merit = ideal / (load.torque * omegaOf(rpm));
      QVERIFY2(merit > 0.15 && merit < 0.9,
               qPrintable(QString("%1 %2").arg(set.propeller.c_str()).arg(merit)));
      ++seen;
    }
  }
  QCOMPARE(seen, 303);
}

void TestBladeElement::elementsConverge() {
  const PropellerGeometry g = propeller("apcsf_10x4.7");
  const auto thrust = [&](int elements) {
    return BladeElementRotor(g, {elements, 0.8, 12}).axial(500, 0, kAir).thrust;
  };
  const double fine = thrust(200);
  QVERIFY(near(thrust(24), fine, 3e-3));
  QVERIFY(near(thrust(48), fine, 1e-3));
  QVERIFY(std::abs(thrust(96) - fine) < std::abs(thrust(24) - fine));
}

void TestBladeElement::nothingIsNotANumber() {
  int solves = 0;
  for (const char* name : {"apcsf_10x4.7", "apce_10x5", "gwsdd_9x5", "gwssf_10x8"}) {
    const BladeElementRotor rotor(propeller(name));
    const double d = 2 * rotor.radius();
    for (double n : {-120.0, -1.0, 1e-6, 0.1, 10.0, 60.0, 250.0}) {
      for (double advance = -2; advance <= 2; advance += 0.02) {
        const double axial = advance * std::abs(n) * d;
        const AxialLoad load = rotor.axial(2 * M_PI * n, axial, kAir);
        QVERIFY(std::isfinite(load.thrust) && std::isfinite(load.torque));
        QVERIFY(load.vortexRingShare >= 0 && load.vortexRingShare <= 1);
        // No more than the force of a disc that stops the air of the fastest section.
        const double speed = std::hypot(axial, M_PI * n * d);
        const double most = 4 * kAir.density * speed * speed * d * d;
        QVERIFY(std::abs(load.thrust) <= most && std::abs(load.torque) <= most * d);
        ++solves;
      }
      for (double inPlane : {1e-8, 0.5, 3.0}) {
        for (double advance : {-2.0, -0.7, -0.2, 0.0, 0.4, 2.0}) {
          const auto load =
              rotor.load(2 * M_PI * n, Vector3d(inPlane, 0.3, advance) * std::abs(n) * d,
                         Vector3d::UnitZ(), 1, kAir);
          QVERIFY(load.force.allFinite() && load.moment.allFinite());
        }
      }
    }
  }
  QVERIFY(solves > 5000);
}

void TestBladeElement::noSpeedAndNoAirGiveNoLoad() {
  const BladeElementRotor rotor({});
  const AxialLoad still = rotor.axial(0, 0, kAir);
  QVERIFY(still.thrust == 0 && still.torque == 0);
  const AxialLoad vacuum = rotor.axial(500, 3, {0, 1.8e-5});
  QVERIFY(vacuum.thrust == 0 && vacuum.torque == 0);
  const auto load = rotor.load(0, Vector3d::Zero(), Vector3d::UnitZ(), 1, kAir);
  QVERIFY(load.force.isZero(0) && load.moment.isZero(0));
  const auto oblique = rotor.load(500, {3, 2, 1}, Vector3d::UnitZ(), 1, {0, 1.8e-5});
  QVERIFY(oblique.force.isZero(0) && oblique.moment.isZero(0));
}

void TestBladeElement::turningBackwardsIsTurningOver() {
  const BladeElementRotor rotor({});
  const AxialLoad back = rotor.axial(-400, 2, kAir), front = rotor.axial(400, -2, kAir);
  QCOMPARE(back.thrust, -front.thrust);
  QCOMPARE(back.torque, -front.torque);
  const Vector3d v(3, -1, 2), z = Vector3d::UnitZ();
  const auto a = rotor.load(-400, v, z, 1, kAir), b = rotor.load(400, v, -z, 1, kAir);
  QVERIFY((a.force - b.force).norm() < 1e-12 && (a.moment - b.moment).norm() < 1e-12);
  QCOMPARE(a.thrust, -b.thrust);
}

/// Nearly: swirl, which grows with the root of the induction, is nothing at a standstill and 2 % of
/// the torque beside it.
void TestBladeElement::loadsPassSmoothlyThroughStandstill() {
  const BladeElementRotor rotor({});
  for (double axial : {-8.0, 8.0}) {
    const AxialLoad a = rotor.axial(-0.01, axial, kAir), b = rotor.axial(0.01, axial, kAir);
    QVERIFY(near(a.thrust, b.thrust, 0.02));
    QVERIFY(near(a.torque, b.torque, 0.03));
  }
}

void TestBladeElement::descentIsFlagged() {
  const BladeElementRotor rotor({});
  const double hover = std::sqrt(rotor.axial(500, 0, kAir).thrust /
                                 (2 * kAir.density * M_PI * rotor.radius() * rotor.radius()));
  QCOMPARE(rotor.axial(500, 0, kAir).vortexRingShare, 0.0);
  QCOMPARE(rotor.axial(500, hover, kAir).vortexRingShare, 0.0);
  QVERIFY(rotor.axial(500, -hover, kAir).vortexRingShare > 0.8);
  QVERIFY(rotor.axial(500, -8 * hover, kAir).vortexRingShare < 0.1);
}

void TestBladeElement::warmStartChangesNothing() {
  const BladeElementRotor rotor(propeller("apce_10x5"));
  InflowMemory memory;
  for (int i = 0; i < 2000; ++i) {
    const double omega = 400 + 300 * std::sin(0.01 * i), axial = 12 * std::sin(0.017 * i);
    const AxialLoad warm = rotor.axial(omega, axial, kAir, &memory);
    const AxialLoad cold = rotor.axial(omega, axial, kAir);
    QVERIFY(std::abs(warm.thrust - cold.thrust) < 1e-7);
    QVERIFY(std::abs(warm.torque - cold.torque) < 1e-8);
  }
}

void TestBladeElement::obliqueFlowWithoutInPlaneSpeedIsAxial() {
  const BladeElementRotor rotor(propeller("apce_10x5"));
  for (double axial : {-6.0, -1.0, 0.0, 4.0, 20.0}) {
    const AxialLoad a = rotor.axial(500, axial, kAir);
    const ObliqueLoad o = rotor.oblique(500, axial, 0, kAir);
    QVERIFY(near(o.thrust, a.thrust, 1e-8) && near(o.torque, a.torque, 1e-8));
    QVERIFY(std::abs(o.drag) < 1e-12 && std::abs(o.rollMoment) < 1e-12);
  }
}

/// Translational lift, H-force against the motion and more lift on the advancing side (Leishman,
/// ch. 3 and 4).
void TestBladeElement::levelFlightLiftsAndDrags() {
  const BladeElementRotor rotor({});
  const double hover = rotor.axial(500, 0, kAir).thrust;
  double drag = 0, roll = 0;
  for (double speed : {2.0, 5.0, 10.0}) {
    const ObliqueLoad o = rotor.oblique(500, 0, speed, kAir);
    QVERIFY(o.thrust > hover);
    QVERIFY(o.drag > drag && o.drag < 0.3 * o.thrust);
    QVERIFY(o.rollMoment < roll);  // the advancing side is at -e2
    drag = o.drag, roll = o.rollMoment;
  }
  const BladeElementRotor fine({}, {.azimuths = 72});
  const ObliqueLoad a = rotor.oblique(500, 1, 8, kAir), b = fine.oblique(500, 1, 8, kAir);
  QVERIFY(near(a.thrust, b.thrust, 5e-3) && near(a.drag, b.drag, 2e-2));
}

void TestBladeElement::loadTurnsWithTheRotor() {
  const BladeElementRotor rotor({});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3d v(3, -4, 2), z = Vector3d::UnitZ();
  const auto a = rotor.load(500, v, z, 1, kAir);
  const auto b = rotor.load(500, turn * v, turn * z, 1, kAir);
  QVERIFY((b.force - turn * a.force).norm() < 1e-9);
  QVERIFY((b.moment - turn * a.moment).norm() < 1e-9);
  QVERIFY(a.force.head<2>().dot(v.head<2>()) < 0);  // drag
  QVERIFY(a.moment[2] < 0 && near(-a.moment[2], a.torque, 1e-12));
}

/// Mirror at the x-z plane: y of vectors changes sign, x and z of moments do.
void TestBladeElement::otherSpinIsTheMirrorImage() {
  const BladeElementRotor rotor({});
  const Vector3d z = Vector3d::UnitZ();
  const auto a = rotor.load(500, {3, -4, 2}, z, 1, kAir);
  const auto b = rotor.load(500, {3, 4, 2}, z, -1, kAir);
  QVERIFY((b.force - Vector3d(a.force[0], -a.force[1], a.force[2])).norm() < 1e-9);
  QVERIFY((b.moment - Vector3d(-a.moment[0], a.moment[1], -a.moment[2])).norm() < 1e-9);
}

void TestBladeElement::sectionsMayChangeAlongTheBlade() {
  const PropellerGeometry plain;
  PropellerGeometry g;
  g.sections = {{0.2, AnalyticSection{}}, {0.6, AnalyticSection{}}, {1, AnalyticSection{}}};
  const double whole = BladeElementRotor(plain).axial(500, 2, kAir).thrust;
  QVERIFY(near(BladeElementRotor(g).axial(500, 2, kAir).thrust, whole, 1e-8));
  SectionConstants cambered;
  cambered.zeroLift -= 0.05;
  g.sections = {{0.2, AnalyticSection{}}, {1, AnalyticSection{cambered}}};
  const double mixed = BladeElementRotor(g).axial(500, 2, kAir).thrust;
  g.sections = {{0.2, AnalyticSection{cambered}}};
  const double tip = BladeElementRotor(g).axial(500, 2, kAir).thrust;
  QVERIFY(mixed > 1.02 * whole && mixed < 0.99 * tip);
  g.sections = {{0.2, AnalyticSection{}}, {0.7, PolarSection{}}};
  QVERIFY(BladeElementRotor(g).axial(500, 2, kAir).thrust > 0);
}

void TestBladeElement::settingsAreChecked() {
  BladeElementSettings s;
  QVERIFY(schema::validate(schema::ref(s)).empty());
  s.elements = 1000;
  QCOMPARE(schema::validate(schema::ref(s)).size(), std::size_t(1));
}

QTEST_GUILESS_MAIN(TestBladeElement)
#include "test_blade_element.moc"
