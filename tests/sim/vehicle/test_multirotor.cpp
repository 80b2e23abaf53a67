#include <QtTest>
#include <algorithm>
#include <cmath>

#include "sim/vehicle/multirotor.h"
#include "tests/sim/vehicle/plain_rk4.h"

using namespace rotorbench;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Driven = Multirotor<4>;
using Prescribed = Multirotor<4, RotorDrive::PrescribedSpeeds>;
using L = MultirotorLayout<4>;

namespace {

Matrix3d rotation(const Driven::State& y) {
  return Eigen::Quaterniond(y[L::kAttitude], y[L::kAttitude + 1], y[L::kAttitude + 2],
                            y[L::kAttitude + 3])
      .toRotationMatrix();
}

EnvironmentParameters emptySpace() {
  EnvironmentParameters e;
  e.gravity = 0;
  std::get<UniformAir>(e.air).density = 0;
  return e;
}

VehicleParameters withoutDrag() {
  VehicleParameters v;
  v.drag.linear = 0;
  return v;
}

VehicleParameters hummingbird() {
  VehicleParameters v;
  v.layout = PlusLayout{.arm = 0.17};
  auto& rotor = std::get<EqualRotors>(v.rotors).rotor;
  rotor.aerodynamics = RotorCoefficients{
      .thrust = 5.57e-6, .torque = 1.36e-7, .inflow = {1.19e-4, 2.32e-4, 3.39e-3, 0}};
  DirectMass mass;
  mass.mass = 0.5;
  mass.inertia = {.xx = 3.65e-3, .yy = 3.68e-3, .zz = 7.03e-3};
  v.mass = mass;
  v.drag = {0, {0.005, 0.005, 0.01}, Vector3d::Zero()};
  return v;
}

struct Elliptic {
  double sn, cn, dn;
};

/// Jacobi's elliptic functions by the arithmetic-geometric mean (Abramowitz, Stegun 16.4).
Elliptic jacobi(double u, double m) {
  double a[12] = {1}, c[12] = {std::sqrt(m)}, b = std::sqrt(1 - m);
  int n = 0;
  while (std::abs(c[n]) > 1e-16 && n < 11) {
    a[n + 1] = (a[n] + b) / 2;
    c[n + 1] = (a[n] - b) / 2;
    b = std::sqrt(a[n] * b);
    ++n;
  }
  double phi = std::pow(2.0, n) * a[n] * u;
  for (; n > 0; --n) phi = (phi + std::asin(c[n] * std::sin(phi) / a[n])) / 2;
  return {std::sin(phi), std::cos(phi), std::sqrt(1 - m * std::sin(phi) * std::sin(phi))};
}

}  // namespace

class TestMultirotor : public QObject {
  Q_OBJECT
 private slots:
  void moreThrustTurnsTheRightWay_data();
  void moreThrustTurnsTheRightWay();
  void tiltMovesTheRightWay();
  void hoverIsAnEquilibrium_data();
  void hoverIsAnEquilibrium();
  void gyroscopicMomentHasTheRightSign();
  void gyroscopicMomentDoesNoWork();
  void motorsTurnTheBodyTheOtherWay();
  void freeTumbleFollowsJacobi();
  void mirroredVehicleMovesMirrored();
  void bodyDragStopsTheVehicle();
  void electricalPowerIsAccountedFor();
  void prescribedSpeedJumpKeepsMomentum();
  void weakSupplyNeedsMoreDuty();
  void componentNamesFollowTheState();
  void eulerAnglesInvertTheQuaternion();
};

void TestMultirotor::moreThrustTurnsTheRightWay_data() {
  QTest::addColumn<int>("faster");
  QTest::addColumn<int>("slower");
  QTest::addColumn<Vector3d>("moment");  // signs
  QTest::addRow("left against right: roll+") << 2 << 4 << Vector3d(1, 0, 0);
  QTest::addRow("rear against front: pitch+") << 3 << 1 << Vector3d(0, 1, 0);
}

void TestMultirotor::moreThrustTurnsTheRightWay() {
  QFETCH(int, faster);
  QFETCH(int, slower);
  QFETCH(Vector3d, moment);
  const Prescribed plant(buildMultirotor<4>(hummingbird(), {}));
  auto y = plant.initialState({});
  // Equal and opposite change of thrust, so that drag torques balance too.
  const double square = y[0] * y[0];
  y[L::kSpeed + faster - 1] = std::sqrt(1.1 * square);
  y[L::kSpeed + slower - 1] = std::sqrt(0.9 * square);
  plant.setBodyRates(y, Vector3d::Zero());
  Prescribed::State d;
  plant(0, y, d);
  const Vector3d expected = 0.17 * 0.2 * 5.57e-6 * square * moment;
  QVERIFY((d.segment<3>(L::kMomentum) - expected).norm() < 1e-12);

  // Yaw: T2 + T4 - T1 - T3 by the ratio k_m/k_eta (physics section 0).
  auto twist = plant.initialState({});
  const double f[] = {0.9, 1.1, 0.9, 1.1};
  for (int i = 0; i < 4; ++i) twist[i] = std::sqrt(f[i] * square);
  plant.setBodyRates(twist, Vector3d::Zero());
  plant(0, twist, d);
  QVERIFY((d.segment<3>(L::kMomentum) - Vector3d(0, 0, 0.4 * 1.36e-7 * square)).norm() < 1e-12);
}

void TestMultirotor::tiltMovesTheRightWay() {
  const Driven plant(buildMultirotor<4>({}, {}));
  Driven::State d;
  FlightStart start;
  start.attitude = {0.1, 0, 0};
  plant(0, plant.initialState(start), d);
  QVERIFY(std::abs(d[L::kVelocity + 1] + 9.80665 * std::sin(0.1)) < 1e-9);  // roll+ to -y
  start.attitude = {0, 0.1, 0};
  plant(0, plant.initialState(start), d);
  QVERIFY(std::abs(d[L::kVelocity] - 9.80665 * std::sin(0.1)) < 1e-9);  // pitch+ to +x
  start.attitude = {0, 0.1, M_PI / 2};
  plant(0, plant.initialState(start), d);
  QVERIFY(std::abs(d[L::kVelocity + 1] - 9.80665 * std::sin(0.1)) < 1e-9);  // turned left: to +y
}

void TestMultirotor::hoverIsAnEquilibrium_data() {
  QTest::addColumn<VehicleParameters>("vehicle");
  QTest::addColumn<double>("speed");  // rad/s of rotor 1 from the reference table, 0: not checked
  QTest::addColumn<bool>("unbalanced");  // uneven moments are carried with uneven speeds
  VehicleParameters weak, uneven, parts;
  std::get<SupplyParameters>(weak.supply).internalResistance = 0.05;
  uneven.deviations = {{1, {0.02, 0.02, 0}, 0}, {3, Vector3d::Zero(), 0.03}};
  parts.mass = PartsMass{};
  parts.payloads = {{0.1, {0.03, 0, -0.05}}};
  QTest::addRow("F450") << VehicleParameters{} << 509.0 << false;
  QTest::addRow("F450 on a weak supply") << weak << 509.0 << false;
  QTest::addRow("unbalanced F450") << uneven << 0.0 << true;
  QTest::addRow("Hummingbird") << hummingbird() << 469.0 << false;
  QTest::addRow("F450 from parts with a payload") << parts << 0.0 << true;
}

void TestMultirotor::hoverIsAnEquilibrium() {
  QFETCH(VehicleParameters, vehicle);
  QFETCH(double, speed);
  QFETCH(bool, unbalanced);
  Driven plant(buildMultirotor<4>(vehicle, {}));
  FlightStart start;
  start.position = {1, 2, 3};
  start.attitude = {0, 0, 0.7};
  const auto y = plant.initialState(start);
  plant.setCommand(plant.steadyDuties(plant.hoverSpeeds()));
  QVERIFY(plant.command().maxCoeff() < 1);
  Driven::State d;
  plant(0, y, d);
  QVERIFY2(d.head<L::kCharge>().cwiseAbs().maxCoeff() < 1e-10,
           qPrintable(QString::number(d.head<L::kCharge>().cwiseAbs().maxCoeff())));
  if (speed > 0) QVERIFY(std::abs(y[L::kSpeed] - speed) < 0.5);
  const double spread = y.head<4>().maxCoeff() - y.head<4>().minCoeff();
  QCOMPARE(spread > 1, unbalanced);
}

/// A rotor with momentum h along z and a roll rate p: -w x h is +p h about y.
void TestMultirotor::gyroscopicMomentHasTheRightSign() {
  const Prescribed plant(buildMultirotor<4>(withoutDrag(), emptySpace()));
  Prescribed::State y = Prescribed::State::Zero(), d;
  y[L::kAttitude] = 1;
  y[L::kSpeed] = 1000;  // rotor 1: counter-clockwise, momentum up
  plant.setBodyRates(y, {2, 0, 0});
  plant(0, y, d);
  const double step = 1e-6;
  const Vector3d change = (plant.bodyRates(Prescribed::State(y + step * d)) -
                           plant.bodyRates(Prescribed::State(y - step * d))) /
                          (2 * step);
  QVERIFY(std::abs(change.y() - 2 * 6.05e-5 * 1000 / 0.019) < 1e-6);
  QVERIFY(std::abs(change.x()) < 1e-9 && std::abs(change.z()) < 1e-9);
}

void TestMultirotor::gyroscopicMomentDoesNoWork() {
  VehicleParameters v = withoutDrag();
  std::get<DirectMass>(v.mass).inertia = {0.015, 0.019, 0.0252, 0.001, -0.002, 0.0015};
  const auto constants = buildMultirotor<4>(v, emptySpace());
  const Prescribed plant(constants);
  Prescribed::State y = Prescribed::State::Zero();
  y[L::kAttitude] = 1;
  y.head<4>() << 900, 300, 700, 100;
  plant.setBodyRates(y, {3, -2, 5});
  y.segment<3>(L::kVelocity) = Vector3d(1, 2, 3);
  const auto energy = [&] {
    const Vector3d w = plant.bodyRates(y);
    return 0.5 * w.dot(constants.inertia * w);
  };
  const double before = energy();
  const Vector3d momentum = rotation(y) * y.segment<3>(L::kMomentum);
  for (int k = 0; k < 5000; ++k) plainRk4(plant, 1e-3, y);
  QVERIFY(std::abs(energy() - before) < 1e-8 * before);
  QVERIFY((rotation(y) * y.segment<3>(L::kMomentum) - momentum).norm() < 1e-8 * momentum.norm());
  QVERIFY(std::abs(y.segment<4>(L::kAttitude).norm() - 1) < 1e-14);
  QVERIFY((y.segment<3>(L::kVelocity) - Vector3d(1, 2, 3)).norm() < 1e-12);
  QVERIFY((y.segment<3>(L::kPosition) - 5 * Vector3d(1, 2, 3)).norm() < 1e-9);
}

/// No air, no gravity: motor torque is internal. Spinning up counter-clockwise rotors turns the
/// body clockwise.
void TestMultirotor::motorsTurnTheBodyTheOtherWay() {
  VehicleParameters v = withoutDrag();
  v.layout = PlusLayout{};
  const auto constants = buildMultirotor<4>(v, emptySpace());
  Driven plant(constants);
  FlightStart start;
  start.rotors = RotorStart::Stopped;
  auto y = plant.initialState(start);
  plant.setCommand({0.5, 0, 0.5, 0});
  for (int k = 0; k < 4000; ++k) plainRk4(plant, 1e-4, y);
  const Vector3d w = plant.bodyRates(y);
  QVERIFY(y[L::kSpeed] > 100);
  QVERIFY(std::abs(0.0252 * w.z() + 6.05e-5 * (y[0] - y[1] + y[2] - y[3])) < 1e-12);
  QVERIFY(w.z() < -0.1);
  QVERIFY(eulerAngles(y.segment<4>(L::kAttitude)).z() < 0);
}

/// Free rotation of an asymmetric body: Landau, Lifshitz, Mechanics, section 37.
void TestMultirotor::freeTumbleFollowsJacobi() {
  VehicleParameters v = withoutDrag();
  const double i1 = 0.012, i2 = 0.019, i3 = 0.0252;
  std::get<DirectMass>(v.mass).inertia = {.xx = i1, .yy = i2, .zz = i3};
  const Prescribed plant(buildMultirotor<4>(v, emptySpace()));
  Prescribed::State y = Prescribed::State::Zero();
  y[L::kAttitude] = 1;
  const double w1 = 3, w3 = 5;
  plant.setBodyRates(y, {w1, 0, w3});
  const double twice = i1 * w1 * w1 + i3 * w3 * w3;
  const double square = i1 * i1 * w1 * w1 + i3 * i3 * w3 * w3;
  QVERIFY(square > twice * i2);
  const double rate = std::sqrt((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3));
  const double m = (i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1));
  const double amplitude = std::sqrt((twice * i3 - square) / (i2 * (i3 - i2)));
  for (int k = 1; k <= 5000; ++k) {
    plainRk4(plant, 1e-3, y);
    if (k % 500 != 0) continue;
    const Elliptic e = jacobi(rate * k * 1e-3, m);
    const Vector3d expected(w1 * e.cn, amplitude * e.sn, w3 * e.dn);
    QVERIFY((plant.bodyRates(y) - expected).norm() < 1e-8);
  }
}

/// Mirrored in the x-z plane, rotors 1 and 4, 2 and 3 change places; their spins are opposite
/// already.
void TestMultirotor::mirroredVehicleMovesMirrored() {
  VehicleParameters v = hummingbird();
  v.layout = CrossLayout{};
  std::get<EqualRotors>(v.rotors).rotor.esc.responseTime = 0.01;
  const Driven plant(buildMultirotor<4>(v, {}));
  Driven::State y, z, dy, dz;
  y << 400, 450, 500, 550, 5, 6, 7, 8, 0.4, 0.5, 0.6, 0.7, 0.9, 0.3, -0.2, 0.25, 0.01, -0.02, 0.03,
      1, 2, -3, 4, 5, 6, 0, 0, 0;
  plant.afterStep(y);
  const auto mirrored = [](const Driven::State& s) {
    Driven::State r = s;
    for (int k : {L::kSpeed, L::kCurrent, L::kDuty}) {
      r.segment<4>(k) << s[k + 3], s[k + 2], s[k + 1], s[k];
    }
    for (int k : {L::kAttitude + 1, L::kAttitude + 3, L::kMomentum, L::kMomentum + 2,
                  L::kVelocity + 1, L::kPosition + 1}) {
      r[k] = -s[k];
    }
    return r;
  };
  z = mirrored(y);
  plant(0, y, dy);
  plant(0, z, dz);
  QVERIFY((dz - mirrored(dy)).cwiseAbs().maxCoeff() < 1e-9);
}

/// Linear drag alone, the rotors at rest: v = v0 exp(-D t/m), twice as fast in air twice as dense
/// and not at all in none.
void TestMultirotor::bodyDragStopsTheVehicle() {
  VehicleParameters v;
  v.drag.linear = 0.7;
  EnvironmentParameters air = emptySpace();
  for (const double times : {0.0, 1.0, 2.0}) {
    air.air = UniformAir{times * kStandardDensity};
    const Prescribed plant(buildMultirotor<4>(v, air));
    Prescribed::State y = Prescribed::State::Zero();
    y.segment<4>(L::kAttitude) = quaternionOf({0.3, -0.2, 1});
    y.segment<3>(L::kVelocity) = Vector3d(3, -2, 1);
    for (int k = 0; k < 1000; ++k) plainRk4(plant, 1e-3, y);
    const Vector3d expected = std::exp(-0.5 * times) * Vector3d(3, -2, 1);
    QVERIFY((y.segment<3>(L::kVelocity) - expected).norm() < 1e-9);
  }
  air.air = UniformAir{kStandardDensity};
  v.drag = {0, {0.1, 0.2, 0.3}, {0.01, 0.02, 0.03}};
  const Prescribed blunt(buildMultirotor<4>(v, air));
  Prescribed::State y = Prescribed::State::Zero(), d;
  y[L::kAttitude] = 1;
  y.segment<3>(L::kVelocity) = Vector3d(3, -4, 12);
  blunt.setBodyRates(y, {1, 2, 3});
  blunt(0, y, d);
  const Vector3d expected = -13 * Vector3d(0.1 * 3, 0.2 * -4, 0.3 * 12) / 1.4;
  QVERIFY((d.segment<3>(L::kVelocity) - expected).norm() < 1e-9);
  const Vector3d moment =
      Vector3d(-0.01, -0.04, -0.09) - Vector3d(1, 2, 3).cross(Vector3d(0.019, 0.038, 0.0756));
  QVERIFY((d.segment<3>(L::kMomentum) - moment).norm() < 1e-12);
}

/// Power in = copper + magnetic + friction + aerodynamic + rotor acceleration, at any state.
void TestMultirotor::electricalPowerIsAccountedFor() {
  VehicleParameters v;
  std::get<SupplyParameters>(v.supply).internalResistance = 0.02;
  const auto constants = buildMultirotor<4>(v, {});
  Driven plant(constants);
  auto y = plant.initialState({});
  y.head<8>() << 300, 420, 510, 600, 12, -3, 7, 20;
  plant.setCommand({0.9, 0.3, 0.5, 0.7});
  Driven::State d;
  MultirotorForces<4> f;
  plant.derivativeAndForces(0, y, d, f);
  double used = 0, given = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double w = y[k], current = y[4 + k];
    const auto& m = constants.hubs[i].motor;
    given += f.voltage[i] * current;
    used += m.resistance * current * current + m.inductance * current * d[4 + k] +
            m.friction(w) * w + f.torque[i] * w + constants.hubs[i].rotor.inertia * w * d[k];
  }
  QVERIFY(std::abs(given - used) < 1e-9 * std::abs(given));
  QVERIFY(std::abs(f.busVoltage * f.supplyCurrent - given) < 1e-9 * std::abs(given));
  QVERIFY(std::abs(f.busVoltage - (11.1 - 0.02 * f.supplyCurrent)) < 1e-12);
}

void TestMultirotor::prescribedSpeedJumpKeepsMomentum() {
  const auto constants = buildMultirotor<4>({}, {});
  const Prescribed plant(constants);
  auto y = plant.initialState({});
  const Vector3d before = y.segment<3>(L::kMomentum);
  QVERIFY(plant.bodyRates(y).norm() < 1e-15);
  Prescribed::setRotorSpeeds(y, {600, 500, 600, 500});
  QCOMPARE(Vector3d(y.segment<3>(L::kMomentum)), before);
  QVERIFY(std::abs(plant.bodyRates(y).z() + 6.05e-5 * 200 / 0.0252) < 1e-12);
}

void TestMultirotor::weakSupplyNeedsMoreDuty() {
  VehicleParameters v;
  const Driven ideal(buildMultirotor<4>(v, {}));
  std::get<SupplyParameters>(v.supply).internalResistance = 0.05;
  const Driven weak(buildMultirotor<4>(v, {}));
  const auto speeds = ideal.hoverSpeeds();
  QVERIFY(weak.steadyDuties(speeds)[0] > 1.02 * ideal.steadyDuties(speeds)[0]);
}

void TestMultirotor::componentNamesFollowTheState() {
  QCOMPARE(Driven::componentName(1), std::string("rotor2.speed"));
  QCOMPARE(Driven::componentName(7), std::string("rotor4.current"));
  QCOMPARE(Driven::componentName(8), std::string("rotor1.duty"));
  QCOMPARE(Driven::componentName(L::kAttitude + 3), std::string("attitude.z"));
  QCOMPARE(Driven::componentName(L::kPosition + 2), std::string("position.z"));
  QCOMPARE(Driven::componentName(L::kCharge), std::string("supply.charge"));
}

void TestMultirotor::eulerAnglesInvertTheQuaternion() {
  for (const Vector3d& a : {Vector3d(0.3, -1.2, 2.5), Vector3d(-3, 0.4, -0.1), Vector3d(0, 0, 0)}) {
    QVERIFY((eulerAngles(quaternionOf(a)) - a).norm() < 1e-14);
  }
}

QTEST_APPLESS_MAIN(TestMultirotor)
#include "test_multirotor.moc"
