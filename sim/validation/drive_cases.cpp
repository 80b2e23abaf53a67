// Drives whose propellers nobody has measured: constants fitted to every other steady point predict
// the points between.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/core/constants.h"
#include "sim/core/parallel.h"
#include "sim/fitting/doubt.h"
#include "sim/io/csv.h"
#include "sim/validation/cases.h"
#include "sim/validation/drive_fit.h"
#include "sim/validation/statistics.h"
#include "sim/validation/text.h"

namespace rotorbench::validation {

namespace {

namespace fs = std::filesystem;

double magnitudeApart(double model, double measured) {
  return 100 * std::abs(model / measured - 1);
}

/// A drive's points, fitted on the even ones, predicted on the odd ones.
struct HeldOut {
  DriveConstants constants;
  std::string atBound;      ///< of the constants
  double thrustFactor = 0;  ///< T/w^2 of the fitted points, N s^2
  std::vector<LoggedPoint> points;
  std::vector<DrivePrediction> predictions;  ///< of all points

  [[nodiscard]] static bool fitted(std::size_t i) { return i % 2 == 0; }
};

HeldOut holdOut(std::vector<LoggedPoint> points, const DriveFitChoice& choice,
                const DriveConstants& guess) {
  HeldOut h;
  std::vector<LoggedPoint> fit;
  double top = 0, bottom = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!HeldOut::fitted(i)) continue;
    fit.push_back(points[i]);
    // Least squares of the relative error of the thrust is a mean of ratios; of the error itself,
    // this.
    top += points[i].thrust * points[i].speed * points[i].speed;
    bottom += std::pow(points[i].speed, 4);
  }
  DriveFit found = fitDrive(fit, choice, guess);
  h.constants = std::move(found.constants);
  h.atBound = std::move(found.atBound);
  h.thrustFactor = top / bottom;
  h.points = std::move(points);
  for (const LoggedPoint& p : h.points) {
    h.predictions.push_back(predicted(h.constants, p.throttle, p.voltage));
  }
  return h;
}

/// For a start: K of a data sheet's Kv in rpm/V, the load current such that the strongest point is
/// met.
DriveConstants startingFrom(double kv, double resistance, const std::vector<LoggedPoint>& points) {
  DriveConstants c;
  c.torqueConstant = 1 / (kv * kRpm);
  c.resistance = resistance;
  const auto strongest =
      std::max_element(points.begin(), points.end(),
                       [](const auto& a, const auto& b) { return a.current < b.current; });
  c.noLoadCurrent = 0.03 * strongest->current;
  c.loadCurrent = strongest->current / (strongest->throttle * strongest->speed * strongest->speed);
  return c;
}

/// Why constants are not to be read as those of the motor; `kv`: of its label in rpm/V, 0 where it
/// has none.
std::string doubtOf(const HeldOut& h, double kv) {
  const double found = 1 / (h.constants.torqueConstant * kRpm);
  if (!h.atBound.empty()) return h.atBound + " at a bound: not determined by the points";
  if (kv > 0 && std::abs(found / kv - 1) > kFarFromStart)
    return "Kv is " + fixed(100 * (found / kv - 1), 0) + " % off its label";
  return "none";
}

/// The constants that a reader can compare with a data sheet.
std::vector<std::string> constantCells(const HeldOut& h, double kv = 0) {
  const DriveConstants& c = h.constants;
  return {kv > 0 ? fixed(kv, 0) : "none",
          fixed(1 / (c.torqueConstant * kRpm), 0),
          fixed(c.resistance * 1000, 0),
          fixed(c.noLoadCurrent, 3),
          fixed(c.loadCurrent * 1e6, 3),
          fixed(c.standbyCurrent, 3),
          doubtOf(h, kv)};
}
const std::vector<std::string> kConstantHeads{
    "Kv of the label, rpm/V",          "Kv, rpm/V",          "R, m\u03a9", "I0, A",
    "kq/K, \u00b5A s\u00b2/rad\u00b2", "Ammeter at rest, A", "Doubt"};

/// Measured and predicted over the duty; the fitted points apart from the held out ones.
SvgChart dutyChart(const HeldOut& h, const std::string& title, bool speed) {
  SvgChart chart{title, {"Duty", 0, {}}, {speed ? "Speed, rpm" : "Current, A", 0, {}}, {}};
  SvgSeries used{"Measured, fitted to", SvgSeries::Style::Points, 6, {}};
  SvgSeries held{"Measured, held out", SvgSeries::Style::Points, 0, {}};
  SvgSeries line{"Computed", SvgSeries::Style::Line, 1, {}};
  for (std::size_t i = 0; i < h.points.size(); ++i) {
    const LoggedPoint& p = h.points[i];
    const DrivePrediction& m = h.predictions[i];
    (HeldOut::fitted(i) ? used : held)
        .points.push_back({p.throttle, speed ? p.speed / kRpm : p.current});
    line.points.push_back({p.throttle, speed ? m.speed / kRpm : m.current});
  }
  std::sort(line.points.begin(), line.points.end());
  chart.series = {line, used, held};
  return chart;
}

struct StepErrors {
  double speed = 0, current = 0;  ///< %, greatest of the held out steps
  double small = 0;               ///< A, greatest of those with a small current
};

/// Currents below this are near the ammeter's own error, and are judged in A.
constexpr double kSmallCurrent = 0.5;

StepErrors stepErrors(const HeldOut& h) {
  StepErrors e;
  for (std::size_t i = 0; i < h.points.size(); ++i) {
    if (HeldOut::fitted(i)) continue;
    const LoggedPoint& p = h.points[i];
    const DrivePrediction& m = h.predictions[i];
    e.speed = std::max(e.speed, magnitudeApart(m.speed, p.speed));
    if (p.current < kSmallCurrent) {
      e.small = std::max(e.small, std::abs(m.current - p.current));
    } else {
      e.current = std::max(e.current, magnitudeApart(m.current, p.current));
    }
  }
  return e;
}

/// The steady steps of one of the logs of bench_esc_test.
std::vector<LoggedPoint> readSteps(const CsvTable& table, int log) {
  constexpr double kSteady = 0.03;  // interquartile range of the speed over its median
  const auto logs = table.values("log", "1"), duty = table.values("duty", "1");
  const auto speed = table.values("speed", "rad/s"), spread = table.values("spread", "rad/s");
  const auto current = table.values("current", "A"), voltage = table.values("voltage", "V");
  std::vector<LoggedPoint> points;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (logs[i] != log || spread[i] > kSteady * speed[i]) continue;
    points.push_back({duty[i], voltage[i], current[i], speed[i], 0});
  }
  return points;
}

}  // namespace

CaseResult drivesOnSteps(const fs::path& resources) {
  const CsvTable table = readCsvFile(resources / "validation" / "esc_test" / "steps.csv");
  struct Log {
    const char* name;
    double kv;
    bool lastIsWrong;
  };
  constexpr std::array<Log, 2> kLogs{Log{"T-Motor F60 Pro II 1750 KV", 1750, true},
                                     Log{"T-Motor F40 Pro III 1600 KV", 1600, false}};
  CaseResult result;
  Table constants{"Fitted constants", {"Motor"}, {}};
  constants.header.insert(constants.header.end(), kConstantHeads.begin(), kConstantHeads.end());
  for (std::size_t i = 0; i < kLogs.size(); ++i) {
    auto points = readSteps(table, static_cast<int>(i));
    if (kLogs.at(i).lastIsWrong) points.pop_back();
    const DriveConstants guess = startingFrom(kLogs.at(i).kv, 0.1, points);
    const HeldOut h = holdOut(std::move(points), {.standby = true}, guess);
    const StepErrors e = stepErrors(h);
    const std::string name = kLogs.at(i).name;
    result.figures.push_back(
        {name + ": speed of the steps held out, most", Evidence::HeldOut, "%", e.speed, 3});
    result.figures.push_back(
        {name + ": current of the steps held out, most", Evidence::HeldOut, "%", e.current, 6});
    result.figures.push_back(
        {name + ": current of the steps below 0.5 A, most", Evidence::HeldOut, "A", e.small, {}});
    constants.rows.push_back({name});
    const auto cells = constantCells(h, kLogs.at(i).kv);
    constants.rows.back().insert(constants.rows.back().end(), cells.begin(), cells.end());
    result.charts.push_back(dutyChart(h, name + ": speed", true));
    result.charts.push_back(dutyChart(h, name + ": current", false));
  }
  result.key = "esc-test";
  result.title = "Two motors on steps of duty";
  result.method =
      "Medians of 5 % steps of duty with a DALPROP T7056. Per motor, five constants are fitted to "
      "every other step by least squares of speed and supply current: K, the resistance of winding "
      "and switches, the no-load current, the load's current per speed squared, and what the "
      "ammeter "
      "reads at rest. The steps between are predicted from duty and voltage. Left out: steps whose "
      "speed is not steady (quartiles more than 3 % apart: 50 % duty of both), and full duty of "
      "the "
      "F60, whose speed lies below that at 95 %.";
  result.verdict =
      "Steps that draw less than 0.5 A are judged in A: the F60's ammeter reads 0.03 A at 2694 "
      "rpm, "
      "where the F40 takes 0.14 A at less speed, so that its zero is off by about as much as it "
      "shows.";
  result.sources = {"A. Spitzer, github.com/alspitz/esc_test, commit 4078609 (MIT)"};
  result.tables = {std::move(constants)};
  return result;
}

namespace {

/// Both supplies of one motor with one propeller.
using Pair = std::pair<int, int>;

/// Points up to the greatest thrust of a run: beyond it the supply limits its current and the drive
/// falls back.
std::vector<LoggedPoint> upToGreatestThrust(const std::vector<LoggedPoint>& run) {
  const auto top = std::max_element(
      run.begin(), run.end(), [](const auto& a, const auto& b) { return a.thrust < b.thrust; });
  return {run.begin(), top == run.end() ? top : top + 1};
}

std::map<Pair, std::vector<LoggedPoint>> readPairs(const fs::path& file) {
  constexpr double kZero = 1000e-6, kFull = 1000e-6;  // s: signal of no and of full throttle
  const CsvTable table = readCsvFile(file);
  const auto motor = table.values("motor", "1"), propeller = table.values("propeller", "1");
  const auto supply = table.values("supply", "V"), signal = table.values("signal", "s");
  const auto thrust = table.values("thrust", "N"), voltage = table.values("voltage", "V");
  const auto current = table.values("current", "A"), speed = table.values("speed", "rad/s");
  std::map<std::tuple<int, int, double>, std::vector<LoggedPoint>> runs;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    runs[{static_cast<int>(motor[i]), static_cast<int>(propeller[i]), supply[i]}].push_back(
        {(signal[i] - kZero) / kFull, voltage[i], current[i], speed[i], thrust[i]});
  }
  std::map<Pair, std::vector<LoggedPoint>> pairs;
  for (const auto& [key, run] : runs) {
    auto& points = pairs[{std::get<0>(key), std::get<1>(key)}];
    for (const LoggedPoint& p : upToGreatestThrust(run)) points.push_back(p);
  }
  return pairs;
}

struct Spread {
  std::vector<double> speed, current, thrust;  // %
};

void addErrors(const HeldOut& h, Spread& spread) {
  for (std::size_t i = 0; i < h.points.size(); ++i) {
    if (HeldOut::fitted(i)) continue;
    const LoggedPoint& p = h.points[i];
    const DrivePrediction& m = h.predictions[i];
    spread.speed.push_back(magnitudeApart(m.speed, p.speed));
    spread.current.push_back(magnitudeApart(m.current, p.current));
    spread.thrust.push_back(magnitudeApart(h.thrustFactor * m.speed * m.speed, p.thrust));
  }
}

void addFigures(const Spread& spread, CaseResult& result) {
  const auto add = [&](const char* name, const std::vector<double>& errors) {
    result.figures.push_back(
        {std::string(name) + ", median", Evidence::HeldOut, "%", quantile(errors, 0.5), {}});
    result.figures.push_back(
        {std::string(name) + ", 90 % quantile", Evidence::HeldOut, "%", quantile(errors, 0.9), {}});
  };
  add("speed", spread.speed);
  add("current", spread.current);
  add("thrust", spread.thrust);
}

}  // namespace

CaseResult racingDrives(const fs::path& resources) {
  constexpr std::array<const char*, 12> kMotors{
      "EMAX RS2205S 2600",       "Lumenier 1806-13 2500",   "Lumenier MX2206-9 2450",
      "Lumenier RX2204-14 2300", "Lumenier RX2205-12 2400", "Lumenier RX2206-11 2350",
      "Lumenier RX2206-13 2000", "Navigator 1804-20 2400",  "T-Motor F30 2300",
      "T-Motor F40 III 2400",    "T-Motor F40 Pro 2400",    "T-Motor F30 2800"};
  constexpr std::array<double, 12> kKv{2600, 2500, 2450, 2300, 2400, 2350,
                                       2000, 2400, 2300, 2400, 2400, 2800};
  const auto pairs = readPairs(resources / "validation" / "strawson" / "points.csv");
  std::vector<const std::pair<const Pair, std::vector<LoggedPoint>>*> order;
  for (const auto& pair : pairs) order.push_back(&pair);
  const auto fits = inParallel(order.size(), [&](std::size_t i) {
    const auto motor = std::min(static_cast<std::size_t>(order[i]->first.first), kKv.size() - 1);
    const DriveConstants guess = startingFrom(kKv.at(motor), 0.1, order[i]->second);
    return holdOut(order[i]->second, {.throttleLine = true}, guess);
  });
  CaseResult result;
  Spread all;
  std::map<int, Spread> byMotor;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    addErrors(fits[i], all);
    addErrors(fits[i], byMotor[order[i]->first.first]);
  }
  addFigures(all, result);
  Table table{"By motor, median over the points held out",
              {"Motor", "Speed, %", "Current, %", "Thrust, %"},
              {}};
  for (const auto& [motor, spread] : byMotor) {
    const auto name = std::min(static_cast<std::size_t>(motor), kMotors.size() - 1);
    table.rows.push_back({kMotors.at(name), fixed(quantile(spread.speed, 0.5), 1),
                          fixed(quantile(spread.current, 0.5), 1),
                          fixed(quantile(spread.thrust, 0.5), 1)});
  }
  result.key = "racing-drives";
  result.title = "Racing motors and five-inch propellers";
  result.method =
      "Every motor with every propeller of the set at 7.4 V and 11.1 V. Six constants per pair are "
      "fitted to every other point: K, R, no-load current, load, and the signals of no and of full "
      "duty; with one thrust per speed squared. The points between are "
      "predicted. Left out: what lies beyond the greatest thrust of a run, where the supply "
      "limits.";
  result.verdict =
      "Worse than the steps above, because the controller's throttle curve is not published and "
      "not "
      "straight, the supply sags from 11 V to as little as 8 V while a point is read, and a point "
      "is "
      "one reading and no mean. Thrust is off mostly where it is small against the cell's error.";
  result.sources = {
      "P. Cao, J. Strawson, github.com/StrawsonDesign/motor_propeller_testing, commit 7031418 "
      "(MIT)"};
  result.tables = {std::move(table)};
  if (!fits.empty()) {
    result.charts = {dutyChart(fits.front(), "EMAX RS2205S, Cyclone T5040C: speed", true),
                     dutyChart(fits.front(), "EMAX RS2205S, Cyclone T5040C: current", false)};
  }
  return result;
}

CaseResult nanoQuadrotor(const fs::path& resources) {
  const CsvTable table = readCsvFile(resources / "validation" / "crazyflie_2021" / "plateaus.csv");
  const auto pwm = table.values("pwm", "1"), thrust = table.values("thrust", "N");
  const auto speed = table.values("speed", "rad/s"), voltage = table.values("voltage", "V");
  const auto current = table.values("current", "A");
  std::vector<LoggedPoint> points;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    points.push_back({pwm[i] / 65535, voltage[i], current[i], speed[i], thrust[i]});
  }
  // 14 000 rpm/V and 1 Ohm are of the order of a 7 mm coreless motor; four of them in parallel.
  DriveConstants guess = startingFrom(14000, 0.25, points);
  guess.standbyCurrent = 0.2;
  // One switch and a diode for each; some hundred kHz and a microhenry are of the order.
  guess.activeBraking = false;
  guess.ripple = 1 / 0.3;
  const HeldOut h = holdOut(points, {.viscous = true, .standby = true, .chopping = true}, guess);
  Spread spread;
  addErrors(h, spread);
  CaseResult result;
  addFigures(spread, result);
  SvgChart chart{
      "Crazyflie 2.1: thrust of four rotors", {"Speed, rpm", 0, {}}, {"Thrust, N", {}, {}}, {}};
  SvgSeries measured{"Measured", SvgSeries::Style::Points, 0, {}};
  SvgSeries line{"T/\u03c9\u00b2 of the fitted points", SvgSeries::Style::Line, 1, {}};
  for (const LoggedPoint& p : h.points) {
    measured.points.push_back({p.speed / kRpm, p.thrust});
    line.points.push_back({p.speed / kRpm, h.thrustFactor * p.speed * p.speed});
  }
  std::sort(line.points.begin(), line.points.end());
  chart.series = {line, measured};
  result.charts = {dutyChart(h, "Crazyflie 2.1: mean speed of four rotors", true),
                   dutyChart(h, "Crazyflie 2.1: current of all", false), std::move(chart)};
  Table constants{"Fitted constants, four motors as one", kConstantHeads, {constantCells(h)}};
  result.tables = {std::move(constants)};
  result.key = "crazyflie";
  result.title = "Crazyflie 2.1 on the system-identification deck";
  result.method =
      "Medians of the plateaus of a ramp of the motors' duty, up and down. Fitted to every other "
      "plateau, four motors as one: K, R, no-load current, viscous friction, load, the current of "
      "the electronics, inductance times switching frequency and switching loss, and one thrust "
      "per speed squared. The plateaus between are predicted from duty and voltage.";
  result.verdict =
      "The balance drifts: at the same speed it reads up to 3 gf more on the way down than on the "
      "way up and starts below nought, which shows in the thrust at low speed. The motors are "
      "switched without "
      "freewheeling control: at low duty their current stops in every period.";
  result.sources = {
      "Bitcraze system-identification deck, 2021; github.com/IMRCLab/crazyflie-system-id, commit "
      "b1de46a (MIT)"};
  return result;
}

}  // namespace rotorbench::validation
