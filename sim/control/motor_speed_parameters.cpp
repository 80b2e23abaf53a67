#include "sim/control/motor_speed_parameters.h"

namespace rotorbench {

void Describe<MotorSpeedParameters>::fields(schema::Builder<MotorSpeedParameters>& b) {
  using P = MotorSpeedParameters;
  b.title("motor-speed", "Motor speed controller",
          "PID on the speed of each rotor with limits of voltage and current.",
          "Thesis 2014, figures 4.7-4.9");
  b.number("rate", &P::rate, "Rate", "", "Hz")
      .range(schema::above(0), schema::upTo(1e6))
      .help("Updates per second; must divide the tick rate of the simulation.");
  b.group("pid", &P::pid, "Speed PID");
  b.boolean("feedForward", &P::feedForward, "Feed-forward")
      .help("Adds the voltage the wanted speed needs in the steady state.");
}

}  // namespace rotorbench
