#include "sim/document/motor_bench.h"

#include "sim/core/rising.h"

namespace rotorbench {

void Describe<ThrottleStep>::fields(schema::Builder<ThrottleStep>& b) {
  b.title("step", "Step", "Throttle from one instant on.");
  b.number("time", &ThrottleStep::time, "Time", "t", "s")
      .range(schema::atLeast(0), schema::upTo(1e6));
  b.number("throttle", &ThrottleStep::throttle, "Throttle", "u", "1")
      .range(schema::atLeast(-1), schema::upTo(1))
      .shownIn("%");
}

void Describe<MotorBench>::fields(schema::Builder<MotorBench>& b) {
  b.title("motor-bench", "Motor bench",
          "A motor with its supply, speed controller and load: throttle steps or ramps over time, "
          "and the "
          "characteristic curves over speed, voltage and throttle.",
          "Thesis 2014, figures 3.14-3.18");
  b.group("stand", &MotorBench::stand, "Drive");
  schema::risingList(b, "throttle", &MotorBench::throttle, "Throttle", &ThrottleStep::time,
                     schema::kRisingTimes, "Negative throttle needs a reversible speed controller.")
      .items(1, 100000)
      .table();
  b.choice("interpolation", &MotorBench::interpolation, "Between the rows", interpolations());
  b.group("run", &MotorBench::run, "Run");
}

}  // namespace rotorbench
