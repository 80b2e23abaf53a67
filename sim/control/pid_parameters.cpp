#include "sim/control/pid_parameters.h"

namespace rotorbench {

namespace {

template <PidUse Use>
void describe(schema::Builder<PidParameters<Use>>& b) {
  using P = PidParameters<Use>;
  using schema::atLeast;
  using schema::upTo;
  constexpr bool kSpeed = Use == PidUse::RotorSpeed;
  b.title("pid", "PID",
          "Discrete PID: the derivative acts on the measurement through a filter, the integral is "
          "kept from "
          "winding up by back-calculation. Its output is an acceleration demand.",
          "Astrom, Murray, Feedback Systems, chapter 10");
  b.number("kp", &P::kp, "Proportional gain", "k_p", kSpeed ? "1/s" : "1/s^2")
      .range(atLeast(0), upTo(1e5))
      .help("Acceleration per error.")
      .live();
  b.number("ki", &P::ki, "Integral gain", "k_i", kSpeed ? "1/s^2" : "1/s^3")
      .range(atLeast(0), upTo(1e6))
      .help("Removes a lasting error; 0 switches it off.")
      .live();
  b.number("kd", &P::kd, "Derivative gain", "k_d", kSpeed ? "1" : "1/s")
      .range(atLeast(0), upTo(1e4))
      .help("Damps the motion: acceleration per rate of the measurement.")
      .live();
  b.number("setPointWeight", &P::setPointWeight, "Set-point weight", "b", "1")
      .range(atLeast(0), upTo(1))
      .help("Part of the set-point the proportional term sees; less overshoots less.")
      .live();
  b.number("filterTime", &P::filterTime, "Derivative filter", "T_f", "s")
      .range(atLeast(0), upTo(10))
      .shownIn("ms")
      .help("Time constant of the first-order filter of the derivative.")
      .live();
  b.number("trackingTime", &P::trackingTime, "Anti-windup time", "T_t", "s")
      .range(schema::above(0), upTo(1000))
      .help("How fast the integral gives way while the demand cannot be met.")
      .advanced()
      .live();
  b.number("limit", &P::limit, "Largest demand", "a_max",
           Use == PidUse::Height ? "m/s^2" : "rad/s^2")
      .range(schema::above(0), upTo(1e6))
      .help("The demand stays between plus and minus this.")
      .advanced()
      .live();
}

}  // namespace

void Describe<PidParameters<PidUse::Height>>::fields(
    schema::Builder<PidParameters<PidUse::Height>>& b) {
  describe(b);
}
void Describe<PidParameters<PidUse::Angle>>::fields(
    schema::Builder<PidParameters<PidUse::Angle>>& b) {
  describe(b);
}
void Describe<PidParameters<PidUse::RotorSpeed>>::fields(
    schema::Builder<PidParameters<PidUse::RotorSpeed>>& b) {
  describe(b);
}

}  // namespace rotorbench
