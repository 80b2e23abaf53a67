#include "sim/propulsion/drive/esc.h"

namespace rotorbench {

EscConstants buildEsc(const EscParameters& p, const MotorConstants& motor) {
  EscConstants c;
  c.inverseResponse = p.responseTime > 0 ? 1 / p.responseTime : 0;
  c.direct = p.responseTime > 0 ? 0 : 1;
  c.least = p.reverse ? -1 : 0;
  c.resistance = p.resistance;
  c.maxCurrent = std::min(p.maxCurrent, motor.maxCurrent);
  c.activeBraking = p.activeBraking;
  return c;
}

void Describe<EscParameters>::fields(schema::Builder<EscParameters>& b) {
  using P = EscParameters;
  using namespace schema;
  b.title(
      "esc", "Speed controller (ESC)",
      "An averaged converter: v = duty * V - R i at the motor, duty * i from the supply, and no "
      "losses but those of its resistance.",
      "R. W. Erickson, D. Maksimovic, Fundamentals of Power Electronics, chapter 3");
  b.standsAlone();
  b.number("resistance", &P::resistance, "Resistance", "R_esc", "Ohm")
      .range(atLeast(0), upTo(10))
      .shownIn("mOhm")
      .help("Of the switches that carry the motor's current; 0 where the motor's holds it.")
      .source("None unless given: the motor's resistance holds winding and speed controller");
  b.number("responseTime", &P::responseTime, "Response time", "T_esc", "s")
      .range(atLeast(0), upTo(10))
      .shownIn("ms")
      .help("The duty follows the throttle with this lag; 0 for none.")
      .source("None unless given: short beside the rotor's own");
  b.number("deadTime", &P::deadTime, "Dead time", "T_d", "s")
      .range(atLeast(0), upTo(1))
      .shownIn("ms")
      .help("A throttle command begins to act this much later; 0 for at once.")
      .source("Assumption: none; a pulse of 400 Hz delays by up to 2.5 ms")
      .advanced();
  b.number("maxCurrent", &P::maxCurrent, "Current limit", "i_max", "A")
      .range(above(0), upTo(1e5))
      .help(
          "Kept by limiting the voltage to the band of R i_max around the back-EMF. The lower one "
          "of this and the motor's holds. 10000 A, the most a motor's can be, is no limit of its "
          "own.")
      .source("None unless given: the motor's limit holds");
  b.boolean("reverse", &P::reverse, "Reversible")
      .help("Negative throttle turns the motor backwards.");
  b.boolean("activeBraking", &P::activeBraking, "Active braking")
      .help(
          "Without it a motor that turns the way it is driven is never slowed electrically, and "
          "no current flows back.");
}

}  // namespace rotorbench
