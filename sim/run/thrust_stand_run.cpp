#include "sim/run/builders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/analysis/curve_figures.h"
#include "sim/document/thrust_stand.h"
#include "sim/run/drive_build.h"
#include "sim/run/drive_simulation.h"
#include "sim/run/simulation.h"
#include "sim/run/steady_points.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

namespace {

/// Points of the curve over the throttle.
constexpr int kCurvePoints = 101;
/// Two instants closer than this, in s, are one: ticks are sums of rounded numbers.
constexpr double kSameInstant = 1e-9;

using Throttle = InputSignal<double>;

/// The procedure as a signal of throttle, with the instants in s at which the gauges are read,
/// rising.
struct ThrottlePlan {
  Throttle signal;
  std::vector<double> readings;
};

struct PlanOf {
  ThrottlePlan operator()(const ThrottleLevels& p) const {
    std::vector<Throttle::Sample> samples;
    ThrottlePlan plan;
    for (const ThrottleLevel& level : p.levels) {
      samples.push_back({static_cast<double>(samples.size()) * p.holdTime, level.throttle});
      plan.readings.push_back(static_cast<double>(samples.size()) * p.holdTime);
    }
    plan.signal = Throttle(std::move(samples), Interpolation::Hold);
    return plan;
  }
  ThrottlePlan operator()(const ThrottleSweep& p) const {
    ThrottlePlan plan;
    for (int k = 1; k <= p.readings; ++k) plan.readings.push_back(p.duration * k / p.readings);
    plan.signal = Throttle({{0, p.from}, {p.duration, p.to}}, Interpolation::Linear);
    return plan;
  }
  ThrottlePlan operator()(const ThrottleRows& p) const {
    std::vector<Throttle::Sample> samples;
    ThrottlePlan plan;
    for (const ThrottleStep& row : p.rows) {
      samples.push_back({row.time, row.throttle});
      if (row.time > 0 && row.time < p.duration) plan.readings.push_back(row.time);
    }
    plan.readings.push_back(p.duration);
    plan.signal = Throttle(std::move(samples), p.interpolation);
    return plan;
  }
};

/// For a procedure without faults.
ThrottlePlan planOf(const ThrottleProcedure& procedure) {
  return std::visit(PlanOf{}, procedure);
}

constexpr std::array kComparedValues{&SteadyPoint::speed, &SteadyPoint::thrust,
                                     &SteadyPoint::supplyCurrent, &SteadyPoint::motorCurrent};

/// Largest relative difference of what settles last. Near rest a relative difference says nothing:
/// there it is taken of a hundredth of what full throttle gives.
double difference(const SteadyPoint& a, const SteadyPoint& b, const SteadyPoint& full) {
  double most = 0;
  for (const auto value : kComparedValues) {
    const double size =
        std::max({std::abs(a.*value), std::abs(b.*value), 0.01 * std::abs(full.*value)});
    if (size > 0) most = std::max(most, std::abs(a.*value - b.*value) / size);
  }
  return most;
}

/// Follows the plan and reads the gauges.
class StandOperator {
 public:
  StandOperator(ThrottlePlan plan, const DriveTrain& train)
      : plan_(std::move(plan)), full_(steadyPoint(train, 1, train.supply().charge, 0)) {}
  void writeTo(Recording& readings) { readings_ = &readings; }

  double throttle(double t, const DriveTrain& /*train*/, const DriveTrain::State& /*y*/) {
    return plan_.signal.at(t + kSameInstant);
  }
  void reached(double t, const DriveTrain& train, const DriveTrain::State& y) {
    for (; next_ < plan_.readings.size() && plan_.readings[next_] <= t + kSameInstant; ++next_)
      read(t, train, y);
  }
  [[nodiscard]] static std::vector<Channel> channels() { return {}; }
  static void row(double* /*out*/) {}
  void figures(const Recording& r, const DriveTrain& train, std::vector<Metric>& metrics) const {
    if (r.rows() == 0) return;
    metrics = {
        {"full_thrust", "N", "Thrust at full throttle and first charge", full_.thrust},
        {"full_speed", "rad/s", "Angular speed at full throttle", full_.speed},
        {"full_torque", "N*m", "Torque at full throttle", full_.torque},
        {"full_voltage", "V", "Voltage of the supply at full throttle", full_.supplyVoltage},
        {"full_current", "A", "Current of the supply at full throttle", full_.supplyCurrent},
        {"full_electrical_power", "W", "Power drawn at full throttle", full_.electricalPower},
        {"full_shaft_power", "W", "Power on the shaft at full throttle", full_.shaftPower},
        {"full_efficiency", "1", "Shaft power over electrical power at full throttle",
         full_.efficiency},
        {"full_thrust_per_power", "N/W", "Thrust over electrical power at full throttle",
         full_.thrustPerPower},
        {"peak_thrust", "N", "Largest thrust of the run", largestMagnitude(r, "thrust")},
        {"peak_current", "A", "Largest motor current of the run",
         largestMagnitude(r, "motor.current")},
        {"charge_used", "1", "Part of the battery's charge the run took",
         train.supply().charge - r.value(*r.find("supply.charge"), r.rows() - 1)},
        {"steady_difference", "1",
         "Largest relative difference between a reading and the steady point solved directly",
         largestMagnitude(*readings_, "reading.difference")},
        {"peak_ledger_residual", "W", "Largest amount the energy ledger does not account for",
         largestMagnitude(r, "power.residual")}};
  }

 private:
  void read(double t, const DriveTrain& train, const DriveTrain::State& y) {
    const SteadyPoint solved =
        steadyPoint(train, train.throttle(), y[DriveTrain::kCharge], y[DriveTrain::kPolarisation]);
    const SteadyPoint found = readPoint(train, train.throttle(), y);
    const auto a = rowOf(solved), b = rowOf(found);
    std::array<double, 2 + 2 * kSteadyValues> row;
    row.front() = t;
    std::copy(b.begin(), b.end(), std::copy(a.begin(), a.end(), row.begin() + 1));
    row.back() = difference(solved, found, full_);
    readings_->append(row);
  }

  ThrottlePlan plan_;
  SteadyPoint full_;
  Recording* readings_ = nullptr;
  std::size_t next_ = 0;
};

std::vector<Channel> readingChannels() {
  std::vector<Channel> channels{{"reading.time", "s", "When the gauges were read"}};
  for (const char* prefix : {"steady", "reached"})
    for (Channel& channel : steadyChannels(prefix)) channels.push_back(std::move(channel));
  channels.push_back({"reading.difference", "1",
                      "Largest relative difference of speed, thrust and currents between the "
                      "steady point and what was reached"});
  return channels;
}

class ThrustStandSimulation final : public DriveSimulation<StandOperator> {
 public:
  ThrustStandSimulation(const ThrustStand& stand, const OutputSettings& outputs)
      : DriveSimulation(runOf(stand), stand.stand.esc.deadTime, outputs, partsOf(stand), kRuns) {
    recordSteadyPoints(train(), kCurvePoints,
                       addRun("Over throttle", steadyChannels("over_throttle"), outputs, kRuns));
    commander().writeTo(addRun("Steady points", readingChannels(), outputs, kRuns));
  }

 private:
  static constexpr std::size_t kRuns = 3;

  static DriveRunSettings runOf(const ThrustStand& stand) {
    return {stand.run.solver, stand.run.tick, durationOf(stand.procedure)};
  }
  static std::vector<Part> partsOf(const ThrustStand& stand) {
    DriveTrain train = buildDriveTrain(stand.stand);
    StandOperator person(planOf(stand.procedure), train);
    return {{"Run", std::move(train), std::move(person)}};
  }
};

}  // namespace

std::unique_ptr<Simulation> build(const ThrustStand& stand, const BuildContext& context) {
  return std::make_unique<ThrustStandSimulation>(stand, context.outputs);
}

}  // namespace rotorbench
