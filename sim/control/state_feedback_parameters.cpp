#include "sim/control/state_feedback_parameters.h"

namespace rotorbench {

namespace {

using schema::above;
using schema::atLeast;
using schema::upTo;

template <PidUse Use>
constexpr bool isHeight = Use == PidUse::Height;

template <class P>
void describeLimit(schema::Builder<P>& b, const char* unit) {
  b.number("limit", &P::limit, "Largest demand", "a_max", unit)
      .range(above(0), upTo(1e6))
      .help("The demand stays between plus and minus this.")
      .advanced()
      .live();
}

template <PidUse Use>
void describePoles(schema::Builder<AxisPoles<Use>>& b) {
  using P = AxisPoles<Use>;
  b.title(
      "poles", "Poles",
      "Where the closed loop of this axis has its poles: a pair, and a real one for the integral. "
      "Its gains follow by Ackermann's formula on the model with hold and lag.",
      "Ackermann, Der Entwurf linearer Regelungssysteme im Zustandsraum, 1972");
  b.number("frequency", &P::frequency, "Frequency of the pair", "ω", "rad/s")
      .range(above(0), upTo(1e3))
      .help("Distance of the pair from the origin: faster is larger.")
      .live();
  b.number("damping", &P::damping, "Damping of the pair", "ζ", "1")
      .range(above(0), upTo(10))
      .help("Above 1 the pair is two real poles.")
      .live();
  b.number("integral", &P::integral, "Pole of the integral", "p", "1/s")
      .range(above(0), upTo(1e3))
      .help("The integral's real pole is at minus this; the set-point does not excite it.")
      .live();
  describeLimit(b, isHeight<Use> ? "m/s^2" : "rad/s^2");
}

template <PidUse Use>
void describeWeights(schema::Builder<AxisWeights<Use>>& b) {
  using P = AxisWeights<Use>;
  b.title(
      "weights", "Weights",
      "The largest deviations that are acceptable: each costs one over its square. Smaller ones "
      "make the controller care more.",
      "Bryson, Ho, Applied Optimal Control, 1975");
  b.number("error", &P::error, "Error", "", isHeight<Use> ? "m" : "rad")
      .range(above(0), upTo(1e4))
      .shownIn(isHeight<Use> ? "m" : "deg")
      .live();
  b.number("rate", &P::rate, "Rate", "", isHeight<Use> ? "m/s" : "rad/s")
      .range(above(0), upTo(1e4))
      .shownIn(isHeight<Use> ? "m/s" : "deg/s")
      .live();
  b.number("integral", &P::integral, "Integral of the error", "", isHeight<Use> ? "m*s" : "rad*s")
      .range(above(0), upTo(1e4))
      .help("How long an error may last.")
      .live();
  b.number("demand", &P::demand, "Demand", "", isHeight<Use> ? "m/s^2" : "rad/s^2")
      .range(above(0), upTo(1e6))
      .help("Larger lets the rotors work harder.")
      .live();
  describeLimit(b, isHeight<Use> ? "m/s^2" : "rad/s^2");
}

template <class P>
void describeRate(schema::Builder<P>& b) {
  b.number("rate", &P::rate, "Rate", "", "Hz")
      .range(above(0), upTo(1e5))
      .help("Updates per second; must divide the tick rate of the simulation.");
}

template <class P>
void describeLag(schema::Builder<P>& b) {
  b.number("thrustLag", &P::thrustLag, "Lag of the thrust", "T", "s")
      .range(atLeast(0), upTo(10))
      .shownIn("ms")
      .help(
          "Time constant with which the rotors' thrust follows its demand, in the model the gains "
          "are designed for; what it gives at each instant is then fed back too. 0: at once.")
      .live();
}

template <class P>
void describeAxes(schema::Builder<P>& b) {
  b.group("altitude", &P::altitude, "Altitude");
  b.group("roll", &P::roll, "Roll");
  b.group("pitch", &P::pitch, "Pitch");
  b.group("yaw", &P::yaw, "Yaw");
}

}  // namespace

void Describe<AxisPoles<PidUse::Height>>::fields(schema::Builder<AxisPoles<PidUse::Height>>& b) {
  describePoles(b);
}
void Describe<AxisPoles<PidUse::Angle>>::fields(schema::Builder<AxisPoles<PidUse::Angle>>& b) {
  describePoles(b);
}
void Describe<AxisWeights<PidUse::Height>>::fields(
    schema::Builder<AxisWeights<PidUse::Height>>& b) {
  describeWeights(b);
}
void Describe<AxisWeights<PidUse::Angle>>::fields(schema::Builder<AxisWeights<PidUse::Angle>>& b) {
  describeWeights(b);
}

void Describe<StateFeedbackParameters>::fields(schema::Builder<StateFeedbackParameters>& b) {
  using P = StateFeedbackParameters;
  b.title("state-feedback", "State feedback (controller 2)",
          "Holds altitude, roll, pitch and yaw by feeding back position and rate of each axis with "
          "gains that place its poles. Sideways drift is not controlled.",
          "Thesis 2014, figures 4.4-4.6");
  describeRate(b);
  b.choice("stage", &P::stage, "Stage",
           {{FeedbackStage::Plain, "plain", "Plain feedback",
             "u = K (r - x): a lasting disturbance leaves a lasting error."},
            {FeedbackStage::Integral, "integral", "With integral action",
             "The integral of the error removes it; while a demand cannot be met it winds up."},
            {FeedbackStage::Final, "final", "With limits and anti-windup",
             "The demand has limits, and what cannot be met bleeds the integral."}})
      .live();
  describeLag(b);
  describeAxes(b);
}

void Describe<LqrParameters>::fields(schema::Builder<LqrParameters>& b) {
  using P = LqrParameters;
  b.title(
      "lqr", "Linear-quadratic regulator",
      "Holds altitude, roll, pitch and yaw by state feedback with the gains of least cost, with "
      "integral action (LQI) or without (LQR). Sideways drift is not controlled.",
      "Kalman, Contributions to the theory of optimal control, 1960");
  describeRate(b);
  b.boolean("integral", &P::integral, "Integral action")
      .help("Removes lasting errors; it does not wind up.")
      .live();
  describeLag(b);
  describeAxes(b);
}

}  // namespace rotorbench
