#include "sim/run/builders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/analysis/curve_figures.h"
#include "sim/analysis/step_response.h"
#include "sim/document/motor_speed_run.h"
#include "sim/run/drive_build.h"
#include "sim/run/drive_simulation.h"
#include "sim/run/simulation.h"

namespace rotorbench {

namespace {

/// The speed controller wants volts at the motor; the throttle that gives them follows from the
/// measured bus voltage and the current, as the voltage lost in the speed controller is known too.
class SpeedCommander {
 public:
  SpeedCommander(const MotorSpeedRun& run, const DriveTrain& train, bool limited,
                 const Place& place)
      : steps_(run.setPoints),
        controller_(run.controller,
                    {motorSeen(train), train.esc(), train.inertia(), feedForward(run, train)},
                    limited),
        limited_(limited),
        every_(ticksBetween(run.controller.rate, run.run.tick, place / "controller" / "rate")) {}

  double throttle(double t, const DriveTrain& train, const DriveTrain::State& y) {
    if (calls_++ % every_ != 0) return throttle_;
    while (next_ < steps_.size() && steps_[next_].time <= t + 1e-9)
      setPoint_ = steps_[next_++].speed;
    const double bus = train.instant(y).busVoltage;
    voltage_ = controller_.update(setPoint_, y[DriveTrain::kSpeed], bus);
    throttle_ = train.esc().throttleOf(voltage_ / bus);
    return throttle_;
  }
  [[nodiscard]] static std::vector<Channel> channels() {
    return {{"setpoint.speed", "rad/s", "Angular speed wanted"},
            {"controller.voltage", "V", "Control signal: voltage asked for"},
            {"controller.integral", "rad/s^2", "Integral part of the controller"}};
  }
  void row(double* out) const {
    out[0] = setPoint_;
    out[1] = voltage_;
    out[2] = controller_.integral();
  }
  void figures(const Recording& r, const DriveTrain& train, std::vector<Metric>& metrics) const {
    if (r.rows() == 0) return;
    std::vector<SetPointChange> changes;
    for (const SpeedStep& step : steps_) changes.push_back({step.time, step.speed});
    const StepFigures worst = worstFigures(r, *r.find("motor.speed"), changes);
    metrics = {
        {"overshoot", "1", "Largest overshoot of a step, as a fraction of the step",
         worst.overshoot},
        {"rise_time", "s", "Longest time from 10 to 90 % of a step", worst.riseTime},
        {"settling_time", "s", "Longest time to stay within 2 % of a step", worst.settlingTime},
        {"rest_error", "rad/s",
         "Largest distance from the set-point in the last tenth of any part of the timeline",
         worst.restError},
        {"peak_current", "A", "Largest motor current", largestMagnitude(r, "motor.current")},
        {"peak_voltage", "V", "Largest control signal", largestMagnitude(r, "controller.voltage")},
        {"current_limit", "A", "Limit of motor and speed controller",
         limited_ ? train.maxCurrent() : std::numeric_limits<double>::quiet_NaN()}};
  }

 private:
  /// The motor with the resistance of the speed controller in its path and the lower of the two
  /// limits.
  static MotorConstants motorSeen(const DriveTrain& train) {
    MotorConstants motor = train.motor();
    motor.resistance += train.esc().resistance;
    motor.maxCurrent = train.maxCurrent();
    return motor;
  }

  /// Torque per speed squared at the highest set-point: the controller knows one number of its
  /// propeller.
  static double feedForward(const MotorSpeedRun& run, const DriveTrain& train) {
    double top = 0;
    for (const SpeedStep& step : run.setPoints) top = std::max(top, step.speed);
    return train.load().quadratic.at(top);
  }

  std::vector<SpeedStep> steps_;
  MotorSpeedController controller_;
  bool limited_;
  int every_;
  std::int64_t calls_ = 0;
  std::size_t next_ = 0;
  double setPoint_ = 0, voltage_ = 0, throttle_ = 0;
};

}  // namespace

std::unique_ptr<Simulation> build(const MotorSpeedRun& run, const BuildContext& context) {
  using Simulated = DriveSimulation<SpeedCommander>;
  std::vector<Simulated::Part> parts;
  const auto add = [&](const char* name, DriveTrain train, bool limited) {
    SpeedCommander commander(run, train, limited, context.place);
    parts.push_back({name, std::move(train), std::move(commander)});
  };
  add(run.compareUnsaturated ? "With saturation" : "Run", buildDriveTrain(run.stand), true);
  if (run.compareUnsaturated) add("Without saturation", buildUnlimitedDriveTrain(run.stand), false);
  const std::size_t recordings = parts.size();
  return std::make_unique<Simulated>(run.run, run.stand.esc.deadTime, context.outputs,
                                     std::move(parts), recordings);
}

}  // namespace rotorbench
