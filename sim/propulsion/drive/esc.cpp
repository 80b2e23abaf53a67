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
  c.throttleStart = p.throttleStart;
  c.throttleFull = p.throttleFull;
  c.switchingLoss = p.switchingLoss;
  c.leadResistance = p.leadResistance;
  c.ripple = p.pwmFrequency > 0 ? motor.inverseInductance / p.pwmFrequency : 0;
  c.pathResistance = motor.resistance + p.resistance;
  return c;
}

namespace {

void describeThrottle(schema::Builder<EscParameters>& b) {
  using P = EscParameters;
  using namespace schema;
  b.number("throttleStart", &P::throttleStart, "Throttle of no duty", "u_0", "1")
      .range(atLeast(0), below(1))
      .shownIn("%")
      .help(
          "The duty is 0 up to here and rises in a straight line from here. Acts where a throttle "
          "is given, on a stand; in flight the motors' controllers set the duty.")
      .source("0: the throttle is the duty")
      .advanced();
  b.number("throttleFull", &P::throttleFull, "Throttle of full duty", "u_1", "1")
      .range(above(0), upTo(1))
      .shownIn("%")
      .help("The duty is 1 from here on: the end the speed controller was calibrated to.")
      .source("100 %: the throttle is the duty")
      .advanced();
}

void describeLosses(schema::Builder<EscParameters>& b) {
  using P = EscParameters;
  using namespace schema;
  b.number("pwmFrequency", &P::pwmFrequency, "Switching frequency", "f", "Hz")
      .range(atLeast(0), upTo(1e6))
      .shownIn("kHz")
      .help(
          "With the motor's inductance it gives the ripple of the current, which heats, and "
          "without active braking the current below which it stops in every period, so that the "
          "motor gets more than its share of the voltage. 0: no ripple.")
      .source("0: the averaged converter; 8 to 48 kHz are common")
      .advanced();
  b.number("switchingLoss", &P::switchingLoss, "Switching loss", "k_s", "1")
      .range(atLeast(0), upTo(1))
      .shownIn("%")
      .help(
          "Lost in switching and commutating, as part of supply voltage times motor current, "
          "while the voltage is chopped: k_s V i (1 - d\u00b2).")
      .source("0 unless measured: a stand's sweep of part throttle gives it")
      .advanced();
  b.number("leadResistance", &P::leadResistance, "Resistance of the leads", "R_l", "Ohm")
      .range(atLeast(0), upTo(10))
      .shownIn("mOhm")
      .help(
          "Between the supply and this speed controller: they carry its share of the supply's "
          "current, not the motor's.")
      .source("0: the voltage is that at the speed controller")
      .advanced();
}

}  // namespace

void Describe<EscParameters>::fields(schema::Builder<EscParameters>& b) {
  using P = EscParameters;
  using namespace schema;
  b.title(
      "esc", "Speed controller (ESC)",
      "An averaged converter: v = duty * V - R i at the motor, duty * i from the supply; besides "
      "its resistance, what chopping the voltage costs, the ripple of the current and the leads, "
      "as far as they are given.",
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
  describeThrottle(b);
  describeLosses(b);
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (!(p.throttleStart < p.throttleFull)) {
      problems.push_back(
          {"throttleStart", "is not below the throttle of full duty", "less than throttleFull"});
    }
  });
}

}  // namespace rotorbench
