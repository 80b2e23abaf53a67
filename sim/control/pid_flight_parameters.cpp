#include "sim/control/pid_flight_parameters.h"

namespace rotorbench {

void Describe<PidFlightParameters>::fields(schema::Builder<PidFlightParameters>& b) {
  using P = PidFlightParameters;
  b.title(
      "pid", "PID (controller 1)",
      "Holds altitude, roll, pitch and yaw with one PID each; rotor speeds follow by motor speed "
      "controllers. Sideways drift is not controlled.",
      "Thesis 2014, figures 4.2-4.3");
  b.number("rate", &P::rate, "Rate", "", "Hz")
      .range(schema::above(0), schema::upTo(1e5))
      .help(
          "Updates per second of altitude and attitude; must divide the tick rate of the "
          "simulation.");
  b.group("altitude", &P::altitude, "Altitude");
  b.group("roll", &P::roll, "Roll");
  b.group("pitch", &P::pitch, "Pitch");
  b.group("yaw", &P::yaw, "Yaw");
}

}  // namespace rotorbench
