#include <string>

#include "sim/experiment/propeller_bench.h"

namespace rotorbench {

using schema::above;
using schema::atLeast;
using schema::upTo;

namespace {

constexpr double kFastest = 1e5;  // rad/s, as elsewhere

template <class Row>
void checkTimes(const std::vector<Row>& rows, const std::string& name,
                std::vector<Problem>& problems) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].time <= rows[i - 1].time)
      problems.push_back({name + "[" + std::to_string(i) + "].time",
                          "is not later than the row before", "times must rise from row to row"});
  }
}

}  // namespace

void Describe<BladeElementSpecimen>::fields(schema::Builder<BladeElementSpecimen>& b) {
  using P = BladeElementSpecimen;
  b.title("blade-element", "Blade elements",
          "Computed from geometry and sections, in momentum inflow.");
  b.group("geometry", &P::geometry, "Geometry");
  b.group("settings", &P::settings, "Blade elements");
}

void Describe<PropellerSpeedRow>::fields(schema::Builder<PropellerSpeedRow>& b) {
  using P = PropellerSpeedRow;
  b.title("row", "Row", "Speed from one instant on.");
  b.number("time", &P::time, "Time", "t", "s").range(atLeast(0), upTo(1e6));
  b.number("speed", &P::speed, "Speed", "\u03a9", "rad/s")
      .range(atLeast(-kFastest), upTo(kFastest))
      .shownIn("rpm");
}

void Describe<AirSpeedRow>::fields(schema::Builder<AirSpeedRow>& b) {
  b.title("row", "Row", "Air speed from one instant on.");
  b.number("time", &AirSpeedRow::time, "Time", "t", "s").range(atLeast(0), upTo(1e6));
  b.number("speed", &AirSpeedRow::speed, "Air speed", "V", "m/s").range(atLeast(-300), upTo(300));
}

void Describe<SteadyStream>::fields(schema::Builder<SteadyStream>& b) {
  b.title("steady", "Steady", "The same air speed from start to end.");
  b.number("speed", &SteadyStream::speed, "Air speed", "V", "m/s")
      .range(atLeast(-300), upTo(300))
      .help("Along the axis: positive in climb, negative in descent.");
}

void Describe<StreamProfile>::fields(schema::Builder<StreamProfile>& b) {
  using P = StreamProfile;
  b.title("profile", "Over time", "Air speed along the axis over time, positive in climb.");
  b.list("rows", &P::rows, "Air speed")
      .items(1, 100000)
      .table()
      .help("Times must rise from row to row.");
  b.choice("interpolation", &P::interpolation, "Between the rows", detail::interpolations());
  b.check([](const P& p, std::vector<Problem>& problems) { checkTimes(p.rows, "rows", problems); });
}

void Describe<PropellerCurves>::fields(schema::Builder<PropellerCurves>& b) {
  using P = PropellerCurves;
  b.title("propeller-curves", "Curves", "Where the curves beside the run in time are taken.");
  b.number("speed", &P::speed, "Speed", "\u03a9", "rad/s")
      .range(above(0), upTo(kFastest))
      .shownIn("rpm")
      .help("Of the curves over advance ratio and edgewise stream and of those along the blade.");
  b.number("airSpeed", &P::airSpeed, "Axial air speed", "V", "m/s")
      .range(atLeast(-300), upTo(300))
      .help("Of the curves over speed and edgewise stream and of those along the blade.");
  b.number("topSpeed", &P::topSpeed, "Highest speed", "", "rad/s")
      .range(above(0), upTo(kFastest))
      .shownIn("rpm")
      .help("Where the curve over the speed ends.");
  b.number("leastAdvanceRatio", &P::leastAdvanceRatio, "Lowest advance ratio", "J", "1")
      .range(atLeast(-10), upTo(10))
      .help("V/(n D); negative in descent.");
  b.number("mostAdvanceRatio", &P::mostAdvanceRatio, "Highest advance ratio", "J", "1")
      .range(atLeast(-10), upTo(10));
  b.number("mostEdgewiseRatio", &P::mostEdgewiseRatio, "Highest edgewise ratio", "\u03bc", "1")
      .range(above(0), upTo(2))
      .help("Air speed in the plane of rotation over the speed of the tips.");
  b.integer("points", &P::points, "Points").range(atLeast(2), upTo(5000)).advanced();
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.mostAdvanceRatio <= p.leastAdvanceRatio)
      problems.push_back(
          {"mostAdvanceRatio", "is not above the lowest advance ratio", "more than the lowest"});
  });
}

void Describe<PropellerRunSettings>::fields(schema::Builder<PropellerRunSettings>& b) {
  using P = PropellerRunSettings;
  b.title("propeller-run", "Run", "How long and how finely.");
  b.number("tick", &P::tick, "Tick", "", "s")
      .range(atLeast(1e-6), upTo(1))
      .shownIn("ms")
      .help("The propeller is solved once a tick.");
  b.number("duration", &P::duration, "Duration", "T", "s").range(above(0), upTo(36000));
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.tick > p.duration)
      problems.push_back({"tick", "is longer than the run", "at most the duration"});
  });
}

void Describe<PropellerBench>::fields(schema::Builder<PropellerBench>& b) {
  using P = PropellerBench;
  b.title("propeller-bench", "Propeller bench",
          "A propeller alone at prescribed speed and air speed: thrust and torque over time, over "
          "speed and advance ratio, along the blade and in an edgewise stream.",
          "Thesis 2014, figures 3.19-3.20");
  b.variant("propeller", &P::propeller, "Propeller");
  b.number("airDensity", &P::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(atLeast(0), upTo(10))
      .source("International standard atmosphere at sea level");
  b.number("airViscosity", &P::airViscosity, "Air viscosity", "\u03bc", "Pa*s")
      .range(atLeast(1e-7), upTo(1))
      .source("Sutherland's law at 15 degrees Celsius")
      .advanced();
  b.list("speeds", &P::speeds, "Speed")
      .items(1, 100000)
      .table()
      .help("Times must rise from row to row.");
  b.choice("interpolation", &P::interpolation, "Between the rows", detail::interpolations());
  b.variant("stream", &P::stream, "Air speed");
  b.group("curves", &P::curves, "Curves");
  b.group("run", &P::run, "Run");
  b.check(
      [](const P& p, std::vector<Problem>& problems) { checkTimes(p.speeds, "speeds", problems); });
}

}  // namespace rotorbench
