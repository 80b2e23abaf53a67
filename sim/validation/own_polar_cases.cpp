// Propellers whose sections are known: a full-scale one of the NACA tunnel against its measured
// coefficients, and a large multirotor propeller whose curve is predicted, for users to compare
// their own measurements with.
#include <cmath>

#include "sim/core/constants.h"
#include "sim/core/error.h"
#include "sim/io/csv.h"
#include "sim/validation/cases.h"
#include "sim/validation/propeller_scores.h"
#include "sim/validation/statistics.h"
#include "sim/validation/text.h"

namespace rotorbench::validation {

namespace {

namespace fs = std::filesystem;

/// Of the authors who published both data sets; see SOURCE.txt beside them.
constexpr AirState kAir{1.225, 1.81e-5};

Polar readPolar(const fs::path& file, double reynolds) {
  const CsvTable table = readCsvFile(file);
  const auto alpha = table.values("alpha", "rad"), lift = table.values("cl", "1");
  const auto drag = table.values("cd", "1");
  Polar polar{reynolds, {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    polar.points.push_back({alpha[i], lift[i], drag[i]});
  }
  return polar;
}

void readBlade(const CsvTable& table, PropellerGeometry& g) {
  const auto radius = table.values("radius", "m"), chord = table.values("chord", "m");
  const auto twist = table.values("twist", "rad");
  g.stations.clear();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    g.stations.push_back({2 * radius[i] / g.diameter, 2 * chord[i] / g.diameter, twist[i]});
  }
}

/// NACA TR-594, propeller C.
PropellerGeometry fullScaleGeometry(const fs::path& folder) {
  PropellerGeometry g;
  g.diameter = 3.054;
  g.blades = 3;
  g.pitch = 0;
  g.line = BladeLine::Standard;
  g.rootRadius = 2 * 0.375 / g.diameter;
  readBlade(readCsvFile(folder / "blade.csv"), g);
  PolarSection section;
  section.name = "Clark Y";
  section.polars = {readPolar(folder / "clark_y.csv", 5e5)};
  g.sections = {{0, section}};
  return g;
}

/// T-Motor 28 inch, two blades; each station names its section.
PropellerGeometry largeGeometry(const fs::path& folder) {
  PropellerGeometry g;
  g.diameter = 0.7112;
  g.blades = 2;
  g.pitch = 0;
  g.line = BladeLine::Standard;
  g.rootRadius = 2 * 0.03 / g.diameter;
  const CsvTable blade = readCsvFile(folder / "blade.csv");
  readBlade(blade, g);
  const char* const files[] = {"naca_4412", "goe_450", "goe_408"};
  const char* const names[] = {"NACA 4412", "GOE 450", "GOE 408"};
  const auto sections = blade.values("section", "1");
  g.sections.clear();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!(sections[i] >= 0 && sections[i] < 3)) {
      throw InputError(blade.source, {{"section", "a number is out of range", "0 to 2"}});
    }
    const auto which = static_cast<std::size_t>(sections[i]);
    PolarSection section;
    section.name = names[which];
    section.polars = {readPolar(folder / (std::string(files[which]) + ".csv"), 1e5)};
    g.sections.push_back({g.stations[i].radius, section});
  }
  return g;
}

}  // namespace

CaseResult fullScalePropeller(const fs::path& resources) {
  const fs::path folder = resources / "validation" / "naca_tr594";
  const BladeElementRotor rotor(fullScaleGeometry(folder));
  const CsvTable measured = readCsvFile(folder / "coefficients.csv");
  const auto advance = measured.values("J", "1"), thrust = measured.values("CT", "1");
  const auto power = measured.values("CP", "1");
  constexpr double kSpeed = 1100 * kRpm;
  SvgSeries measuredThrust{"CT measured", SvgSeries::Style::Points, 0, {}};
  SvgSeries measuredPower{"CP measured", SvgSeries::Style::Points, 1, {}};
  SvgSeries modelThrust{"CT computed", SvgSeries::Style::Line, 0, {}};
  SvgSeries modelPower{"CP computed", SvgSeries::Style::Line, 1, {}};
  std::vector<double> thrustErrors, powerErrors;
  for (std::size_t i = 0; i < advance.size(); ++i) {
    const Coefficients c = coefficients(rotor, kSpeed, advance[i], kAir);
    thrustErrors.push_back(100 * (c.thrust - thrust[i]) / thrust.front());
    powerErrors.push_back(100 * (c.power - power[i]) / power.front());
    measuredThrust.points.push_back({advance[i], thrust[i]});
    measuredPower.points.push_back({advance[i], power[i]});
    modelThrust.points.push_back({advance[i], c.thrust});
    modelPower.points.push_back({advance[i], c.power});
  }
  CaseResult result;
  result.key = "naca-tr594";
  result.title = "Full-scale propeller with its own polar";
  result.method =
      "Propeller C of NACA TR-594: 3.054 m, three blades, Clark Y. Its own XFOIL polar at a "
      "Reynolds "
      "number of 500 000 and the global momentum factor, which was chosen with this figure in "
      "view. Root of the mean "
      "square difference over all advance ratios, in percent of the measured static value.";
  result.sources = {
      "T. Theodorsen, G. W. Stickle, M. J. Brevoort, Characteristics of Six Propellers Including "
      "the "
      "High-Speed Range, NACA TR-594, 1937; taken from pyBEMT, K. E. T. Giljarhus, 2020 (MIT)"};
  result.figures = {{"CT, rms over J", Evidence::Fitted, "%", rootMeanSquare(thrustErrors), 4},
                    {"CP, rms over J", Evidence::Fitted, "%", rootMeanSquare(powerErrors), 4}};
  result.charts = {{"NACA TR-594, propeller C",
                    {"Advance ratio J", 0, {}},
                    {"CT, CP", 0, {}},
                    {modelThrust, modelPower, measuredThrust, measuredPower}}};
  return result;
}

CaseResult largePropellerPrediction(const fs::path& resources) {
  const fs::path folder = resources / "validation" / "tmotor28";
  const BladeElementRotor rotor(largeGeometry(folder));
  const CsvTable shipped = readCsvFile(folder / "prediction.csv");
  const auto speed = shipped.values("speed", "rad/s"), thrust = shipped.values("thrust", "N");
  const auto torque = shipped.values("torque", "N m");
  SvgSeries thrustLine{"Thrust, N", SvgSeries::Style::Line, 0, {}};
  SvgSeries powerLine{"Shaft power, W", SvgSeries::Style::Line, 1, {}};
  Table table{"Predicted at rest", {"Speed, rpm", "Thrust, N", "Torque, N m", "Power, W"}, {}};
  double apart = 0;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const AxialLoad load = rotor.axial(speed[i], 0, kAir);
    const double power = load.torque * speed[i];
    apart = std::max({apart, 100 * std::abs(load.thrust / thrust[i] - 1),
                      100 * std::abs(load.torque / torque[i] - 1)});
    thrustLine.points.push_back({speed[i] / kRpm, load.thrust});
    powerLine.points.push_back({speed[i] / kRpm, power});
    table.rows.push_back(
        {fixed(speed[i] / kRpm, 0), fixed(load.thrust, 2), fixed(load.torque, 3), fixed(power, 1)});
  }
  CaseResult result;
  result.key = "tmotor-28in";
  result.title = "T-Motor 28 inch: a prediction";
  result.method =
      "Chord, twist and sections (NACA 4412, GOE 450, GOE 408) as published, polars of XFOIL at a "
      "Reynolds number of 100 000 continued to all angles by their authors, the global momentum "
      "factor, air of 1.225 kg/m\u00b3. Nothing is fitted and nothing measured is shipped: the "
      "curve is "
      "a prediction, to be compared with measurements a user imports. The outermost station holds "
      "to the tip. The figure only says that the shipped curve is what this program computes.";
  result.sources = {"Geometry and polars: pyBEMT, K. E. T. Giljarhus, 2020 (MIT)"};
  result.figures = {
      {"shipped curve against this program, most", Evidence::SelfCheck, "%", apart, 0.1}};
  result.tables = {std::move(table)};
  result.charts = {{"T-Motor 28 inch at rest, predicted: thrust",
                    {"Speed, rpm", 0, {}},
                    {"Thrust, N", 0, {}},
                    {thrustLine}},
                   {"T-Motor 28 inch at rest, predicted: power",
                    {"Speed, rpm", 0, {}},
                    {"Shaft power, W", 0, {}},
                    {powerLine}}};
  return result;
}

}  // namespace rotorbench::validation
