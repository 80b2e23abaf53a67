#include "sim/document/motor_speed_run.h"

#include "sim/core/rising.h"

namespace rotorbench {

void Describe<SpeedStep>::fields(schema::Builder<SpeedStep>& b) {
  b.title("step", "Step", "Set-point from one instant on.");
  b.number("time", &SpeedStep::time, "Time", "t", "s").range(schema::atLeast(0), schema::upTo(1e6));
  b.number("speed", &SpeedStep::speed, "Speed", "\u03a9", "rad/s")
      .range(schema::atLeast(0), schema::upTo(1e5))
      .shownIn("rpm");
}

void Describe<MotorSpeedRun>::fields(schema::Builder<MotorSpeedRun>& b) {
  b.title("motor-speed-control", "Motor speed control",
          "A speed controller keeps a motor at its set-point, within the limits of voltage and "
          "current.",
          "Thesis 2014, experiment 5, figures 4.7-4.9");
  b.group("stand", &MotorSpeedRun::stand, "Drive");
  b.group("controller", &MotorSpeedRun::controller, "Speed controller");
  schema::risingList(b, "setPoints", &MotorSpeedRun::setPoints, "Set-points", &SpeedStep::time,
                     schema::kRisingTimes)
      .items(1, 100000)
      .table();
  b.boolean("compareUnsaturated", &MotorSpeedRun::compareUnsaturated, "Compare without saturation")
      .help(
          "Runs the same steps a second time with a drive that gives any voltage and any current.");
  b.group("run", &MotorSpeedRun::run, "Run");
}

}  // namespace rotorbench
