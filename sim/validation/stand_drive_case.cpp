// A drive at part throttle: speed controller and motor identified on one log of a thrust stand,
// and the log of the same stand with another propeller predicted from throttle and voltage. The
// propellers are known from a wind tunnel, so that only the drive is put to the test; by blade
// elements the whole chain is.
#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"
#include "sim/core/error.h"
#include "sim/io/csv.h"
#include "sim/propulsion/rotor/blade_element.h"
#include "sim/propulsion/rotor/lumped_rotor.h"
#include "sim/validation/cases.h"
#include "sim/validation/drive_fit.h"
#include "sim/validation/statistics.h"
#include "sim/validation/text.h"
#include "sim/validation/uiuc_data.h"

namespace rotorbench::validation {

namespace {

namespace fs = std::filesystem;

constexpr double kDensity = 1.19;  // kg/m^3, of the authors of the log
constexpr int kSpeeds = 64;
constexpr double kTopSpeed = 1000;  // rad/s, above every logged one

std::vector<LoggedPoint> readPlateaus(const fs::path& file) {
  constexpr double kZero = 1000, kFull = 1000;  // us: signal of no throttle, and to full throttle
  const CsvTable table = readCsvFile(file);
  const auto signal = table.values("signal", "us"), voltage = table.values("voltage", "V");
  const auto current = table.values("current", "A"), speed = table.values("speed", "rad/s");
  const auto thrust = table.values("thrust", "N");
  std::vector<LoggedPoint> points;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    points.push_back({(signal[i] - kZero) / kFull, voltage[i], current[i], speed[i], thrust[i]});
  }
  return points;
}

/// A static coefficient over the speed: linear between measured ones, beyond them along the
/// straight line through the last eight.
double coefficientAt(const PropellerSet& set, double PropellerPoint::*which, double speed) {
  const auto& rows = set.still;
  if (speed <= rows.front().speed) return rows.front().*which;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const PropellerPoint &a = rows[i - 1], &b = rows[i];
    if (speed > b.speed) continue;
    return a.*which + (speed - a.speed) / (b.speed - a.speed) * (b.*which - a.*which);
  }
  constexpr std::size_t kLast = 8;
  const std::size_t first = rows.size() - std::min(kLast, rows.size());
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = first; i < rows.size(); ++i) {
    n += 1, x += rows[i].speed, y += rows[i].*which;
    xx += rows[i].speed * rows[i].speed, xy += rows[i].speed * rows[i].*which;
  }
  const double slope = (n * xy - x * y) / (n * xx - x * x);
  return (y - slope * x) / n + slope * speed;
}

ShaftLoad tunnelLoad(const PropellerSet& set) {
  ShaftLoad load;
  load.quadratic = load.thrust = {kTopSpeed / kSpeeds, {}};
  for (int k = 0; k <= kSpeeds; ++k) {
    const double w = kTopSpeed * k / kSpeeds;
    const SquareFactors factors =
        squareFactors(coefficientAt(set, &PropellerPoint::thrust, w),
                      coefficientAt(set, &PropellerPoint::power, w), set.geometry.diameter);
    load.quadratic.values.push_back(kDensity * factors.torque);
    load.thrust.values.push_back(kDensity * factors.thrust);
  }
  return load;
}

ShaftLoad bladeElementLoad(const PropellerGeometry& geometry) {
  const BladeElementRotor rotor(geometry);
  ShaftLoad load;
  load.quadratic = load.thrust = {kTopSpeed / kSpeeds, {}};
  for (int k = 0; k <= kSpeeds; ++k) {
    const double w = kTopSpeed * std::max(k, 1) / kSpeeds;
    const AxialLoad at = rotor.axial(w, 0, {kDensity, kAirViscosity});
    load.quadratic.values.push_back(at.torque / (w * w));
    load.thrust.values.push_back(at.thrust / (w * w));
  }
  return load;
}

const PropellerSet& named(const std::vector<PropellerSet>& sets, const char* name) {
  const auto found = std::ranges::find(sets, name, &PropellerSet::propeller);
  if (found == sets.end()) throw InputError("uiuc", {{name, "is not among the propellers", {}}});
  return *found;
}

/// 1100 rpm/V and 0.8 A as published; the rest are starts: half of the supply's resistance would
/// do, 25 uH at 8 kHz are common.
DriveConstants startOf(ShaftLoad load) {
  DriveConstants c;
  c.torqueConstant = 1 / (1100 * kRpm);
  c.noLoadCurrent = 0.8;
  c.resistance = 0.1;
  c.throttleStart = 0.1;
  c.throttleFull = 0.8;
  c.ripple = 1 / (25e-6 * 8000);
  c.switchingLoss = 0.05;
  c.activeBraking = false;
  c.load = std::move(load);
  return c;
}

struct Errors {
  double speed = 0, current = 0, thrust = 0;  // %, greatest
};

Errors compare(const std::vector<LoggedPoint>& points, const DriveConstants& constants,
               Table* table, std::vector<SvgSeries>* lines) {
  Errors e;
  for (const LoggedPoint& p : points) {
    const DrivePrediction m = predicted(constants, p.throttle, p.voltage);
    const double speed = apart(m.speed, p.speed), current = apart(m.current, p.current);
    const double thrust = apart(m.thrust, p.thrust);
    e.speed = std::max(e.speed, std::abs(speed));
    e.current = std::max(e.current, std::abs(current));
    e.thrust = std::max(e.thrust, std::abs(thrust));
    if (table != nullptr) {
      table->rows.push_back({fixed(100 * p.throttle, 1), fixed(p.voltage, 2),
                             fixed(p.speed / kRpm, 0), fixed(speed, 1), fixed(p.current, 2),
                             fixed(current, 1), fixed(p.thrust, 2), fixed(thrust, 1)});
    }
    if (lines != nullptr) {
      (*lines)[0].points.push_back({100 * p.throttle, m.current});
      (*lines)[1].points.push_back({100 * p.throttle, m.thrust});
      (*lines)[2].points.push_back({100 * p.throttle, p.current});
      (*lines)[3].points.push_back({100 * p.throttle, p.thrust});
    }
  }
  return e;
}

Table constantsTable(const DriveConstants& c) {
  return {
      "Constants of the drive, from the log with the 11 x 4.7",
      {"R, m\u03a9", "Throttle of no duty, %", "Throttle of full duty, %", "L f, \u03a9",
       "Switching loss k_s, %"},
      {{fixed(1000 * c.resistance, 0), fixed(100 * c.throttleStart, 1),
        fixed(100 * c.throttleFull, 1), fixed(1 / c.ripple, 3), fixed(100 * c.switchingLoss, 1)}}};
}

}  // namespace

CaseResult standAtPartThrottle(const fs::path& resources) {
  const fs::path folder = resources / "validation" / "stand_x2216";
  const auto known = readPlateaus(folder / "plateaus_11x4.7.csv");
  const auto asked = readPlateaus(folder / "plateaus_10x4.7.csv");
  const auto sets = readPropellerSets(resources / "validation" / "uiuc");
  const PropellerSet& propeller = named(sets, "apcsf_10x4.7");
  const DriveFit fit = fitDrive(known, {.motor = false, .throttleLine = true, .chopping = true},
                                startOf(tunnelLoad(named(sets, "apcsf_11x4.7"))));
  const Errors own = compare(known, fit.constants, nullptr, nullptr);
  DriveConstants drive = fit.constants;
  Table table{"Predicted from throttle and voltage, propeller by its tunnel coefficients",
              {"Throttle, %", "Voltage, V", "Speed, rpm", "Model, %", "Current, A", "Model, %",
               "Thrust, N", "Model, %"},
              {}};
  std::vector<SvgSeries> lines{{"Current, computed", SvgSeries::Style::Line, 0, {}},
                               {"Thrust, computed", SvgSeries::Style::Line, 1, {}},
                               {"Current, measured", SvgSeries::Style::Points, 0, {}},
                               {"Thrust, measured", SvgSeries::Style::Points, 1, {}}};
  drive.load = tunnelLoad(propeller);
  const Errors held = compare(asked, drive, &table, &lines);
  drive.load = bladeElementLoad(propeller.geometry);
  const Errors chain = compare(asked, drive, nullptr, nullptr);
  CaseResult result;
  result.key = "stand-throttle";
  result.title = "Part throttle: one stand, two propellers";
  result.method =
      "A SunnySky X2216 with its speed controller was logged with an APC 11 x 4.7 SF and with a "
      "10 x 4.7 SF. On the first log five constants are identified by least squares of speed and "
      "current: the resistance of winding and switches, the throttles of no and of full duty, "
      "inductance times switching frequency, and the switching loss; speed constant and no-load "
      "current are the published ones. Nothing is taken from the second log: its speed, current "
      "and "
      "thrust are predicted from throttle and voltage. The propellers have the static coefficients "
      "of the wind tunnel, continued in a straight line above its speeds. With blade elements in "
      "their place the section's constants count as fitted: the full throttle of the second log "
      "was in view when they were chosen.";
  result.verdict =
      "Where the current is interrupted, below about 42 % throttle, the motor turns up to a "
      "quarter faster than duty times voltage would let it.";
  result.sources = {
      "github.com/Darlock7/Nimbus-Package-Delivery-UAV, commits 914c389 and e155c91, 'Prop "
      "Tests/10x4.7.csv' and '11x4.7.csv': RCbenchmark 1580 logs",
      "Propellers: UIUC Propeller Database, volume 1"};
  const auto add = [&](const std::string& what, Evidence evidence, const Errors& e, bool limited) {
    const auto limit = [&](double most) { return limited ? std::optional(most) : std::nullopt; };
    result.figures.push_back({what + "speed, most", evidence, "%", e.speed, limit(5)});
    result.figures.push_back({what + "current, most", evidence, "%", e.current, limit(12)});
    result.figures.push_back({what + "thrust, most", evidence, "%", e.thrust, limit(10)});
  };
  add("10 x 4.7, the drive: ", Evidence::HeldOut, held, true);
  add("10 x 4.7, with blade elements: ", Evidence::Fitted, chain, false);
  add("11 x 4.7, identified on: ", Evidence::Fitted, own, false);
  result.tables = {constantsTable(fit.constants), std::move(table)};
  result.charts = {{"10 x 4.7: current and thrust over the throttle",
                    {"Throttle, %", 0, 100},
                    {"Current, A; thrust, N", 0, {}},
                    std::move(lines)}};
  return result;
}

}  // namespace rotorbench::validation
