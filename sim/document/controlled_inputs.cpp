#include "sim/document/controlled_inputs.h"

#include <numbers>

#include "sim/core/box_members.h"
#include "sim/core/rising.h"

namespace rotorbench {

using schema::atLeast;
using schema::upTo;

void Describe<SetPointRow>::fields(schema::Builder<SetPointRow>& b) {
  using std::numbers::pi;
  b.title("row", "Set-points", "Set-points from one instant on.");
  b.number("time", &SetPointRow::time, "Time", "t", "s").range(atLeast(0), upTo(1e6));
  b.number("height", &SetPointRow::height, "Height", "z", "m").range(atLeast(-1e5), upTo(1e5));
  // Beyond 60 degrees a vehicle that holds its height needs more than twice its hover thrust.
  b.number("roll", &SetPointRow::roll, "Roll", "φ", "rad")
      .range(atLeast(-pi / 3), upTo(pi / 3))
      .shownIn("deg");
  b.number("pitch", &SetPointRow::pitch, "Pitch", "θ", "rad")
      .range(atLeast(-pi / 3), upTo(pi / 3))
      .shownIn("deg");
  b.number("yaw", &SetPointRow::yaw, "Yaw", "ψ", "rad")
      .range(atLeast(-20 * pi), upTo(20 * pi))
      .shownIn("deg");
}

void Describe<ControlledInputs>::fields(schema::Builder<ControlledInputs>& b) {
  b.title(
      "controlled", "Controller",
      "A flight controller follows set-points and asks rotor speeds of motor speed controllers.",
      "Thesis 2014, section 4.2");
  // Until there was a second controller, the way of control was named for the first, and the motors
  // were its own.
  b.formerly("pid");
  b.moved("controller.motors", "motors");
  b.variant("controller", &ControlledInputs::controller, "Controller").untyped();
  b.group("motors", &ControlledInputs::motors, "Motor speed controllers");
  schema::risingList(b, "setPoints", &ControlledInputs::setPoints, "Timeline", &SetPointRow::time,
                     schema::kRisingTimes, "Set-points over time.")
      .items(1, 100000)
      .table();
  b.choice("interpolation", &ControlledInputs::interpolation, "Between the rows", interpolations());
}

template class Box<ControlledInputs>;

}  // namespace rotorbench
