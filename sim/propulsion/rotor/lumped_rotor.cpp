#include "sim/propulsion/rotor/lumped_rotor.h"

#include <numbers>

#include "sim/core/constants.h"

namespace rotorbench {

namespace {

void setInflow(RotorModel<double>& m, const RotorInflow& inflow, double density, double diameter) {
  m.discs = 0.5 * std::numbers::pi * diameter * diameter;
  m.lifting = inflow.translationalLift > 0;
  m.drag = inflow.drag / density;
  m.inflow = inflow.inflow / density;
  m.lift = inflow.translationalLift / density;
  m.flapping = inflow.flapping / density;
}

}  // namespace

SquareFactors squareFactors(double thrustCoefficient, double powerCoefficient, double diameter) {
  return {thrustCoefficient * std::pow(diameter, 4) / (kTurn * kTurn),
          powerCoefficient * std::pow(diameter, 5) / (kTurn * kTurn * kTurn)};
}

double diameterOf(const RotorCoefficients& c) {
  if (c.diameter > 0) return c.diameter;
  // UIUC Propeller Database: two-bladed model propellers have 0.08 to 0.13 at rest, and the
  // diameter goes with its fourth root.
  constexpr double kTypicalThrustCoefficient = 0.1;
  const double unit = squareFactors(kTypicalThrustCoefficient, 0, 1).thrust * c.referenceDensity;
  return std::pow(c.thrust / unit, 0.25);
}

RotorModel<double> lumpedModel(const RotorCoefficients& c) {
  RotorModel<double> m;
  m.thrust = c.thrust / c.referenceDensity;
  m.torque = c.torque / c.referenceDensity;
  setInflow(m, c.inflow, c.referenceDensity, diameterOf(c));
  return m;
}

RotorModel<double> lumpedModel(const PropellerCoefficients& c) {
  RotorModel<double> m;
  const SquareFactors factors = squareFactors(c.thrustCoefficient, c.powerCoefficient, c.diameter);
  m.thrust = factors.thrust;
  m.torque = factors.torque;
  setInflow(m, c.inflow, kStandardDensity, c.diameter);
  return m;
}

void Describe<RotorInflow>::fields(schema::Builder<RotorInflow>& b) {
  using P = RotorInflow;
  b.title(
      "inflow", "Effects of moving air",
      "In-plane drag, loss of thrust in climb, translational lift and flapping of the lumped rotor "
      "model.",
      "Svacha, Mohta, Kumar, ICUAS 2017; RotorPy");
  b.standsAlone();
  b.number("drag", &P::drag, "Rotor drag", "k_d", "N*s^2/m")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Force against in-plane motion: k_d times rotor speed times air speed.");
  b.number("inflow", &P::inflow, "Inflow loss", "k_z", "N*s^2/m")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Thrust lost in climb: k_z times rotor speed times climb speed.");
  b.number("translationalLift", &P::translationalLift, "Translational lift", "k_h", "N*s^2/m^2")
      .range(schema::atLeast(0), schema::upTo(10))
      .help(
          "Thrust won in level flight: k_h times in-plane air speed squared. The torque "
          "pays for what an ideal rotor would take more for it than at rest.");
  b.number("flapping", &P::flapping, "Flapping", "k_flap", "N*s^2")
      .range(schema::atLeast(-1), schema::upTo(1))
      .help(
          "Moment at the hub: k_flap times rotor speed times in-plane air speed. Above 0 it tips "
          "the hub forward, as RotorPy counts it; blades that flap back are below 0.")
      .advanced();
}

void Describe<RotorCoefficients>::fields(schema::Builder<RotorCoefficients>& b) {
  using P = RotorCoefficients;
  b.title("coefficients", "Lumped coefficients",
          "Thrust k_eta w\u00b2 and drag torque k_m w\u00b2, with the effects of moving air.",
          "Svacha, Mohta, Kumar, ICUAS 2017; RotorPy");
  b.standsAlone();
  b.number("thrust", &P::thrust, "Thrust coefficient", "k_\u03b7", "N*s^2")
      .range(schema::above(0), schema::upTo(1))
      .help("Thrust per rotor speed squared.")
      .required();
  b.number("torque", &P::torque, "Torque coefficient", "k_m", "N*m*s^2")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("Drag torque per rotor speed squared.")
      .required();
  b.group("inflow", &P::inflow, "Moving air")
      .help("None unless given: the figures of one rotor are not those of another.");
  b.number("referenceDensity", &P::referenceDensity, "Holds at air density", "\u03c1\u2080",
           "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("Forces scale with the actual density over this one.")
      .advanced();
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::atLeast(0), schema::upTo(10))
      .shownIn("in")
      .help(
          "For drawing and for advance ratios; the coefficients hold the aerodynamics. 0 where it "
          "is not known: that of a propeller with CT = 0.1 at rest is drawn.");
}

void Describe<PropellerCoefficients>::fields(schema::Builder<PropellerCoefficients>& b) {
  using P = PropellerCoefficients;
  b.title(
      "propeller", "Propeller coefficients",
      "Thrust CT \u03c1 n\u00b2 D\u2074 and torque CP \u03c1 n\u00b2 D\u2075/(2\u03c0), n in turns "
      "per second, with the coefficients at rest.",
      "McCormick, Aerodynamics, Aeronautics and Flight Mechanics, ch. 6");
  b.standsAlone();
  b.number("thrustCoefficient", &P::thrustCoefficient, "Thrust coefficient", "CT", "1")
      .range(schema::above(0), schema::upTo(1))
      .help("At rest (advance ratio 0).")
      .required();
  b.number("powerCoefficient", &P::powerCoefficient, "Power coefficient", "CP", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .help("At rest (advance ratio 0).")
      .required();
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(10))
      .shownIn("in")
      .required();
  b.group("inflow", &P::inflow, "Moving air")
      .help("At an air density of 1.225 kg/m\u00b3.")
      .advanced();
}

}  // namespace rotorbench
