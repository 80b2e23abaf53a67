#include "sim/propulsion/drive_train.h"

#include <algorithm>
#include <array>

namespace rotorbench {

DriveTrain::DriveTrain(const DriveTrainSetup& setup)
    : supply_(setup.supply),
      motor_(buildMotor(setup.motor)),
      load_(setup.load),
      inverseInertia_(1 / setup.inertia),
      escResistance_(setup.esc.resistance),
      inverseResponse_(setup.esc.responseTime > 0 ? 1 / setup.esc.responseTime : 0),
      maxCurrent_(std::min(setup.esc.maxCurrent, setup.motor.maxCurrent)),
      reverse_(setup.esc.reverse),
      activeBraking_(setup.esc.activeBraking),
      quasiStatic_(setup.quasiStaticCurrent) {}

DriveTrain::State DriveTrain::initialState() const {
  State y = State::Zero();
  y[kCharge] = supply_.charge;
  return y;
}

void DriveTrain::setThrottle(double throttle, State& y) {
  throttle_ = std::clamp(throttle, reverse_ ? -1.0 : 0.0, 1.0);
  if (inverseResponse_ == 0) y[kDuty] = throttle_;
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
  p.escLoss = escResistance_ * i * i;
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
  const double r = motor_.resistance + escResistance_, k = motor_.torqueConstant;
  if (quasiStatic_) return (drag + k * k / r) * inverseInertia_;
  return rotorbench::fastestPole(motor_, r, drag, 1 / inverseInertia_);
}

namespace {

/// The w where a falling function passes zero, between 0 and `high`.
template <class Function>
double fallingRoot(Function&& f, double high) {
  double low = 0;
  if (!(f(low) > 0)) return 0;
  for (int i = 0; i < 200 && high - low > 1e-13 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double DriveTrain::steadySpeed(double v) const {
  const double sign = v < 0 ? -1 : 1;
  const double free = std::abs(v) / motor_.torqueConstant;
  const auto surplus = [&](double w) {
    const double i = (std::abs(v) - motor_.torqueConstant * w) / motor_.resistance;
    return motor_.torqueConstant * i - motor_.friction(w) - load_.torque(w);
  };
  return free > 0 ? sign * fallingRoot(surplus, free) : 0;
}

DriveTrain::State DriveTrain::steadyState(double throttle, double charge,
                                          double polarisation) const {
  State y = State::Zero();
  y[kDuty] = std::clamp(throttle, reverse_ ? -1.0 : 0.0, 1.0);
  y[kCharge] = charge;
  y[kPolarisation] = polarisation;
  const double sign = y[kDuty] < 0 ? -1 : 1;
  const double inner = supply_.openCircuit(charge) - polarisation;
  const double resistance =
      motor_.resistance + escResistance_ + y[kDuty] * y[kDuty] * supply_.resistance;
  const auto current = [&](double w) {
    const double i = (std::abs(y[kDuty]) * inner - motor_.torqueConstant * w) / resistance;
    return std::min(i, maxCurrent_);
  };
  const double free = std::abs(y[kDuty]) * inner / motor_.torqueConstant;
  if (!(free > 0)) return y;
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
