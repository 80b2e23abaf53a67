#include "sim/sizing/data_sheet_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/run/step_stability.h"
#include "sim/sizing/discharge.h"
#include "sim/sizing/drive_point.h"

namespace rotorbench {

namespace {

constexpr double kSpeedOfSound = 340.294;  // m/s, ISO 2533:1975 at sea level
constexpr double kTipMach = 0.7;
constexpr const char* kMotorSource = "Thesis 2014, figure 3.11";
constexpr const char* kMomentum =
    "Momentum theory: Leishman, Principles of Helicopter Aerodynamics, ch. 2";

/// Everything the figures are read from.
struct Worked {
  const DataSheet& sheet;
  DriveTrain train = driveTrainOf(sheet);
  double weight = sheet.vehicle.mass * sheet.vehicle.gravity / sheet.vehicle.rotors;  // N, each
  double density = airDensityOf(sheet);
  double radius = diameterOf(sheet) / 2;
  std::optional<DrivePoint> hover = pointWithThrust(train, weight);
  DrivePoint full = drivePoint(train, 1);
  BestEfficiency best =
      bestEfficiency(train.motor(), train.supply().openCircuit(train.supply().charge));
};

double fastestElectricalPole(const Worked& w) {
  return std::max(w.train.fastestPole(0), w.train.fastestPole(w.full.speed));
}

void addMotor(FigureSheet& sheet, const Worked& w) {
  FigureGroup g(sheet, "motor", "Motor");
  const MotorConstants& m = w.train.motor();
  const MotorParameters& p = w.sheet.motor;
  g.add("torqueConstant", "Torque constant", "K_t", m.torqueConstant, "N*m/A", "mN*m/A",
        "60/(2\u03c0 Kv), Kv in rpm/V", kMotorSource);
  g.add("backEmf", "Back-EMF constant", "K_b", m.torqueConstant, "V*s", "mV/rpm",
        "the same number as K_t: electrical and mechanical power are equal", kMotorSource);
  const double noLoadSpeed = (p.noLoadVoltage - p.resistance * p.noLoadCurrent) * p.speedConstant;
  g.add("noLoadSpeed", "No-load speed", "\u03a9\u2080", noLoadSpeed, "rad/s", "rpm",
        "Kv (V\u2080 - R I\u2080)");
  g.add("noLoadTorque", "No-load torque", "Q\u2080", m.friction(noLoadSpeed), "N*m", "mN*m",
        "K_t I\u2080 = T_c + f \u03a9\u2080");
  g.add("dryFriction", "Dry friction", "T_c", m.dryFriction, "N*m", "mN*m",
        "(1 - viscous share) K_t I\u2080");
  g.add("viscousFriction", "Viscous friction", "f", m.viscousFriction, "N*m*s", "N*m*s",
        "viscous share K_t I\u2080/\u03a9\u2080");
  g.add("bestCurrent", "Best-efficiency current", "i*", w.best.current, "A", "A",
        "maximum of (K_t i - friction) \u03a9/(V i) at the full voltage; \u221a(I\u2080 V/R) with "
        "dry friction "
        "alone");
  g.add("bestEfficiency", "Best efficiency", "\u03b7*", w.best.efficiency, "1", "%",
        "at i*; (1 - \u221a(I\u2080 R/V))\u00b2 with dry friction alone");
}

void addPropeller(FigureSheet& sheet, const Worked& w) {
  FigureGroup g(sheet, "propeller", "Propeller");
  const DrivePoint& at = w.hover ? *w.hover : w.full;
  const char* where = w.hover ? "at the hover speed" : "at full throttle";
  const double square = at.speed * at.speed;
  const bool turns = square > 0;
  g.add("thrustCoefficient", "Thrust coefficient", "k_f", turns ? at.thrust / square : kNoFigure,
        "N*s^2", "N*s^2", "T/\u03a9\u00b2 = C_T \u03c1 D\u2074/(4\u03c0\u00b2)")
      .note = where;
  g.add("torqueCoefficient", "Torque coefficient", "k_m", turns ? at.torque / square : kNoFigure,
        "N*m*s^2", "N*m*s^2", "Q/\u03a9\u00b2 = C_P \u03c1 D\u2075/(8\u03c0\u00b3)")
      .note = where;
  const double shaft = at.torque * at.speed;
  g.add("figureOfMerit", "Figure of merit", "FM",
        shaft > 0 ? figureOfMerit(at.thrust, shaft, w.radius, w.density) : kNoFigure, "1", "1",
        "T^(3/2)/\u221a(2 \u03c1 A) over the shaft power", kMomentum)
      .note = where;
  g.add("inertia", "Inertia of the rotor", "J", w.train.inertia(), "kg*m^2", "g*cm^2",
        std::holds_alternative<GivenInertia>(w.sheet.inertia)
            ? "as given"
            : "m D\u00b2/12 + m_b r_b\u00b2: a rod and a thin ring");
}

void addHover(FigureSheet& sheet, const Worked& w) {
  FigureGroup g(sheet, "hover", "Hover");
  const std::size_t first = sheet.figures.size();
  const DrivePoint p = w.hover.value_or(DrivePoint{});
  const double n = w.sheet.vehicle.rotors;
  const double shaft = p.torque * p.speed, motor = p.electrical.motorVoltage * p.electrical.current;
  const double bus = p.electrical.busVoltage * p.electrical.busCurrent;
  const Supply supply(w.sheet.supply);
  const ConstantLoad load{
      n * bus, p.electrical.motorVoltage + w.sheet.esc.resistance * p.electrical.current, 0};
  g.add("thrust", "Thrust per rotor", "T_h", w.weight, "N", "N", "m g/N");
  g.add("speed", "Rotor speed", "\u03a9_h", p.speed, "rad/s", "rpm", "T(\u03a9_h) = m g/N");
  g.add("throttle", "Throttle", "d_h", p.throttle, "1", "%",
        "d V = R i + K_b \u03a9 + R_esc i with K_t i = Q(\u03a9) + friction; V falls with the "
        "current of all motors");
  g.add("current", "Current per motor", "i_h", p.electrical.current, "A", "A",
        "(Q(\u03a9_h) + friction)/K_t");
  g.add("totalCurrent", "Current from the supply", "I_h", n * p.electrical.busCurrent, "A", "A",
        "N d_h i_h");
  g.add("busVoltage", "Voltage under load", "V_h", p.electrical.busVoltage, "V", "V",
        "OCV - R\u2080 I_h");
  g.add("shaftPower", "Shaft power per rotor", "P_s", shaft, "W", "W", "Q \u03a9");
  g.add("power", "Electrical power per drive", "P_h", bus, "W", "W", "V_h d_h i_h");
  g.add("totalPower", "Electrical power of all", "N P_h", n * bus, "W", "W", "N V_h d_h i_h");
  g.add("motorEfficiency", "Motor efficiency", "\u03b7_m", motor > 0 ? shaft / motor : kNoFigure,
        "1", "%", "Q \u03a9/(v i)", kMotorSource);
  g.add("thrustPerPower", "Thrust per power", "T/P", bus > 0 ? p.thrust / bus : kNoFigure, "N/W",
        "gf/W", "thrust over electrical power; gf/W is what sellers call g/W");
  const Discharge run = w.hover ? discharge(supply, load) : Discharge{};
  Figure& time =
      g.add("endurance", "Hover until empty", "t_h", run.time, "s", "min",
            "discharge at constant power with open-circuit voltage, resistance and polarisation",
            "Chen, Rinc\u00f3n-Mora, IEEE Trans. Energy Conversion 21 (2006)");
  time.note = "ends when " + reasonOf(run.end, supply, load);
  if (run.end == DischargeEnd::Never)
    time.value = kNoFigure, time.note = reasonOf(run.end, supply, load);
  if (w.hover) return;
  for (std::size_t k = first + 1; k < sheet.figures.size(); ++k) {
    sheet.figures[k].value = kNoFigure;
    sheet.figures[k].note = "full throttle gives " + Sentence::number(w.full.thrust) +
                            " N of the " + Sentence::number(w.weight) + " N needed";
  }
}

void addFullThrottle(FigureSheet& sheet, const Worked& w) {
  FigureGroup g(sheet, "full", "Full throttle");
  const DrivePoint& p = w.full;
  const double shaft = p.torque * p.speed, motor = p.electrical.motorVoltage * p.electrical.current;
  const double bus = p.electrical.busVoltage * p.electrical.busCurrent;
  const Sentence limit =
      p.currentLimited
          ? "limited by the current limit of " + Sentence::number(w.train.maxCurrent()) + " A"
          : "limited by the supply: " + Sentence::number(p.electrical.openCircuit) + " V fall to " +
                Sentence::number(p.electrical.busVoltage) + " V under load";
  g.add("speed", "Rotor speed", "\u03a9_max", p.speed, "rad/s", "rpm",
        "d = 1: V = R i + K_b \u03a9 + R_esc i with K_t i = Q(\u03a9) + friction")
      .note = limit;
  g.add("thrust", "Thrust per rotor", "T_max", p.thrust, "N", "N", "T(\u03a9_max)");
  g.add("thrustToWeight", "Thrust to weight", "T/W", p.thrust / w.weight, "1", "1", "N T_max/(m g)")
      .note = limit;
  g.add("current", "Current per motor", "i_max", p.electrical.current, "A", "A",
        "(Q(\u03a9_max) + friction)/K_t");
  g.add("totalCurrent", "Current from the supply", "I_max",
        w.sheet.vehicle.rotors * p.electrical.busCurrent, "A", "A", "N i_max");
  g.add("power", "Electrical power per drive", "P_max", bus, "W", "W", "V i_max");
  g.add("motorEfficiency", "Motor efficiency", "\u03b7_m", motor > 0 ? shaft / motor : kNoFigure,
        "1", "%", "Q \u03a9/(v i)", kMotorSource);
  g.add("thrustPerPower", "Thrust per power", "T/P", bus > 0 ? p.thrust / bus : kNoFigure, "N/W",
        "gf/W", "thrust over electrical power");
  g.add("tipMach", "Tip Mach number", "M_tip", p.speed * w.radius / kSpeedOfSound, "1", "1",
        "\u03a9 R/a with a = " + Sentence::number(kSpeedOfSound, 4) + " m/s");
}

void addDynamics(FigureSheet& sheet, const Worked& w) {
  FigureGroup g(sheet, "dynamics", "How fast it answers");
  const MotorConstants& m = w.train.motor();
  const double r = m.resistance + w.sheet.esc.resistance;
  const double k = m.torqueConstant, j = w.train.inertia();
  g.add("electrical", "Electrical time constant", "\u03c4_e", m.inductance / r, "s", "ms",
        "L/(R + R_esc)");
  g.add("mechanical", "Mechanical time constant", "\u03c4_m", j * r / (k * k), "s", "ms",
        "J (R + R_esc)/K_t\u00b2: without load, current at once");
  DriveTrainSetup slow{.supply = w.sheet.supply,
                       .esc = w.sheet.esc,
                       .motor = w.sheet.motor,
                       .load = w.train.load(),
                       .inertia = j,
                       .quasiStaticCurrent = true};
  const double pole = w.hover ? DriveTrain(slow).fastestPole(w.hover->speed) : kNoFigure;
  Figure& tau = g.add("speed", "Speed about the hover", "\u03c4_\u03a9", 1 / pole, "s", "ms",
                      "J/(K_t\u00b2/(R + R_esc) + dQ/d\u03a9), linearised at the hover speed");
  tau.note =
      w.hover ? "a speed controller makes it faster at the price of current" : "there is no hover";
  const double fastest = fastestElectricalPole(w);
  g.add("pole", "Fastest pole", "|\u03bb|", fastest, "1/s", "1/s",
        "largest eigenvalue of [-R/L, -K/L; K/J, -(f + dQ/d\u03a9)/J]");
  g.add("largestStep", "Largest stable step of RK4", "h",
        stabilityLimit(ode::Method::Rk4) / fastest, "s", "us",
        Sentence::number(stabilityLimit(ode::Method::Rk4), 4) + "/|\u03bb|",
        "Hairer, Wanner, Solving ODEs II, IV.2");
}

void warnOfHover(const Worked& w, std::vector<Sentence>& warnings) {
  if (!w.hover) {
    warnings.push_back("The drives cannot carry the vehicle: full throttle gives " +
                       Sentence::number(w.full.thrust / w.weight) + " of its weight.");
    return;
  }
  if (w.full.thrust < 1.5 * w.weight) {
    warnings.push_back("Full throttle gives only " + Sentence::number(w.full.thrust / w.weight) +
                       " of the weight; little is left for control and gusts.");
  }
}

void warnOfCurrent(const Worked& w, std::vector<Sentence>& warnings) {
  DriveTrainSetup open{.supply = shareOf(w.sheet.supply, w.sheet.vehicle.rotors),
                       .esc = w.sheet.esc,
                       .motor = w.sheet.motor,
                       .load = w.train.load(),
                       .inertia = w.train.inertia()};
  open.esc.maxCurrent = open.motor.maxCurrent = 1e9;
  const double unlimited = drivePoint(DriveTrain(open), 1).electrical.current;
  const bool motor = w.sheet.motor.maxCurrent <= w.sheet.esc.maxCurrent;
  if (unlimited > w.train.maxCurrent()) {
    warnings.push_back("Full throttle would draw " + Sentence::number(unlimited) +
                       " A, above the " + (motor ? "motor's" : "speed controller's") +
                       " limit of " + Sentence::number(w.train.maxCurrent()) + " A.");
  }
  if (w.sheet.motor.noLoadCurrent > 0.2 * w.full.electrical.current) {
    warnings.emplace_back(
        "The no-load current is more than a fifth of the current at full throttle: the propeller "
        "is very small for this motor, or a figure is wrong.");
  }
}

void warnOfPropeller(const Worked& w, std::vector<Sentence>& warnings) {
  const double mach = w.full.speed * w.radius / kSpeedOfSound;
  if (mach > kTipMach) {
    warnings.push_back("The blade tips reach Mach " + Sentence::number(mach) +
                       " at full throttle; above " + Sentence::number(kTipMach) +
                       " thrust is lost that no model here accounts for.");
  }
  const double shaft = w.full.torque * w.full.speed;
  if (!(shaft > 0)) {
    warnings.emplace_back("The propeller takes no power: its torque or power coefficient is zero.");
    return;
  }
  const double merit = figureOfMerit(w.full.thrust, shaft, w.radius, w.density);
  if (merit > 1) {
    warnings.push_back("The propeller would have a figure of merit of " + Sentence::number(merit) +
                       "; above 1 no propeller can be, so thrust, power or diameter is wrong.");
  } else if (merit < 0.3) {
    warnings.push_back("The propeller's figure of merit is only " + Sentence::number(merit) +
                       "; usual ones reach " + Sentence::number(0.5) + " to " +
                       Sentence::number(0.75) + ".");
  }
}

}  // namespace

double figureOfMerit(double thrust, double shaftPower, double radius, double density) {
  const double area = std::numbers::pi * radius * radius;
  return thrust * std::sqrt(std::max(0.0, thrust) / (2 * density * area)) / shaftPower;
}

FigureSheet figuresOf(const DataSheet& sheet) {
  const Worked w{sheet};
  FigureSheet figures;
  addMotor(figures, w);
  addPropeller(figures, w);
  addHover(figures, w);
  addFullThrottle(figures, w);
  addDynamics(figures, w);
  warnOfHover(w, figures.warnings);
  warnOfCurrent(w, figures.warnings);
  warnOfPropeller(w, figures.warnings);
  return figures;
}

ThrottleCurve throttleCurve(const DataSheet& sheet, int points) {
  const Worked w{sheet};
  const auto pointOf = [](const DrivePoint& p) {
    return ThrottleCurve::Point{p.throttle, p.thrust, p.electrical.current, p.speed};
  };
  ThrottleCurve curve;
  for (int k = 0; k < points; ++k) {
    curve.points.push_back(pointOf(drivePoint(w.train, static_cast<double>(k) / (points - 1))));
  }
  if (w.hover) curve.hover.push_back(pointOf(*w.hover));
  return curve;
}

}  // namespace rotorbench
