#include "sim/document/controlled_inputs.h"

#include <numbers>

#include "sim/core/box_members.h"
#include "sim/core/rising.h"

namespace rotorbench {

using schema::atLeast;
using schema::upTo;

namespace {

using std::numbers::pi;
// Beyond 60 degrees a vehicle that holds its height needs more than twice its hover thrust.
constexpr double kMostAskedTilt = pi / 3;
constexpr double kMostYaw = 20 * pi;

template <class T>
void height(schema::Builder<T>& b) {
  b.number("height", &T::height, "Height", "z", "m").range(atLeast(-1e5), upTo(1e5)).live();
}

template <class T>
void angle(schema::Builder<T>& b, const char* key, double T::*member, const char* label,
           const char* symbol, double most) {
  b.number(key, member, label, symbol, "rad")
      .range(atLeast(-most), upTo(most))
      .shownIn("deg")
      .live();
}

void byHand(schema::Builder<HandSetPoints>& b, const char* key, bool HandSetPoints::*member,
            const char* label) {
  b.boolean(key, member, label)
      .help("While it is on, this set-point is the one below and not the timeline's.")
      .live();
}

}  // namespace

void Describe<SetPointRow>::fields(schema::Builder<SetPointRow>& b) {
  using P = SetPointRow;
  b.title("row", "Set-points", "Set-points from one instant on.");
  b.number("time", &P::time, "Time", "t", "s").range(atLeast(0), upTo(1e6)).live();
  height(b);
  angle(b, "roll", &P::roll, "Roll", "φ", kMostAskedTilt);
  angle(b, "pitch", &P::pitch, "Pitch", "θ", kMostAskedTilt);
  angle(b, "yaw", &P::yaw, "Yaw", "ψ", kMostYaw);
}

void Describe<HandSetPoints>::fields(schema::Builder<HandSetPoints>& b) {
  using P = HandSetPoints;
  b.title("byHand", "By hand",
          "Set-points that a person or a program holds instead of the timeline, from the start or "
          "while the flight goes on.");
  byHand(b, "heightByHand", &P::heightByHand, "Height by hand");
  height(b);
  byHand(b, "rollByHand", &P::rollByHand, "Roll by hand");
  angle(b, "roll", &P::roll, "Roll", "φ", kMostAskedTilt);
  byHand(b, "pitchByHand", &P::pitchByHand, "Pitch by hand");
  angle(b, "pitch", &P::pitch, "Pitch", "θ", kMostAskedTilt);
  byHand(b, "yawByHand", &P::yawByHand, "Yaw by hand");
  angle(b, "yaw", &P::yaw, "Yaw", "ψ", kMostYaw);
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
  b.group("byHand", &ControlledInputs::byHand, "By hand");
}

template class Box<ControlledInputs>;

}  // namespace rotorbench
