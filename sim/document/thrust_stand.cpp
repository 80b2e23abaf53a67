#include "sim/document/thrust_stand.h"

#include "sim/core/rising.h"

namespace rotorbench {

using schema::above;
using schema::atLeast;
using schema::upTo;

void Describe<ThrottleLevel>::fields(schema::Builder<ThrottleLevel>& b) {
  b.title("level", "Level", "A throttle that is held.");
  b.number("throttle", &ThrottleLevel::throttle, "Throttle", "u", "1")
      .range(atLeast(0), upTo(1))
      .shownIn("%");
}

void Describe<ThrottleLevels>::fields(schema::Builder<ThrottleLevels>& b) {
  using P = ThrottleLevels;
  b.title("levels", "Steps", "One level after the other, each held equally long.");
  b.list("levels", &P::levels, "Levels").items(1, 1000).table();
  b.number("holdTime", &P::holdTime, "Hold", "", "s")
      .range(above(0), upTo(3600))
      .help("Each level is held for this long and read at its end.");
}

void Describe<ThrottleSweep>::fields(schema::Builder<ThrottleSweep>& b) {
  using P = ThrottleSweep;
  b.title("sweep", "Slow sweep", "A straight ramp of the throttle.");
  b.number("from", &P::from, "From", "", "1").range(atLeast(0), upTo(1)).shownIn("%");
  b.number("to", &P::to, "To", "", "1").range(atLeast(0), upTo(1)).shownIn("%");
  b.number("duration", &P::duration, "Duration", "T", "s").range(above(0), upTo(36000));
  b.integer("readings", &P::readings, "Readings")
      .range(atLeast(1), upTo(1000))
      .help("Instants, equally spread, at which the drive is compared with its steady point.");
}

void Describe<ThrottleRows>::fields(schema::Builder<ThrottleRows>& b) {
  using P = ThrottleRows;
  b.title("rows", "Timeline", "Any steps or ramps.");
  schema::risingList(b, "rows", &P::rows, "Throttle", &ThrottleStep::time, schema::kRisingTimes,
                     "Read where a row ends.")
      .items(1, 100000)
      .table();
  b.choice("interpolation", &P::interpolation, "Between the rows", interpolations());
  b.number("duration", &P::duration, "Duration", "T", "s").range(above(0), upTo(36000));
}

void Describe<StandRunSettings>::fields(schema::Builder<StandRunSettings>& b) {
  using P = StandRunSettings;
  b.title("stand-run", "Run", "How finely. How long is up to the procedure.");
  b.group("solver", &P::solver, "Solver");
  b.number("tick", &P::tick, "Tick", "", "s")
      .range(atLeast(1e-6), upTo(1))
      .shownIn("ms")
      .help("The throttle is held for this long, and the solver ends a step at its end.");
  b.check([](const P& p, std::vector<Problem>& problems) { checkDriveMethod(p.solver, problems); });
}

void Describe<ThrustStand>::fields(schema::Builder<ThrustStand>& b) {
  b.title("thrust-stand", "Thrust stand",
          "Battery, speed controller, motor and propeller through throttle steps or a sweep: "
          "thrust, speed, voltage, current, power and thrust per power, reached and solved "
          "directly.",
          "Thesis 2014, figures 3.14-3.20");
  b.group("stand", &ThrustStand::stand, "Drive");
  b.variant("procedure", &ThrustStand::procedure, "Procedure");
  b.group("run", &ThrustStand::run, "Run");
  b.check([](const ThrustStand& s, std::vector<Problem>& problems) {
    const auto& load = s.stand.load;
    if (std::holds_alternative<BrakeLoad>(load) || std::holds_alternative<FreeShaft>(load))
      problems.push_back({"stand.load", "is no propeller, so that there is no thrust to measure",
                          "a propeller; the motor bench takes any load"});
    if (durationOf(s.procedure) < s.run.tick)
      problems.push_back({"run.tick", "is longer than the run", "at most the procedure"});
  });
}

double durationOf(const ThrottleProcedure& procedure) {
  if (const auto* steps = std::get_if<ThrottleLevels>(&procedure))
    return static_cast<double>(steps->levels.size()) * steps->holdTime;
  if (const auto* sweep = std::get_if<ThrottleSweep>(&procedure)) return sweep->duration;
  return std::get<ThrottleRows>(procedure).duration;
}

}  // namespace rotorbench
