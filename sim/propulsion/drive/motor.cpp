#include "sim/propulsion/drive/motor.h"

#include <algorithm>
#include <complex>

#include "sim/numerics/scalar_search.h"

namespace rotorbench {

MotorParameters djiE305() {
  // JSBSim aircraft F450, engine/DJI_E305.xml: 960 rpm/V, 0.117 Ohm, 0.45 A; the limit is that of
  // the set's 420 LITE speed controller.
  return {.speedConstant = 100.53096491487338,
          .resistance = 0.117,
          .noLoadCurrent = 0.45,
          .maxCurrent = 20};
}

MotorConstants buildMotor(const MotorParameters& p) {
  MotorConstants m;
  m.torqueConstant = 1 / p.speedConstant;
  m.resistance = p.resistance;
  m.inductance = p.inductance;
  m.inverseInductance = 1 / p.inductance;
  const double noLoadSpeed =
      std::max(0.0, p.noLoadVoltage - p.resistance * p.noLoadCurrent) * p.speedConstant;
  const double noLoadTorque = m.torqueConstant * p.noLoadCurrent;
  m.viscousFriction = noLoadSpeed > 0 ? p.viscousShare * noLoadTorque / noLoadSpeed : 0;
  // The smooth sign is a shade below one at the no-load speed; dividing it out keeps I0 exact.
  const double sign = noLoadSpeed / std::hypot(noLoadSpeed, kFrictionSpeed);
  m.dryFriction = noLoadSpeed > 0 ? (1 - p.viscousShare) * noLoadTorque / sign : noLoadTorque;
  m.maxCurrent = p.maxCurrent;
  return m;
}

double topSpeed(const MotorConstants& motor, double torqueFactor, double voltage) {
  const auto holds = [&](double w) {
    const double current = motor.steadyCurrent(w, torqueFactor * w * w);
    return current <= motor.maxCurrent && motor.steadyVoltage(w, current) <= voltage;
  };
  // Demand grows with speed, and no motor turns faster than without load.
  return findLast(holds, 0, voltage / motor.torqueConstant);
}

double fastestPole(const MotorConstants& motor, double resistance, double drag, double inertia) {
  const double a = resistance * motor.inverseInductance, d = drag / inertia;
  const double k = motor.torqueConstant;
  const double determinant = a * d + k * k * motor.inverseInductance / inertia;
  const std::complex<double> root =
      std::sqrt(std::complex<double>((a + d) * (a + d) / 4 - determinant));
  return std::abs((a + d) / 2 + root);
}

void Describe<MotorParameters>::fields(schema::Builder<MotorParameters>& b) {
  using P = MotorParameters;
  b.title(
      "motor", "Motor",
      "A direct-current machine: L di/dt = v - R i - K w, J dw/dt = K i - friction - load, with "
      "K = 1/Kv in SI units. A brushless motor with its speed controller is the same machine on "
      "average.",
      "Thesis 2014, figure 3.11");
  b.standsAlone();
  b.number("speedConstant", &P::speedConstant, "Speed constant", "Kv", "rad/s/V")
      .range(schema::above(0), schema::upTo(1e5))
      .shownIn("rpm/V")
      .help("Speed per volt without load. The torque constant is its inverse in SI units.")
      .required();
  b.number("resistance", &P::resistance, "Resistance", "R", "Ohm")
      .range(schema::above(0), schema::upTo(1000))
      .help("Of the winding, between two terminals, with leads and speed controller.")
      .required();
  b.number("inductance", &P::inductance, "Inductance", "L", "H")
      .range(schema::above(0), schema::upTo(1))
      .shownIn("uH")
      .help("With R it sets how fast the current follows the voltage: L/R.")
      .source(
          "Assumption: seldom published; L/R far below a millisecond, so that it matters to no "
          "flight");
  b.number("noLoadCurrent", &P::noLoadCurrent, "No-load current", "I\u2080", "A")
      .range(schema::atLeast(0), schema::upTo(1000))
      .help("Drawn by the motor running free at the no-load voltage; gives the friction torque.")
      .source("None unless given: no friction");
  b.number("noLoadVoltage", &P::noLoadVoltage, "No-load voltage", "V\u2080", "V")
      .range(schema::above(0), schema::upTo(1000))
      .help(
          "Voltage at which the no-load current was measured. Matters only with viscous friction.")
      .source("Assumption: the usual 10 V of data sheets");
  b.number("viscousShare", &P::viscousShare, "Viscous share of friction", "", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .shownIn("%")
      .help(
          "Part of the no-load torque that grows with speed; the rest is constant (dry friction).")
      .source("Assumption: none, the no-load current is taken as constant")
      .advanced();
  b.number("maxCurrent", &P::maxCurrent, "Current limit", "i_max", "A")
      .range(schema::above(0), schema::upTo(kMostCurrentLimit))
      .help("The motor speed controller keeps the current below this by limiting the voltage.")
      .source("None unless given: the speed controller's limit holds");
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.resistance * p.noLoadCurrent >= p.noLoadVoltage) {
      problems.push_back({"noLoadCurrent", "the motor could not turn at its no-load voltage",
                          "no-load current below V0/R"});
    }
  });
}

void Describe<SupplyParameters>::fields(schema::Builder<SupplyParameters>& b) {
  using P = SupplyParameters;
  b.title("fixed", "Fixed supply", "A constant voltage behind an internal resistance.");
  b.number("voltage", &P::voltage, "Supply voltage", "V", "V")
      .range(schema::above(0), schema::upTo(1000))
      .help(
          "A lithium-polymer cell holds 3.7 V nominally and 4.2 V when full; three in series 11.1 "
          "to 12.6 V.")
      .source("Three cells in series, nominal voltage");
  b.number("internalResistance", &P::internalResistance, "Internal resistance", "R_s", "Ohm")
      .range(schema::atLeast(0), schema::upTo(10))
      .help("Lets the voltage sag with the current of all motors together.")
      .source("0: an ideal bench supply")
      .advanced();
}

}  // namespace rotorbench
