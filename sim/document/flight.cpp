#include "sim/document/flight.h"

#include "sim/document/controlled_inputs.h"

namespace rotorbench {

void Describe<Flight>::fields(schema::Builder<Flight>& b) {
  b.title("flight", "Flight",
          "A multirotor flown by a controller or by inputs laid down in advance.");
  b.group("vehicle", &Flight::vehicle, "Vehicle");
  b.variant("control", &Flight::control, "Control");
  b.variant("sensors", &Flight::sensors, "Sensors");
  b.group("environment", &Flight::environment, "Environment");
  b.group("start", &Flight::start, "Start");
  b.group("solver", &Flight::solver, "Solver");
  b.number("tick", &Flight::tick, "Tick", "", "s")
      .range(schema::atLeast(1e-6), schema::upTo(1))
      .shownIn("ms")
      .help(
          "Period of the fastest task: commands are held for this long, and the solver ends a step "
          "at its end.");
  b.number("duration", &Flight::duration, "Duration", "T", "s")
      .range(schema::above(0), schema::upTo(36000));
  b.check([](const Flight& f, std::vector<Problem>& problems) {
    if (f.tick > f.duration)
      problems.push_back({"tick", "is longer than the flight", "at most the duration"});
  });
}

}  // namespace rotorbench
