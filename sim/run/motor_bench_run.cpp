#include "sim/run/builders.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/analysis/curve_figures.h"
#include "sim/document/motor_bench.h"
#include "sim/run/drive_build.h"
#include "sim/run/drive_simulation.h"
#include "sim/run/simulation.h"
#include "sim/run/steady_points.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

namespace {

/// Points of the characteristic curves.
constexpr int kCurvePoints = 201;

class ThrottleCommander {
 public:
  explicit ThrottleCommander(const MotorBench& bench) {
    std::vector<InputSignal<double>::Sample> samples;
    for (const ThrottleStep& step : bench.throttle) samples.push_back({step.time, step.throttle});
    signal_ = InputSignal<double>(std::move(samples), bench.interpolation);
  }
  double throttle(double t, const DriveTrain& /*train*/, const DriveTrain::State& /*y*/) {
    return signal_.at(t);
  }
  [[nodiscard]] static std::vector<Channel> channels() { return {}; }
  static void row(double* /*out*/) {}
  static void figures(const Recording& r, const DriveTrain& train, std::vector<Metric>& metrics) {
    if (r.rows() == 0) return;
    const auto last = [&](const char* name) { return r.value(*r.find(name), r.rows() - 1); };
    metrics = {
        {"final_speed", "rad/s", "Angular speed at the end", last("motor.speed")},
        {"final_current", "A", "Motor current at the end", last("motor.current")},
        {"final_thrust", "N", "Thrust at the end", last("thrust")},
        {"final_voltage", "V", "Voltage of the supply at the end", last("supply.voltage")},
        {"final_electrical_power", "W", "Power drawn at the end", last("power.electrical")},
        {"final_efficiency", "1", "Shaft power over electrical power at the end",
         last("efficiency")},
        {"peak_current", "A", "Largest motor current", largestMagnitude(r, "motor.current")},
        {"peak_ledger_residual", "W", "Largest amount the energy ledger does not account for",
         largestMagnitude(r, "power.residual")}};
    addMotorFigures(train, metrics);
  }

 private:
  /// What a data sheet would say of this motor at the full voltage of the supply.
  static void addMotorFigures(const DriveTrain& train, std::vector<Metric>& metrics) {
    const MotorConstants& motor = train.motor();
    const double v = train.supply().openCircuit(train.supply().charge);
    const double stall = v / motor.resistance;
    metrics.push_back(
        {"stall_current", "A", "Held at rest with the full voltage, without a limit", stall});
    metrics.push_back({"stall_torque", "N*m", "Torque of the stalled motor",
                       motor.torqueConstant * stall - motor.dryFriction});
    metrics.push_back(
        {"mechanical_time_constant", "s", "J R/K^2: how fast the unloaded motor takes up speed",
         train.inertia() * motor.resistance / (motor.torqueConstant * motor.torqueConstant)});
    metrics.push_back({"electrical_time_constant", "s", "L/R: how fast the current follows",
                       motor.inductance / motor.resistance});
  }

  InputSignal<double> signal_;
};

class MotorBenchSimulation final : public DriveSimulation<ThrottleCommander> {
 public:
  MotorBenchSimulation(const MotorBench& bench, const OutputSettings& outputs)
      : DriveSimulation(bench.run, bench.stand.esc.deadTime, outputs, partsOf(bench), kRuns) {
    overSpeed(outputs);
    overVoltage(outputs);
    overThrottle(outputs);
  }

 private:
  static constexpr std::size_t kRuns = 4;

  static std::vector<Part> partsOf(const MotorBench& bench) {
    return {{"Run", buildDriveTrain(bench.stand), ThrottleCommander(bench)}};
  }

  /// Thesis 2014, figures 3.16-3.17: torque, power and efficiency against speed at the full
  /// voltage.
  void overSpeed(const OutputSettings& outputs) {
    Recording& r = addRun("Over speed",
                          {{"over_speed.speed", "rad/s", "Angular speed, held by a brake"},
                           {"over_speed.current", "A", "Current at the full voltage of the supply"},
                           {"over_speed.torque", "N*m", "Torque on the shaft"},
                           {"over_speed.electrical_power", "W", "Electrical power of the motor"},
                           {"over_speed.shaft_power", "W", "Power on the shaft"},
                           {"over_speed.efficiency", "1", "Shaft power over electrical power"}},
                          outputs, kRuns);
    const MotorConstants& m = train().motor();
    const double v = train().supply().openCircuit(train().supply().charge);
    const double top = steadySpeed(m, ShaftLoad{}, v);
    for (int k = 0; k < kCurvePoints; ++k) {
      const double w = top * k / (kCurvePoints - 1);
      const double i = (v - m.torqueConstant * w) / m.resistance;
      const double torque = m.torqueConstant * i - m.friction(w);
      r.append(std::array{w, i, torque, v * i, torque * w, v * i > 0 ? torque * w / (v * i) : 0});
    }
    r.finish();
  }

  /// Thesis 2014, figure 3.18: speed and torque against voltage, with the load of the stand.
  void overVoltage(const OutputSettings& outputs) {
    Recording& r = addRun("Over voltage",
                          {{"over_voltage.voltage", "V", "Voltage at the motor"},
                           {"over_voltage.speed", "rad/s", "Speed it holds with the load"},
                           {"over_voltage.torque", "N*m", "Torque of the load"},
                           {"over_voltage.current", "A", "Current"}},
                          outputs, kRuns);
    const double full = train().supply().openCircuit(train().supply().charge);
    for (int k = 0; k < kCurvePoints; ++k) {
      const double v = full * k / (kCurvePoints - 1);
      const double w = train().steadySpeed(v);
      const double i = (v - train().motor().torqueConstant * w) / train().motor().resistance;
      r.append(std::array{v, w, train().load().torque(w), i});
    }
    r.finish();
  }

  /// The thrust stand's curve: steady points, solved directly.
  void overThrottle(const OutputSettings& outputs) {
    Recording& r = addRun("Over throttle", steadyChannels("over_throttle"), outputs, kRuns);
    recordSteadyPoints(train(), kCurvePoints, r);
  }
};

}  // namespace

std::unique_ptr<Simulation> build(const MotorBench& bench, const BuildContext& context) {
  return std::make_unique<MotorBenchSimulation>(bench, context.outputs);
}

}  // namespace rotorbench
