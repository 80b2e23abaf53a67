#include "sim/control/pid_flight.h"

#include <cmath>
#include <numbers>

namespace rotorbench {

namespace {

/// Beyond 60 degrees of tilt thrust no longer makes up for the lost lift.
constexpr double kLeastLiftCosine = 0.5;

}  // namespace

double AngleUnwrapper::operator()(double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (started_) angle += kTurn * std::round((last_ - angle) / kTurn);
  startAt(angle);
  return angle;
}

template <int N>
PidFlightController<N>::PidFlightController(const PidFlightParameters& p,
                                            const ControlModel<N>& model, double tick)
    : model_(model),
      allocation_(model),
      altitude_(p.altitude, 1 / p.rate),
      roll_(p.roll, 1 / p.rate),
      pitch_(p.pitch, 1 / p.rate),
      yaw_(p.yaw, 1 / p.rate),
      flightTicks_(ticksBetween(p.rate, tick, "controller.rate")),
      motorTicks_(ticksBetween(p.motors.rate, tick, "controller.motors.rate")) {
  for (std::size_t i = 0; i < N; ++i) {
    motors_.emplace_back(p.motors, model.motors[i], model.escs[i], model.rotorInertia[i],
                         model.torqueFactor[i]);
  }
}

template <int N>
void PidFlightController<N>::updateFlight(const Measurement<N>& measured,
                                          const FlightSetPoint& setPoint) {
  const double lift =
      std::max(kLeastLiftCosine, std::cos(measured.attitude[0]) * std::cos(measured.attitude[1]));
  const double yaw = measuredYaw_(measured.attitude[2]);
  if (!wantedYaw_.started()) wantedYaw_.startAt(yaw);
  const double climb = altitude_.propose(setPoint.height, measured.position[2]);
  const Eigen::Vector3d turn(roll_.propose(setPoint.roll, measured.attitude[0]),
                             pitch_.propose(setPoint.pitch, measured.attitude[1]),
                             yaw_.propose(wantedYaw_(setPoint.yaw), yaw));
  wrench_ << model_.mass * (model_.gravity + climb) / lift, model_.inertia * turn;

  const auto result = allocation_.allocate(wrench_);
  limited_ = result.limited;
  Eigen::Vector3d turned = turn;
  double climbed = climb;
  if (limited_) {
    turned = model_.inverseInertia * result.achieved.template tail<3>();
    climbed = result.achieved[0] * lift / model_.mass - model_.gravity;
  }
  altitude_.accept(climbed);
  roll_.accept(turned[0]);
  pitch_.accept(turned[1]);
  yaw_.accept(turned[2]);
  for (int i = 0; i < N; ++i) {
    speeds_[i] = std::sqrt(result.thrust[i] / model_.thrustFactor[static_cast<std::size_t>(i)]);
  }
}

template <int N>
const typename PidFlightController<N>::Duties& PidFlightController<N>::update(
    const Measurement<N>& measured, const FlightSetPoint& setPoint) {
  if (flightCount_ == 0) updateFlight(measured, setPoint);
  if (++flightCount_ == flightTicks_) flightCount_ = 0;
  if (motorCount_ == 0) {
    const double bus = std::max(measured.busVoltage, 1e-3);
    for (int i = 0; i < N; ++i) {
      duties_[i] =
          motors_[static_cast<std::size_t>(i)].update(speeds_[i], measured.rotorSpeed[i], bus) /
          bus;
    }
  }
  if (++motorCount_ == motorTicks_) motorCount_ = 0;
  return duties_;
}

template class PidFlightController<4>;

void Describe<PidFlightParameters>::fields(schema::Builder<PidFlightParameters>& b) {
  using P = PidFlightParameters;
  b.title(
      "pid", "PID (controller 1)",
      "Holds altitude, roll, pitch and yaw with one PID each; rotor speeds follow by motor speed "
      "controllers. Sideways drift is not controlled.",
      "Thesis 2014, figures 4.2-4.3");
  b.number("rate", &P::rate, "Rate", "", "Hz")
      .range(schema::above(0), schema::upTo(1e5))
      .help(
          "Updates per second of altitude and attitude; must divide the tick rate of the "
          "simulation.");
  b.group("altitude", &P::altitude, "Altitude");
  b.group("roll", &P::roll, "Roll");
  b.group("pitch", &P::pitch, "Pitch");
  b.group("yaw", &P::yaw, "Yaw");
  b.group("motors", &P::motors, "Motors");
}

}  // namespace rotorbench
