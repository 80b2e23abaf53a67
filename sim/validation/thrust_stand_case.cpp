// Battery voltage, speed controller, motor and blade-element propeller together against the log of
// a thrust stand.
#include <cmath>

#include "sim/core/constants.h"
#include "sim/core/error.h"
#include "sim/document/experiment_file.h"
#include "sim/document/thrust_stand.h"
#include "sim/io/csv.h"
#include "sim/numerics/scalar_search.h"
#include "sim/run/drive_build.h"
#include "sim/validation/cases.h"
#include "sim/validation/statistics.h"
#include "sim/validation/text.h"

namespace rotorbench::validation {

namespace {

struct Step {
  double signal, voltage, current, speed, thrust;  // us, V, A, rad/s, N
};

std::vector<Step> readSteps(const std::filesystem::path& file) {
  const CsvTable table = readCsvFile(file);
  const auto signal = table.values("signal", "us"), voltage = table.values("voltage", "V");
  const auto current = table.values("current", "A"), speed = table.values("speed", "rad/s");
  const auto thrust = table.values("thrust", "N");
  std::vector<Step> steps;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    steps.push_back({signal[i], voltage[i], current[i], speed[i], thrust[i]});
  }
  return steps;
}

struct Answer {
  double duty, thrust, speed, current;
};

/// The steady state at the logged voltage with a throttle, or with the one that gives the logged
/// speed.
class Stand {
 public:
  explicit Stand(DriveStand stand) : stand_(std::move(stand)) {}

  [[nodiscard]] Answer atThrottle(double voltage, double throttle) {
    stand_.supply = SupplyParameters{.voltage = voltage};
    return answer(buildDriveTrain(stand_), throttle);
  }
  [[nodiscard]] Answer atSpeed(double voltage, double speed) {
    stand_.supply = SupplyParameters{.voltage = voltage};
    const DriveTrain train = buildDriveTrain(stand_);
    const auto excess = [&](double d) { return answer(train, d).speed - speed; };
    const double low = excess(0), high = excess(1);
    if (!(high > 0)) return answer(train, 1);
    return answer(train, findRoot(excess, 0, low, 1, high, 1e-9));
  }

 private:
  static Answer answer(const DriveTrain& train, double throttle) {
    const DriveTrain::State y = train.steadyState(throttle, 1, 0);
    const double speed = y[DriveTrain::kSpeed];
    return {throttle, train.load().thrustAt(speed), speed, train.instant<double>(y).busCurrent};
  }
  DriveStand stand_;
};

struct Sweep {
  Table table{"Over the throttle, at the logged voltage and speed",
              {"Signal, \u00b5s", "Voltage, V", "Speed, rpm", "Thrust, N", "Thrust, model",
               "Difference, %", "Current, A", "Current, model", "Difference, %", "Duty, model"},
              {}};
  SvgSeries thrust{"Measured", SvgSeries::Style::Points, 0, {}}, current = thrust;
  SvgSeries modelThrust{"Computed", SvgSeries::Style::Line, 1, {}}, modelCurrent = modelThrust;
  double mostThrust = 0, mostCurrent = 0;
};

Sweep sweep(Stand& stand, const std::vector<Step>& steps) {
  Sweep s;
  for (const Step& step : steps) {
    const Answer a = stand.atSpeed(step.voltage, step.speed);
    const double thrust = apart(a.thrust, step.thrust), current = apart(a.current, step.current);
    s.mostThrust = std::max(s.mostThrust, std::abs(thrust));
    s.mostCurrent = std::max(s.mostCurrent, std::abs(current));
    s.table.rows.push_back({fixed(step.signal, 0), fixed(step.voltage, 2),
                            fixed(step.speed / kRpm, 0), fixed(step.thrust, 2), fixed(a.thrust, 2),
                            fixed(thrust, 1), fixed(step.current, 2), fixed(a.current, 2),
                            fixed(current, 1), fixed(a.duty, 3)});
    const double rpm = step.speed / kRpm;
    s.thrust.points.push_back({rpm, step.thrust});
    s.current.points.push_back({rpm, step.current});
    s.modelThrust.points.push_back({a.speed / kRpm, a.thrust});
    s.modelCurrent.points.push_back({a.speed / kRpm, a.current});
  }
  for (auto* line : {&s.modelThrust, &s.modelCurrent}) {
    std::sort(line->points.begin(), line->points.end());
  }
  return s;
}

}  // namespace

CaseResult thrustStand(const std::filesystem::path& resources) {
  const Experiment experiment =
      loadExperiment(resources / "experiments" / "thrust-stand-x2216.json");
  const auto* bench = alternativeIf<ThrustStand>(experiment.setup);
  if (bench == nullptr) {
    throw InputError("thrust-stand-x2216.json", {{"setup", "is not a thrust stand", {}}});
  }
  Stand stand(bench->stand);
  const auto steps = readSteps(resources / "validation" / "stand_x2216" / "steps.csv");
  const Step& full = steps.back();
  const Answer top = stand.atThrottle(full.voltage, 1);
  Sweep s = sweep(stand, steps);
  CaseResult result;
  result.key = "stand-x2216";
  result.title = "Thrust stand: SunnySky X2216 1100 KV with an APC 10 x 4.7 SF";
  result.method =
      "Motor constants as published with the log, the propeller's measured geometry and the global "
      "constants, which were chosen with these limits in view. At full throttle the model is given "
      "the logged voltage and "
      "finds speed, thrust and current. Below it the duty the controller made of its signal is "
      "not known (it gives full power from about 1740 \u00b5s on): the model takes the duty that "
      "gives "
      "the logged speed.";
  result.verdict =
      "At part throttle the log is a sweep by hand: the rotor is partly still speeding up where a "
      "signal was held for few rows, and this experiment's speed controller states no losses of "
      "chopping: the case of part throttle identifies them.";
  result.sources = {
      "github.com/Darlock7/Nimbus-Package-Delivery-UAV, commit 914c389, 'Prop Tests/10x4.7.csv': "
      "RCbenchmark 1580 log; motor constants of the same authors"};
  result.figures = {
      {"full throttle: thrust", Evidence::Fitted, "%", std::abs(apart(top.thrust, full.thrust)), 8},
      {"full throttle: speed", Evidence::Fitted, "%", std::abs(apart(top.speed, full.speed)), 8},
      {"full throttle: current", Evidence::Fitted, "%", std::abs(apart(top.current, full.current)),
       8},
      {"whole sweep at the logged speed: thrust, most", Evidence::Fitted, "%", s.mostThrust, {}},
      {"whole sweep at the logged speed: current, most", Evidence::Fitted, "%", s.mostCurrent, {}}};
  result.tables = {std::move(s.table)};
  result.charts = {
      {"Thrust", {"Speed, rpm", 0, {}}, {"Thrust, N", 0, {}}, {s.modelThrust, s.thrust}},
      {"Current", {"Speed, rpm", 0, {}}, {"Current, A", 0, {}}, {s.modelCurrent, s.current}}};
  return result;
}

}  // namespace rotorbench::validation
