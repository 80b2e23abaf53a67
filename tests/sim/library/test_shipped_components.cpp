// Every shipped component: readable, with its source, and physically possible; where it is not, it
// says so itself.
#include <QTest>
#include <cmath>
#include <numbers>

#include "sim/library/component_library.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/rotor/blade_element.h"
#include "sim/propulsion/rotor/measured_propeller.h"
#include "sim/vehicle/multirotor.h"
#include "sim/vehicle/vehicle_parameters.h"

using namespace rotorbench;

namespace {

constexpr double kGravity = 9.80665;
constexpr AirState kAir{1.225, 1.81e-5};  // ISO 2533 at sea level

const ComponentLibrary& shipped() {
  static const ComponentLibrary library(shippedLibraryDirectory(), {});
  return library;
}

bool admitsImplausible(const ComponentInfo& info) {
  return info.warning.find("mplausible") != std::string::npos;
}

/// Ideal power of the thrust over the power: McCormick, Aerodynamics of V/STOL Flight, ch. 4.
double figureOfMerit(double thrust, double power, double diameter) {
  const double disc = std::numbers::pi * diameter * diameter / 4;
  return std::pow(thrust, 1.5) / std::sqrt(2 * kAir.density * disc) / power;
}

double diameterOf(const RotorAerodynamics& aerodynamics) {
  const auto* propeller = std::get_if<PropellerCoefficients>(&aerodynamics);
  return propeller != nullptr ? propeller->diameter
                              : std::get<RotorCoefficients>(aerodynamics).diameter;
}

/// Largest shaft power over electrical power of a motor at a fixed voltage.
double peakEfficiency(const MotorConstants& m, double voltage) {
  double best = 0;
  for (int k = 1; k < 1000; ++k) {
    const double i = voltage / m.resistance * k / 1000;
    const double w = (voltage - m.resistance * i) / m.torqueConstant;
    best = std::max(best, (m.torqueConstant * i - m.friction(w)) * w / (voltage * i));
  }
  return best;
}

#define BETWEEN(value, low, high)                                                               \
  QVERIFY2((value) >= (low) && (value) <= (high), qPrintable(QString("%1 is %2, not %3 to %4")  \
                                                                 .arg(#value)                   \
                                                                 .arg(value)                    \
                                                                 .arg(static_cast<double>(low)) \
                                                                 .arg(static_cast<double>(high))))

template <class T>
void rows() {
  QTest::addColumn<const LibraryEntry*>("entry");
  for (const LibraryEntry* entry : shipped().list(*kindOf(schema::typeOf<T>()))) {
    QTest::addRow("%s", entry->component.info.name.c_str()) << entry;
  }
}

}  // namespace

Q_DECLARE_METATYPE(const rotorbench::LibraryEntry*)

class TestShippedComponents : public QObject {
  Q_OBJECT

 private slots:
  void allFilesRead();
  void enoughOfEachKind_data();
  void enoughOfEachKind();
  void namesSourcesAndTexts();
  void publishedFaultsAreWarnedOf_data();
  void publishedFaultsAreWarnedOf();
  void motors_data() { rows<MotorParameters>(); }
  void motors();
  void batteries_data() { rows<BatteryParameters>(); }
  void batteries();
  void escs_data() { rows<EscParameters>(); }
  void escs();
  void propellers_data() { rows<PropellerGeometry>(); }
  void propellers();
  void measuredPropellers_data() { rows<MeasuredPropeller>(); }
  void measuredPropellers();
  void propellerCoefficients_data() { rows<PropellerCoefficients>(); }
  void propellerCoefficients();
  void rotorCoefficients_data() { rows<RotorCoefficients>(); }
  void rotorCoefficients();
  void airfoils_data() { rows<PolarSection>(); }
  void airfoils();
  void slowFlyerSectionIsThatOfTheLine();
  void airframes_data() { rows<VehicleParameters>(); }
  void airframes();
};

void TestShippedComponents::allFilesRead() {
  for (const auto& fault : shipped().faults()) {
    QFAIL(qPrintable(QString::fromStdString(fault.file.string() + ": " + fault.sentence)));
  }
}

void TestShippedComponents::enoughOfEachKind_data() {
  QTest::addColumn<int>("least");
  QTest::addRow("motor") << 12;
  QTest::addRow("propeller") << 40;
  QTest::addRow("battery") << 6;
  QTest::addRow("esc") << 4;
  QTest::addRow("airfoil") << 6;
  QTest::addRow("airframe") << 10;
}

void TestShippedComponents::enoughOfEachKind() {
  QFETCH(int, least);
  QVERIFY(shipped().list(*kindOf(QTest::currentDataTag())).size() >= std::size_t(least));
}

void TestShippedComponents::namesSourcesAndTexts() {
  QSet<QString> names;
  for (const auto& entry : shipped().entries()) {
    const ComponentInfo& info = entry.component.info;
    const QString name = QString::fromStdString(kindOf(*entry.component.type)->key + info.name);
    QVERIFY2(!names.contains(name), qPrintable(name));
    names << name;
    QVERIFY2(info.source.size() > 10 || info.source == "Definition.", info.name.c_str());
    QVERIFY2(!info.summary.empty(), info.name.c_str());
    QVERIFY2(info.name.size() <= 50, info.name.c_str());
    for (const auto& text : {info.summary, info.source, info.warning}) {
      QVERIFY2(text.empty() || text.back() == '.', (info.name + ": " + text).c_str());
    }
  }
}

/// What is known to be wrong or doubtful in the publications.
void TestShippedComponents::publishedFaultsAreWarnedOf_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("word");
  QTest::addRow("StampFly coreless") << "motor"
                                     << "do not fit together";
  QTest::addRow("Crazyflie 2 (RotorS)") << "airframe"
                                        << "1.33";
  QTest::addRow("Crazyflie 2.1 Brushless (IDSIA)") << "airframe"
                                                   << "Izz is about ten times";
  QTest::addRow("AscTec Hummingbird (RotorPy)") << "airframe"
                                                << "1500 rad/s";
  QTest::addRow("3DR Iris (PX4)") << "airframe"
                                  << "60 mm";
  QTest::addRow("Racer (gym-pybullet-drones)") << "airframe"
                                               << "2.5 mm";
}

void TestShippedComponents::publishedFaultsAreWarnedOf() {
  QFETCH(QString, kind);
  QFETCH(QString, word);
  const auto* entry = shipped().find(*kindOf(kind.toStdString()), QTest::currentDataTag());
  QVERIFY(entry != nullptr);
  QVERIFY(QString::fromStdString(entry->component.info.warning).contains(word));
}

void TestShippedComponents::motors() {
  QFETCH(const LibraryEntry*, entry);
  const auto& p = *entry->component.as<MotorParameters>();
  const MotorConstants m = buildMotor(p);
  // From 300 rpm/V for large propellers to 40 000 rpm/V of the smallest.
  BETWEEN(p.speedConstant * 30 / std::numbers::pi, 100, 40000);
  QCOMPARE(m.torqueConstant * p.speedConstant, 1.0);
  BETWEEN(p.noLoadCurrent * p.resistance / p.noLoadVoltage, 0, 0.1);
  BETWEEN(peakEfficiency(m, p.noLoadVoltage), 0.5, 0.95);
  // The current limit must let the motor pass the current of its best efficiency, sqrt(I0 V/R).
  QVERIFY(p.maxCurrent > std::sqrt(p.noLoadCurrent * p.noLoadVoltage / p.resistance) / 2);
  BETWEEN(p.inductance / p.resistance, 1e-6, 2e-3);
}

void TestShippedComponents::batteries() {
  QFETCH(const LibraryEntry*, entry);
  const auto& b = *entry->component.as<BatteryParameters>();
  // Sag of one cell at a current that empties it in an hour.
  BETWEEN(b.resistance * b.capacity / 3600, 0.005, 0.2);
  BETWEEN(Supply(b).openCircuit(1.0) / b.series, 4.0, 4.3);
  BETWEEN(b.polarisation, 0, b.resistance);
}

void TestShippedComponents::escs() {
  QFETCH(const LibraryEntry*, entry);
  const auto& e = *entry->component.as<EscParameters>();
  BETWEEN(e.resistance * e.maxCurrent, 0, 0.25);  // V, a small part of one cell
  BETWEEN(e.responseTime, 0, 0.1);
}

void TestShippedComponents::propellers() {
  QFETCH(const LibraryEntry*, entry);
  const auto& g = *entry->component.as<PropellerGeometry>();
  const BladeElementRotor rotor(g);
  constexpr double kTipSpeed = 60;  // m/s
  const double w = 2 * kTipSpeed / g.diameter, n = w / (2 * std::numbers::pi);
  const AxialLoad load = rotor.axial(w, 0, kAir);
  const double ct = load.thrust / (kAir.density * n * n * std::pow(g.diameter, 4));
  BETWEEN(ct, 0.03, 0.13 + 0.04 * g.blades);
  BETWEEN(figureOfMerit(load.thrust, load.torque * w, g.diameter), 0.2, 0.85);
}

void TestShippedComponents::measuredPropellers() {
  QFETCH(const LibraryEntry*, entry);
  bool rest = false;
  for (const CoefficientPoint& p : entry->component.as<MeasuredPropeller>()->points) {
    BETWEEN(p.advanceRatio, 0, 1.5);
    BETWEEN(p.thrustCoefficient, -0.1, 0.25);
    BETWEEN(p.powerCoefficient, -0.05, 0.15);
    // What comes out, T V, is less than what goes in: CT J < CP.
    if (p.thrustCoefficient > 0.02)
      QVERIFY(p.thrustCoefficient * p.advanceRatio < p.powerCoefficient);
    if (p.advanceRatio > 0) continue;
    rest = true;
    const double merit =
        std::pow(p.thrustCoefficient, 1.5) / p.powerCoefficient / std::sqrt(std::numbers::pi / 2);
    BETWEEN(merit, 0.3, 0.85);
  }
  QVERIFY(rest);
}

void TestShippedComponents::propellerCoefficients() {
  QFETCH(const LibraryEntry*, entry);
  const auto& c = *entry->component.as<PropellerCoefficients>();
  // FM = CT^1.5 / (CP sqrt(pi/2)) for T = CT rho n^2 D^4, P = CP rho n^3 D^5.
  BETWEEN(std::pow(c.thrustCoefficient, 1.5) / c.powerCoefficient / std::sqrt(std::numbers::pi / 2),
          0.3, 0.85);
}

void TestShippedComponents::rotorCoefficients() {
  QFETCH(const LibraryEntry*, entry);
  const auto& c = *entry->component.as<RotorCoefficients>();
  const double merit = figureOfMerit(c.thrust, c.torque, c.diameter);  // at 1 rad/s
  if (admitsImplausible(entry->component.info)) return;
  BETWEEN(merit, 0.2, 0.85);
  BETWEEN(c.torque / c.thrust / c.diameter, 0.03, 0.15);
}

void TestShippedComponents::airfoils() {
  QFETCH(const LibraryEntry*, entry);
  for (const Polar& polar : entry->component.as<PolarSection>()->polars) {
    double mostLift = 0, leastDrag = 1, most = 0;
    for (const PolarPoint& p : polar.points) {
      QVERIFY(p.drag > 0);
      if (std::abs(p.alpha) > 0.35) continue;  // 20 degrees
      mostLift = std::max(mostLift, p.lift);
      leastDrag = std::min(leastDrag, p.drag);
      most = std::max(most, p.lift / p.drag);
    }
    BETWEEN(mostLift, 0.6, 2.2);
    BETWEEN(leastDrag, 0.004, 0.05);
    BETWEEN(most, 8, 200);  // lift over drag
  }
}

void TestShippedComponents::slowFlyerSectionIsThatOfTheLine() {
  const ComponentKind& kind = *kindOf("analytic-airfoil");
  const auto* typical = shipped().find(kind, "Typical model propeller section");
  const auto* slow = shipped().find(kind, "Typical slow-flyer section");
  QVERIFY(typical != nullptr && slow != nullptr);
  const SectionPlace onSlowFlyer{0.2, 0.3, true}, plain{0.2, 0.3, false};
  const auto* a = typical->component.as<AnalyticSection>();
  const auto* b = slow->component.as<AnalyticSection>();
  QVERIFY(*a == AnalyticSection());
  for (const double alpha : {-0.2, 0.0, 0.1, 0.4}) {
    QCOMPARE(b->curve(plain, 8e4).at(alpha).lift, a->curve(onSlowFlyer, 8e4).at(alpha).lift);
    QCOMPARE(b->curve(plain, 8e4).at(alpha).drag, a->curve(onSlowFlyer, 8e4).at(alpha).drag);
  }
}

/// Hover within the supply's voltage, and room to climb.
void TestShippedComponents::airframes() {
  QFETCH(const LibraryEntry*, entry);
  const auto& v = *entry->component.as<VehicleParameters>();
  const double weight = massOf(v).mass * kGravity;
  const RotorParameters& rotor = std::get<EqualRotors>(v.rotors).rotor;
  const RotorConstants r = buildRotor(rotor);
  const MotorConstants m = buildMotor(rotor.motor);
  const double kf = r.thrust * kAir.density, km = r.torque * kAir.density;
  const double hover = std::sqrt(weight / 4 / kf);
  const double hoverVoltage = m.steadyVoltage(hover, m.steadyCurrent(hover, km * hover * hover));
  const double voltage = Supply(SupplyModel(v.supply)).openCircuit(1.0);
  BETWEEN(hoverVoltage / voltage, 0.2, 0.95);
  BETWEEN(m.steadyCurrent(hover, km * hover * hover), 0, m.maxCurrent);
  // Full voltage: bisection for the speed.
  double low = hover, high = voltage / m.torqueConstant;
  for (int k = 0; k < 60; ++k) {
    const double w = (low + high) / 2;
    (m.steadyVoltage(w, m.steadyCurrent(w, km * w * w)) < voltage ? low : high) = w;
  }
  BETWEEN(4 * kf * low * low / weight, 1.2, 6);
  if (!admitsImplausible(entry->component.info)) {
    BETWEEN(figureOfMerit(kf, km, diameterOf(rotor.aerodynamics)), 0.2, 0.85);
  }
  // The inertia belongs to a body of the size of the frame: radius of gyration against the arm.
  double arm = 0;
  for (const auto& hub : rotorsOf(v)) arm = std::max(arm, hub.placement.position.norm());
  const auto inertia = massOf(v).inertia;
  BETWEEN(std::sqrt(inertia(0, 0) * kGravity / weight) / arm, 0.2, 0.8);
  BETWEEN(inertia(2, 2) / inertia(0, 0), admitsImplausible(entry->component.info) ? 0.1 : 1.0, 3);
}

QTEST_GUILESS_MAIN(TestShippedComponents)
#include "test_shipped_components.moc"
