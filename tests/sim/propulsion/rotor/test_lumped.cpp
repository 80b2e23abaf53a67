// Lumped rotors: lift that is paid for, and coefficients that stand for another model.
#include <QTest>
#include <cmath>

#include "sim/core/error.h"
#include "sim/propulsion/rotor/lumped_equivalent.h"
#include "sim/propulsion/rotor/rotor.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

/// The AscTec Hummingbird's rotor as RotorPy has it.
RotorCoefficients hummingbird() {
  RotorCoefficients c;
  c.thrust = 5.57e-6;
  c.torque = 1.36e-7;
  c.inflow = {1.19e-4, 2.32e-4, 3.39e-3, 0};
  c.diameter = 0.2;
  return c;
}

RotorLoad<double> loadOf(const RotorCoefficients& c, double w, const Vector3d& v,
                         double density = 1.225) {
  const RotorModel<double> model = lumpedModel(c);
  return model.load<double>(w, v, Vector3d(0, 0, 1), 1.0, density);
}

double near(double value, double expected) {
  return std::abs(value / expected - 1);
}

}  // namespace

class TestLumped : public QObject {
  Q_OBJECT
 private slots:
  /// RotorPy's form is kept where the coefficients were found: torque k_m w^2 to the last bit.
  void liftAsPublished() {
    const RotorCoefficients c = hummingbird();
    for (const double speed : {0.0, 2.0, 5.0, 10.0, 15.0}) {
      const RotorLoad<double> l = loadOf(c, 500, {speed, 0, 0});
      QVERIFY(near(l.thrust, 5.57e-6 * 250000 + 3.39e-3 * speed * speed) < 1e-14);
      QVERIFY(near(l.torque, 1.36e-7 * 250000) < 1e-14);
    }
  }

  /// At 40 m/s this lift makes the thrust five times that at rest. An ideal rotor takes T v_i for
  /// it, v_i (v_i^2 + v^2)^1/2 = T/(2 rho A), and T_0 (T_0/2 rho A)^1/2 at rest: the rest of the
  /// torque, friction of the blades, stays.
  void liftIsNoFreePower() {
    const RotorCoefficients c = hummingbird();
    const double w = 500, area = M_PI * 0.01, speed = 40;
    const RotorLoad<double> l = loadOf(c, w, {0, speed, 0});
    double induced = 0;
    for (int k = 0; k < 100; ++k)
      induced = l.thrust / (2 * 1.225 * area * std::hypot(induced, speed));
    const double rest = c.thrust * w * w, hover = rest * std::sqrt(rest / (2 * 1.225 * area));
    QVERIFY(l.thrust > 4 * rest && l.torque > 1.5 * c.torque * w * w);
    QVERIFY(near(l.torque * w - c.torque * w * w * w, l.thrust * induced - hover) < 1e-5);
    // It begins without a jump, and a rotor without such lift never pays.
    RotorCoefficients none = c;
    none.inflow.translationalLift = 0;
    double before = c.torque * w * w;
    for (double v = 0; v < 60; v += 0.05) {
      const double torque = loadOf(c, w, {v, 0, 0}).torque;
      QVERIFY(torque - before < 0.01 * c.torque * w * w && torque >= before);
      before = torque;
      QCOMPARE(loadOf(none, w, {v, 0, 0}).torque, c.torque * w * w);
    }
  }

  /// Rotors side by side are each as one alone, whichever of them lift.
  void lanesAreEachAsOneAlone() {
    using Lanes = Eigen::Array<double, 4, 1>;
    RotorCoefficients all[4] = {hummingbird(), hummingbird(), hummingbird(), hummingbird()};
    all[1].inflow.translationalLift = 0;
    all[2].inflow.translationalLift = 9e-3;
    RotorModel<Lanes> lanes;
    for (int i = 0; i < 4; ++i) {
      const RotorModel<double> one = lumpedModel(all[i]);
      lanes.thrust[i] = one.thrust;
      lanes.torque[i] = one.torque;
      lanes.drag[i] = one.drag;
      lanes.inflow[i] = one.inflow;
      lanes.lift[i] = one.lift;
      lanes.flapping[i] = one.flapping;
      lanes.discs[i] = one.discs;
      lanes.lifting = lanes.lifting || one.lifting;
    }
    const Lanes w(500, 510, 20, 0), zero = Lanes::Zero(), one = Lanes::Ones();
    const std::array<Lanes, 3> v{Lanes(35, 35, 20, 30), zero, Lanes(1, -1, 0, 0)},
        axis{zero, zero, one};
    const auto l = lanes.load<Lanes>(w, v, axis, one, 1.1);
    for (int i = 0; i < 4; ++i) {
      const RotorLoad<double> alone = loadOf(all[i], w[i], {v[0][i], 0, v[2][i]}, 1.1);
      QCOMPARE(l.thrust[i], alone.thrust);
      QCOMPARE(l.torque[i], alone.torque);
      QVERIFY(std::isfinite(l.torque[i]));
    }
  }

  /// A lumped rotor stands for itself.
  void lumpedGivesItselfBack() {
    PropellerCoefficients p;
    p.inflow = {1e-4, 2e-4, 3e-3, -1e-5};
    const LumpingRange range{520, 1.1, 8, 2};
    const LumpedEquivalent e = lumpedEquivalent(p, range);
    const double thin = 1.1 / 1.225;
    QVERIFY(near(e.coefficients.thrust, lumpedModel(p).thrust * 1.1) < 1e-13);
    QVERIFY(near(e.coefficients.torque, lumpedModel(p).torque * 1.1) < 1e-13);
    QVERIFY(near(e.coefficients.inflow.drag, 1e-4 * thin) < 1e-10);
    QVERIFY(near(e.coefficients.inflow.inflow, 2e-4 * thin) < 1e-10);
    QVERIFY(near(e.coefficients.inflow.translationalLift, 3e-3 * thin) < 1e-10);
    QVERIFY(near(e.coefficients.inflow.flapping, -1e-5 * thin) < 1e-10);
    QCOMPARE(e.coefficients.diameter, p.diameter);
    QCOMPARE(e.coefficients.referenceDensity, 1.1);
    const LumpingErrors& off = e.errors;
    for (const double error : {off.thrust, off.torque, off.inPlane, off.pitch, off.side, off.roll})
      QVERIFY(error < 1e-12);
  }

  /// Blade elements: at rest the loads themselves; in a slow climb the slope of the thrust; to the
  /// front the lift, against the stream the drag, and blades that are pitched up by the skew.
  void bladeElementsAreMet() {
    const BladeElementPropeller p;
    const LumpingRange range = lumpingRange(p, 520, 1.225);
    const LumpedEquivalent e = lumpedEquivalent(p, range);
    const RotorCoefficients& c = e.coefficients;
    const BladeElementRotor rotor(p.propeller, p.settings);
    const AirState air{1.225, kAirViscosity};
    QVERIFY(near(c.thrust * 520 * 520, rotor.axial(520, 0, air).thrust) < 1e-12);
    QVERIFY(near(c.torque * 520 * 520, rotor.axial(520, 0, air).torque) < 1e-12);
    const double slope =
        (rotor.axial(520, -1, air).thrust - rotor.axial(520, 1, air).thrust) / (2 * 520);
    // Over all of the range, in a stream from the side too: near the slope at rest, not it.
    QVERIFY2(near(c.inflow.inflow, slope) < 0.25,
             qPrintable(QString::number(c.inflow.inflow / slope)));
    QVERIFY(c.inflow.drag > 0 && c.inflow.translationalLift > 0 && c.inflow.flapping < 0);
    QVERIFY2(e.errors.thrust < 0.02, qPrintable(QString::number(e.errors.thrust)));
    QVERIFY2(e.errors.inPlane < 0.005, qPrintable(QString::number(e.errors.inPlane)));
    // Its own range: a tenth of the tips' speed and 0.4 of the induced velocity.
    QCOMPARE(range.inPlane, 0.1 * 520 * rotor.radius());
    const double area = M_PI * rotor.radius() * rotor.radius();
    QVERIFY(near(range.axial, 0.4 * std::sqrt(rotor.axial(520, 0, air).thrust / (2.45 * area))) <
            1e-12);
  }

  void noThrustIsSaid() {
    BladeElementPropeller p;
    p.propeller.twistOffset = -0.5;
    try {
      lumpedEquivalent(p, {});
      QFAIL("it has no thrust");
    } catch (const InputError& error) {
      QVERIFY(QString(error.what()).contains("no thrust at this speed"));
    }
  }
};

QTEST_GUILESS_MAIN(TestLumped)
#include "test_lumped.moc"
