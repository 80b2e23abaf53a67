#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "sim/core/number_text.h"
#include "sim/core/rising.h"
#include "sim/core/schema_tree.h"
#include "sim/document/propeller_bench.h"

namespace rotorbench {

using schema::above;
using schema::atLeast;
using schema::upTo;

namespace {

constexpr double kFastest = 1e5;  // rad/s, as elsewhere

std::string rpm(double speed) {
  return numberText(std::round(speed * 30 / std::numbers::pi)) + " rpm";
}
std::string ratio(double advance) {
  return numberText(std::round(advance * 1000) / 1000);
}

/// A measured propeller's limits against the speeds asked for.
void checkSpeeds(const PropellerBench& p, const CoefficientTable::Limits& limits,
                 std::vector<Problem>& problems) {
  const std::string measured =
      "measured from " + rpm(limits.leastSpeed) + " to " + rpm(limits.mostSpeed);
  if (p.curves.topSpeed <= limits.leastSpeed) {
    problems.push_back({"curves.topSpeed", "the propeller is measured above this speed only",
                        "more than " + rpm(limits.leastSpeed)});
  } else if (p.curves.topSpeed > limits.mostSpeed) {
    problems.push_back({"curves.topSpeed",
                        "the curve of the measured propeller ends at " + rpm(limits.mostSpeed),
                        measured, true});
  }
  if (p.curves.speed < limits.leastSpeed || p.curves.speed > limits.mostSpeed) {
    problems.push_back({"curves.speed",
                        "no coefficients were measured at this speed, those of the nearest hold",
                        measured, true});
  }
  const auto fast = std::ranges::find_if(
      p.speeds, [&](const auto& row) { return std::abs(row.speed) > limits.mostSpeed; });
  if (fast != p.speeds.end()) {
    problems.push_back({"speeds[" + std::to_string(fast - p.speeds.begin()) + "].speed",
                        "is faster than the propeller was measured; the coefficients of " +
                            rpm(limits.mostSpeed) + " hold",
                        measured, true});
  }
}

/// A measured propeller's limits against the advance ratios asked for.
void checkAdvance(const PropellerCurves& curves, const CoefficientTable::Limits& limits,
                  std::vector<Problem>& problems) {
  const std::string measured = "measured from J = " + ratio(limits.leastAdvance) + " to " +
                               ratio(limits.mostAdvance) + " at this speed";
  if (std::max(curves.leastAdvanceRatio, limits.leastAdvance) >=
      std::min(curves.mostAdvanceRatio, limits.mostAdvance)) {
    problems.push_back({"curves.mostAdvanceRatio",
                        "between the advance ratios of the curve nothing was measured", measured});
    return;
  }
  const auto warn = [&](const char* path, const char* verb, double at) {
    problems.push_back(
        {path, std::string("the curve of the measured propeller ") + verb + " at J = " + ratio(at),
         measured, true});
  };
  if (curves.leastAdvanceRatio < limits.leastAdvance)
    warn("curves.leastAdvanceRatio", "begins", limits.leastAdvance);
  if (curves.mostAdvanceRatio > limits.mostAdvance)
    warn("curves.mostAdvanceRatio", "ends", limits.mostAdvance);
}

/// What a measured propeller cannot answer.
void checkMeasured(const PropellerBench& p, const MeasuredPropeller& propeller,
                   std::vector<Problem>& problems) {
  // Rules are asked of documents with faults too, and no table can be made of points that have
  // some.
  const auto faults = schema::validate(schema::ref(propeller));
  if (std::ranges::any_of(faults, [](const Problem& f) { return !f.warning; })) return;
  const CoefficientTable::Limits limits = CoefficientTable(propeller).limits(p.curves.speed);
  checkSpeeds(p, limits, problems);
  checkAdvance(p.curves, limits, problems);
}

/// The curves of a lumped propeller over J, if nothing says what climb does to it.
void checkLumped(const RotorInflow& inflow, const std::string& path,
                 std::vector<Problem>& problems) {
  if (inflow.inflow != 0) return;
  problems.push_back({path + ".inflow.inflow",
                      "without an inflow loss the coefficients at rest hold at every advance ratio",
                      "above 0, or another model for the curves over J", true});
}

struct CheckPropeller {
  const PropellerBench& bench;
  std::string path;
  std::vector<Problem>& problems;

  void operator()(const NoPropeller& /*p*/) const {}
  void operator()(const BladeElementSpecimen& /*p*/) const {}
  void operator()(const MapPropeller& /*p*/) const {}
  void operator()(const MeasuredPropeller& p) const { checkMeasured(bench, p, problems); }
  void operator()(const PropellerCoefficients& p) const { checkLumped(p.inflow, path, problems); }
  void operator()(const RotorCoefficients& p) const { checkLumped(p.inflow, path, problems); }
};

}  // namespace

void Describe<NoPropeller>::fields(schema::Builder<NoPropeller>& b) {
  b.title("no-propeller", "None", "Nothing to compare with.");
}

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
  schema::risingList(b, "rows", &P::rows, "Air speed", &AirSpeedRow::time, schema::kRisingTimes)
      .items(1, 100000)
      .table();
  b.choice("interpolation", &P::interpolation, "Between the rows", interpolations());
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
          "A propeller alone, by any rotor model, at prescribed speed and air speed: thrust and "
          "torque over time, over speed and advance ratio, along the blade and in an edgewise "
          "stream.",
          "Thesis 2014, figures 3.19-3.20");
  b.variant("propeller", &P::propeller, "Propeller");
  b.variant("second", &P::second, "Second propeller")
      .help(
          "Goes through the same in the same run, for comparison: another propeller, or the same "
          "one by another model.");
  b.number("airDensity", &P::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(atLeast(0), upTo(10))
      .source("International standard atmosphere at sea level");
  b.number("airViscosity", &P::airViscosity, "Air viscosity", "\u03bc", "Pa*s")
      .range(atLeast(1e-7), upTo(1))
      .source("Sutherland's law at 15 degrees Celsius")
      .advanced();
  schema::risingList(b, "speeds", &P::speeds, "Speed", &PropellerSpeedRow::time,
                     schema::kRisingTimes)
      .items(1, 100000)
      .table();
  b.choice("interpolation", &P::interpolation, "Between the rows", interpolations());
  b.variant("stream", &P::stream, "Air speed");
  b.group("curves", &P::curves, "Curves");
  b.group("run", &P::run, "Run");
  b.check([](const P& p, std::vector<Problem>& problems) {
    std::visit(CheckPropeller{p, "propeller", problems}, p.propeller);
    std::visit(CheckPropeller{p, "second", problems}, p.second);
  });
}

std::vector<BenchPropeller> propellersOn(const PropellerBench& bench) {
  std::vector<BenchPropeller> propellers{bench.propeller};
  std::visit(
      [&](const auto& second) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(second)>, NoPropeller>)
          propellers.emplace_back(second);
      },
      bench.second);
  return propellers;
}

RotorAerodynamics aerodynamicsOf(const BenchPropeller& propeller) {
  return std::visit(
      [](const auto& p) -> RotorAerodynamics {
        if constexpr (std::is_same_v<std::decay_t<decltype(p)>, BladeElementSpecimen>)
          return BladeElementPropeller{p.geometry, p.settings};
        else
          return p;
      },
      propeller);
}

}  // namespace rotorbench
