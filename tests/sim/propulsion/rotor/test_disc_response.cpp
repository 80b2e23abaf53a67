// What skewed inflow and flapping add to rigid blades in an even inflow: against an integration of
// the same linear blade over the azimuth, against textbook results of a teetering rotor, in its
// limits, and in the ledger of its power.
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/propulsion/rotor/blade_element.h"
#include "sim/propulsion/rotor/propeller_map.h"

using namespace rotorbench;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double kDensity = 1.2;

/// A rotor of constant chord c, twist such that c_l = a (beta - phi): lift slope a, no drag.
struct LinearRotor {
  double radius = 0.12, chord = 0.02, slope = 5.5, pitch = 0.2;
  int blades = 2;
  [[nodiscard]] DiscConstants disc() const {
    DiscConstants c;
    c.radius = radius;
    c.area = pi * radius * radius;
    c.flapIntegral = blades * slope * chord * std::pow(radius, 4) / 4;
    c.swayIntegral = blades * slope * chord * radius * radius / 2;
    return c;
  }
};

/// Loads over the azimuth psi from the front, turning towards e2: dL = rho/2 a c (V_t^2 beta -
/// V_t W) dr with W = V + v0 (1 - K r/R cos psi) and a flap rate.
struct Summed {
  double thrust = 0, drag = 0, side = 0, roll = 0, pitch = 0;
};
Summed sum(const LinearRotor& r, double omega, double axial, double across, double v0, double k) {
  Summed s;
  constexpr int kAzimuths = 180, kStations = 400;
  for (int i = 0; i < kAzimuths; ++i) {
    const double psi = 2 * pi * (i + 0.5) / kAzimuths;
    for (int j = 0; j < kStations; ++j) {
      const double x = (j + 0.5) / kStations, y = x * r.radius;
      const double vt = omega * y - across * std::sin(psi);
      const double w = axial + v0 * (1 - k * x * std::cos(psi));
      const double lift = 0.5 * kDensity * r.slope * r.chord * (vt * vt * r.pitch - vt * w) *
                          r.radius / kStations * r.blades / kAzimuths;
      const double against = lift * w / vt;
      s.thrust += lift;
      s.drag -= against * std::sin(psi);
      s.side -= against * std::cos(psi);
      s.roll += lift * y * std::sin(psi);
      s.pitch += lift * y * std::cos(psi);
    }
  }
  return s;
}

EvenLoad<double> evenOf(const Summed& s, double across) {
  return {s.thrust, 0.01, s.drag / across, s.roll / across};
}

}  // namespace

class TestDiscResponse : public QObject {
  Q_OBJECT
 private slots:
  void skewIsThatOfTheAzimuth();
  void skewFollowsPittAndPeters();
  void teeteringRotorTilts();
  void stiffBladesAreRigid();
  void tiltedThrustSparesTheShaft();
  void wholeDiscPitchesUp();
  void mirroredSpinMirrorsTheSides();
  void finiteEverywhere();
};

/// At small in-plane speeds the closed form is the integral.
void TestDiscResponse::skewIsThatOfTheAzimuth() {
  const LinearRotor r;
  const double omega = 600, axial = 0.7, across = 0.4;
  // The inflow that momentum gives for the thrust it leaves.
  double v = 4;
  for (int i = 0; i < 200; ++i) {
    const double thrust = sum(r, omega, axial, across, v, 0).thrust;
    const double h = thrust / (2 * kDensity * r.disc().area);
    v += 0.3 * (h / std::hypot(across, axial + v) - v);
  }
  const double k = 15 * pi / 32 * across / (axial + v + std::hypot(axial + v, across));
  const Summed even = sum(r, omega, axial, across, v, 0);
  const Summed skewed = sum(r, omega, axial, across, v, k);
  const auto d =
      discResponse<double>(r.disc(), evenOf(even, across), omega, axial, across * across, kDensity);
  QVERIFY(std::abs(even.pitch) < 1e-12 && std::abs(even.side) < 1e-12);
  QVERIFY(skewed.pitch > 0.001 * even.thrust * r.radius);
  QVERIFY2(std::abs(d.pitch * across / skewed.pitch - 1) < 0.02,
           qPrintable(QString::number(d.pitch * across / skewed.pitch)));
  QVERIFY2(std::abs(d.side * across - skewed.side) < 0.05 * std::abs(skewed.side),
           qPrintable(QStringLiteral("%1 %2").arg(d.side * across).arg(skewed.side)));
  // What the even part has stays.
  QCOMPARE(d.thrust, even.thrust);
  QCOMPARE(d.drag, evenOf(even, across).drag);
}

/// Edgewise and fast the wake leaves flat: chi is 90 degrees, K = 15 pi/32; slow, K is half the
/// angle times it.
void TestDiscResponse::skewFollowsPittAndPeters() {
  const LinearRotor r;
  const double thrust = 3, omega = 600;
  const double hover = std::sqrt(thrust / (2 * kDensity * r.disc().area));
  const auto gradient = [&](double across) {  // K v0
    const auto d = discResponse<double>(r.disc(), {thrust, 0.0, 0.0, 0.0}, omega, 0.0,
                                        across * across, kDensity);
    return d.pitch * across * 4 * r.radius / (kDensity * r.disc().flapIntegral * omega);
  };
  const double fast = 40 * hover, v = hover * hover / fast;
  QVERIFY(std::abs(gradient(fast) / (15 * pi / 32 * v) - 1) < 0.03);
  const double slow = 0.05 * hover;
  QVERIFY(std::abs(gradient(slow) / (15 * pi / 64 * slow) - 1) < 0.02);
}

/// A teetering rotor without skew flaps back by 8/3 mu theta - 2 mu lambda of uniform pitch
/// (Leishman, eq. 4.75 without its mu^2), and its hub has no moment.
void TestDiscResponse::teeteringRotorTilts() {
  const LinearRotor r;
  const double omega = 600, across = 1.5, v = 4;
  const Summed even = sum(r, omega, 0, across, v, 0);
  DiscConstants c = r.disc();
  c.flapping = true;
  const EvenLoad<double> load = evenOf(even, across);
  const auto d = discResponse<double>(c, load, omega, 0.0, across * across, kDensity);
  QVERIFY(std::abs(d.roll) < 1e-12 && std::abs(d.pitch) < 1e-12);
  const double mu = across / (omega * r.radius), lambda = v / (omega * r.radius);
  const double back = (d.drag - load.drag) * across / load.thrust;
  QVERIFY2(std::abs(back / (mu * (8.0 / 3 * r.pitch - 2 * lambda)) - 1) < 0.01,
           qPrintable(QString::number(back / (mu * (8.0 / 3 * r.pitch - 2 * lambda)))));
}

void TestDiscResponse::stiffBladesAreRigid() {
  const LinearRotor r;
  const EvenLoad<double> load{3, 0.05, 0.01, -0.002};
  DiscConstants c = r.disc();
  const auto rigid = discResponse<double>(c, load, 600, 0.5, 9, kDensity);
  c.flapping = true;
  c.stiffness = 1e5;
  const auto stiff = discResponse<double>(c, load, 600, 0.5, 9, kDensity);
  QVERIFY(std::abs(stiff.roll / rigid.roll - 1) < 1e-4);
  QVERIFY(std::abs(stiff.pitch / rigid.pitch - 1) < 1e-4);
  QVERIFY(std::abs(stiff.drag - rigid.drag) < 1e-4 * load.thrust);
  // Softer ones tilt more and bring less to the hub, all the way.
  double moment = std::hypot(rigid.roll, rigid.pitch), drag = rigid.drag;
  for (const double k : {1.0, 0.3, 0.1, 0.03, 0.01}) {
    c.stiffness = k;
    const auto d = discResponse<double>(c, load, 600, 0.5, 9, kDensity);
    QVERIFY(std::hypot(d.roll, d.pitch) < moment);
    moment = std::hypot(d.roll, d.pitch), drag = d.drag;
  }
  QVERIFY(drag > rigid.drag);
}

/// What the tilted thrust takes from the motion the shaft need not give.
void TestDiscResponse::tiltedThrustSparesTheShaft() {
  const LinearRotor r;
  const EvenLoad<double> load{3, 0.05, 0.01, -0.004};
  DiscConstants c = r.disc();
  c.flapping = true;
  const double omega = 600, across = 4;
  const auto d = discResponse<double>(c, load, omega, 0.0, across * across, kDensity);
  const double taken = (d.drag - load.drag) * across * across,
               spared = (load.torque - d.torque) * omega;
  QVERIFY(taken > 0.1);
  QVERIFY(std::abs(spared / taken - 1) < 0.01);
}

/// A real propeller flying forward: thrust ahead of the hub, on blade elements and map alike.
void TestDiscResponse::wholeDiscPitchesUp() {
  PropellerGeometry g;
  const BladeElementRotor rotor(g);
  const AirState air{kDensity, 1.8e-5};
  const auto load = rotor.load(500, {6, 0, 0}, Vector3d::UnitZ(), 1, air);
  QVERIFY(load.moment.y() < 0);  // nose up: z up, x forward
  QVERIFY(load.force.x() < 0);
  const auto other = rotor.load(500, {0, 6, 0}, Vector3d::UnitZ(), 1, air);
  QVERIFY(std::abs(other.moment.x() + load.moment.y()) < 1e-9);
  // Backwards turns everything over.
  const auto back = rotor.load(-500, {6, 0, 0}, Vector3d::UnitZ(), 1, air);
  QVERIFY((back.force - Vector3d(load.force.x(), -load.force.y(), -load.force.z())).norm() < 1e-9);
}

void TestDiscResponse::mirroredSpinMirrorsTheSides() {
  PropellerGeometry g;
  g.root = FlappingBlades{0.3};
  const BladeElementRotor rotor(g);
  const AirState air{kDensity, 1.8e-5};
  const auto right = rotor.load(500, {6, 0, 1}, Vector3d::UnitZ(), 1, air);
  const auto left = rotor.load(500, {6, 0, 1}, Vector3d::UnitZ(), -1, air);
  QVERIFY((left.force - Vector3d(right.force.x(), -right.force.y(), right.force.z())).norm() <
          1e-9);
  QVERIFY((left.moment - Vector3d(-right.moment.x(), right.moment.y(), -right.moment.z())).norm() <
          1e-9);
  QVERIFY(std::abs(right.force.y()) > 1e-4);
}

void TestDiscResponse::finiteEverywhere() {
  const LinearRotor r;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    DiscConstants c = r.disc();
    c.flapping = i % 2 == 0;
    c.stiffness = i % 4 == 0 ? 0 : 0.2;
    const auto power = [&] { return std::pow(10, 6 * any(random)); };
    const double omega = i % 7 == 0 ? 0 : power(), axial = any(random) * power();
    const double across = power() * 1e-3, density = std::pow(10, any(random));
    const auto d =
        discResponse<double>(c, {any(random) * power(), any(random), any(random), any(random)},
                             omega, axial, across * across, density);
    QVERIFY(std::isfinite(d.thrust + d.torque + d.drag + d.roll + d.side + d.pitch));
    if (c.flapping && c.stiffness == 0) QVERIFY(d.roll == 0 && d.pitch == 0);
  }
}

QTEST_APPLESS_MAIN(TestDiscResponse)
#include "test_disc_response.moc"
