#include "sim/propulsion/rotor.h"

#include <numbers>

namespace rotorbench {

namespace {

void setInflow(RotorConstants& c, const RotorInflow& inflow, double density) {
  c.drag = inflow.drag / density;
  c.inflow = inflow.inflow / density;
  c.lift = inflow.translationalLift / density;
  c.flapping = inflow.flapping / density;
}

void setAerodynamics(RotorConstants& c, const RotorCoefficients& a) {
  c.thrust = a.thrust / a.referenceDensity;
  c.torque = a.torque / a.referenceDensity;
  c.radius = a.diameter / 2;
  setInflow(c, a.inflow, a.referenceDensity);
}

void setAerodynamics(RotorConstants& c, const PropellerCoefficients& a) {
  constexpr double kTurn = 2 * std::numbers::pi;
  c.thrust = a.thrustCoefficient * std::pow(a.diameter, 4) / (kTurn * kTurn);
  c.torque = a.powerCoefficient * std::pow(a.diameter, 5) / (kTurn * kTurn * kTurn);
  c.radius = a.diameter / 2;
  setInflow(c, a.inflow, kStandardDensity);
}

}  // namespace

RotorConstants buildRotor(const RotorParameters& parameters) {
  RotorConstants c;
  std::visit([&c](const auto& a) { setAerodynamics(c, a); }, parameters.aerodynamics);
  c.inertia = parameters.inertia;
  c.inverseInertia = 1 / parameters.inertia;
  return c;
}

void Describe<RotorInflow>::fields(schema::Builder<RotorInflow>& b) {
  using P = RotorInflow;
  b.title(
      "inflow", "Effects of moving air",
      "In-plane drag, loss of thrust in climb, translational lift and flapping of the lumped rotor "
      "model.",
      "Svacha, Mohta, Kumar, ICUAS 2017; RotorPy");
  b.number("drag", &P::drag, "Rotor drag", "k_d", "N*s^2/m")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Force against in-plane motion: k_d times rotor speed times air speed.");
  b.number("inflow", &P::inflow, "Inflow loss", "k_z", "N*s^2/m")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Thrust lost in climb: k_z times rotor speed times climb speed.");
  b.number("translationalLift", &P::translationalLift, "Translational lift", "k_h", "N*s^2/m^2")
      .range(schema::atLeast(0), schema::upTo(10))
      .help("Thrust won in level flight: k_h times in-plane air speed squared.");
  b.number("flapping", &P::flapping, "Flapping", "k_flap", "N*s^2")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Moment at the hub from flapping blades.")
      .advanced();
}

void Describe<RotorCoefficients>::fields(schema::Builder<RotorCoefficients>& b) {
  using P = RotorCoefficients;
  const char* hummingbird = "AscTec Hummingbird: RotorPy, vehicles/hummingbird_params.py";
  b.title("coefficients", "Lumped coefficients",
          "Thrust k_eta w\u00b2 and drag torque k_m w\u00b2, with the effects of moving air.",
          "Svacha, Mohta, Kumar, ICUAS 2017; RotorPy");
  b.number("thrust", &P::thrust, "Thrust coefficient", "k_\u03b7", "N*s^2")
      .range(schema::above(0), schema::upTo(1))
      .help("Thrust per rotor speed squared.")
      .source(hummingbird);
  b.number("torque", &P::torque, "Torque coefficient", "k_m", "N*m*s^2")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Drag torque per rotor speed squared.")
      .source(hummingbird);
  b.group("inflow", &P::inflow, "Moving air").source(hummingbird);
  b.number("referenceDensity", &P::referenceDensity, "Holds at air density", "\u03c1\u2080",
           "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("Forces scale with the actual density over this one.")
      .advanced();
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(10))
      .shownIn("in")
      .help("Only for drawing; the coefficients hold the aerodynamics.")
      .source("8 inch propeller of the Hummingbird");
}

void Describe<PropellerCoefficients>::fields(schema::Builder<PropellerCoefficients>& b) {
  using P = PropellerCoefficients;
  const char* dji = "JSBSim aircraft F450, engine/DJI_9450.xml, advance ratio 0";
  b.title(
      "propeller", "Propeller coefficients",
      "Thrust CT \u03c1 n\u00b2 D\u2074 and torque CP \u03c1 n\u00b2 D\u2075/(2\u03c0), n in turns "
      "per second, with the coefficients at rest.",
      "McCormick, Aerodynamics, Aeronautics and Flight Mechanics, ch. 6");
  b.number("thrustCoefficient", &P::thrustCoefficient, "Thrust coefficient", "CT", "1")
      .range(schema::above(0), schema::upTo(1))
      .help("At rest (advance ratio 0).")
      .source(dji);
  b.number("powerCoefficient", &P::powerCoefficient, "Power coefficient", "CP", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("At rest (advance ratio 0).")
      .source(dji);
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(10))
      .shownIn("in")
      .source(dji);
  b.group("inflow", &P::inflow, "Moving air")
      .help("At an air density of 1.225 kg/m\u00b3.")
      .advanced();
}

void Describe<RotorParameters>::fields(schema::Builder<RotorParameters>& b) {
  using P = RotorParameters;
  b.title("rotor", "Rotor", "A propeller and the motor that turns it.");
  b.variant("aerodynamics", &P::aerodynamics, "Aerodynamics");
  b.number("inertia", &P::inertia, "Spinning inertia", "J", "kg*m^2")
      .range(schema::above(0), schema::upTo(10))
      .help("Of propeller and motor bell about the rotor axis.")
      .source("JSBSim aircraft F450, engine/DJI_9450.xml");
  b.number("mass", &P::mass, "Motor and propeller mass", "m_i", "kg")
      .range(schema::atLeast(0), schema::upTo(100))
      .shownIn("g")
      .help(
          "A point mass at the hub. With mass properties given directly it is part of them and "
          "matters only where an arm deviates.")
      .source("AirSim, MultiRotorParams.hpp: MT2212 motor of an F450 frame");
  b.integer("blades", &P::blades, "Blades", "N_b")
      .range(schema::atLeast(1), schema::upTo(12))
      .help("Only for drawing.");
  b.group("motor", &P::motor, "Motor");
}

}  // namespace rotorbench
