#include "sim/propulsion/drive/drive_train.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sim/numerics/scalar_search.h"

namespace rotorbench {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The w where a falling function passes zero, between 0 and `high`.
double fallingRoot(const ScalarFunction& f, double high) {
  const double atRest = f(0);
  return atRest > 0 ? findRoot(f, 0, atRest, high, f(high), 1e-13 * high) : 0;
}

}  // namespace

double steadySpeed(const MotorConstants& motor, const ShaftLoad& load, double v) {
  const double sign = v < 0 ? -1 : 1;
  const double free = std::abs(v) / motor.torqueConstant;
  const auto surplus = [&](double w) {
    const double i = (std::abs(v) - motor.torqueConstant * w) / motor.resistance;
    return motor.torqueConstant * i - motor.friction(w) - load.torque(w);
  };
  return free > 0 ? sign * fallingRoot(surplus, free) : 0;
}

DriveTrain::DriveTrain(const DriveTrainSetup& setup)
    : supply_(setup.supply),
      motor_(buildMotor(setup.motor)),
      load_(setup.load),
      esc_(buildEsc(setup.esc, motor_)),
      inverseInertia_(1 / setup.inertia),
      quasiStatic_(setup.quasiStaticCurrent),
      lossy_(esc_.lossy() && !setup.quasiStaticCurrent) {
  if (!setup.unlimited) return;
  esc_.throttleStart = 0;
  esc_.throttleFull = 1;
  esc_.least = -kInfinity;
  esc_.most = esc_.maxCurrent = kInfinity;
  esc_.activeBraking = true;
}

DriveTrain::State DriveTrain::initialState() const {
  State y = State::Zero();
  y[kCharge] = supply_.charge;
  return y;
}

void DriveTrain::setThrottle(double throttle, State& y) {
  throttle_ = allowedThrottle(throttle);
  asked_ = esc_.dutyOf(throttle_);
  y[kDuty] = esc_.duty(asked_, double{y[kDuty]});
  esc_.settle(y[kDuty], y[kCurrent]);
}

std::string_view DriveTrain::componentName(int index) {
  constexpr std::array<std::string_view, kStates> kNames{"motor.current", "motor.speed", "esc.duty",
                                                         "battery.charge", "battery.polarisation"};
  return kNames.at(static_cast<std::size_t>(index));
}

DrivePowers DriveTrain::powers(const State& y) const {
  const DriveInstant<double> at = instant(y);
  State rate;
  derivative(y, rate);
  const double w = y[kSpeed], i = at.current;
  DrivePowers p{};
  p.source = at.openCircuit * at.busCurrent;
  p.supplyLoss =
      supply_.resistance * at.busCurrent * at.busCurrent + y[kPolarisation] * at.busCurrent;
  p.escLoss =
      lossy_ ? at.busVoltage * at.busCurrent - at.motorVoltage * i : esc_.resistance * i * i;
  p.copperLoss = motor_.resistance * i * i;
  p.frictionLoss = motor_.friction(w) * w;
  p.load = load_.torque(w) * w;
  p.magnetic = motor_.inductance * i * rate[kCurrent];
  p.kinetic = w * rate[kSpeed] / inverseInertia_;
  return p;
}

double DriveTrain::fastestPole(double w) const {
  const double h = 1e-3 * std::max(1.0, std::abs(w));
  const double drag = (motor_.friction(w + h) + load_.torque(w + h) - motor_.friction(w - h) -
                       load_.torque(w - h)) /
                      (2 * h);
  const double r = motor_.resistance + esc_.resistance, k = motor_.torqueConstant;
  if (quasiStatic_) return (drag + k * k / r) * inverseInertia_;
  return rotorbench::fastestPole(motor_, r, drag, 1 / inverseInertia_);
}

double DriveTrain::heldCurrent(const State& y, double speed) const {
  const double sign = y[kDuty] < 0 ? -1 : 1;
  State at = y;
  at[kSpeed] = speed;
  const auto surplus = [&](double current) {
    at[kCurrent] = sign * current;
    const double terminal = sign * instant(at).motorVoltage;
    return terminal - motor_.resistance * current - sign * motor_.torqueConstant * speed;
  };
  const double inner = supply_.openCircuit(double{y[kCharge]}) - y[kPolarisation];
  const double most = (inner - sign * motor_.torqueConstant * speed) / motor_.resistance;
  return most > 0 ? fallingRoot(surplus, most) : 0;
}

DriveTrain::State DriveTrain::steadyState(double throttle, double charge,
                                          double polarisation) const {
  State y = State::Zero();
  y[kDuty] = esc_.dutyOf(allowedThrottle(throttle));
  y[kCharge] = charge;
  y[kPolarisation] = polarisation;
  const double sign = y[kDuty] < 0 ? -1 : 1;
  const double inner = supply_.openCircuit(charge) - polarisation;
  const double duty = y[kDuty];
  const auto current = [&](double w) {
    if (lossy_) return heldCurrent(y, sign * w);
    return sign * quasiStaticCurrent(duty, inner, sign * motor_.torqueConstant * w);
  };
  if (!(std::abs(duty) > 0) || !(inner > 0)) return y;
  // An interrupted current lets the motor turn faster than its share of the voltage.
  const double free = (lossy_ ? 1 : std::abs(duty)) * inner / motor_.torqueConstant;
  const double w = fallingRoot(
      [&](double speed) {
        return motor_.torqueConstant * current(speed) - motor_.friction(speed) -
               load_.torque(speed);
      },
      free);
  y[kSpeed] = sign * w;
  y[kCurrent] = sign * current(w);
  return y;
}

}  // namespace rotorbench
