#include "sim/control/flight_axes.h"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"

namespace rotorbench {

namespace {

/// Beyond 60 degrees of tilt thrust no longer makes up for the lost lift.
constexpr double kLeastLiftCosine = 0.5;

}  // namespace

double AngleUnwrapper::operator()(double angle) {
  if (started_) angle += kTurn * std::round((last_ - angle) / kTurn);
  startAt(angle);
  return angle;
}

FlightAxes::FlightAxes(const ControlModel& model, const Place& vehicle)
    : model_(model), allocation_(model, vehicle) {}

std::vector<HeldQuantity> FlightAxes::held() {
  // Far outside what a step's overshoot or a gust does to a vehicle that flies.
  constexpr double kHeight = 1;       // m
  constexpr double kAngle = kPi / 6;  // rad
  return {{"altitude", "position.z", "setpoint.z", kHeight, false,
           [](const SetPoint& s) -> const double& { return s.height; },
           [](const Truth& t) -> const double& { return t.body.position[2]; }},
          {"roll", "attitude.roll", "setpoint.roll", kAngle, false,
           [](const SetPoint& s) -> const double& { return s.roll; },
           [](const Truth& t) -> const double& { return t.body.attitude[0]; }},
          {"pitch", "attitude.pitch", "setpoint.pitch", kAngle, false,
           [](const SetPoint& s) -> const double& { return s.pitch; },
           [](const Truth& t) -> const double& { return t.body.attitude[1]; }},
          {"yaw", "attitude.yaw", "setpoint.yaw", kAngle, true,
           [](const SetPoint& s) -> const double& { return s.yaw; },
           [](const Truth& t) -> const double& { return t.body.attitude[2]; }}};
}

std::vector<Channel> FlightAxes::channels() const {
  std::vector<Channel> all{{"control.thrust", "N", "Total thrust demanded"},
                           {"control.momentX", "N*m", "Roll moment demanded"},
                           {"control.momentY", "N*m", "Pitch moment demanded"},
                           {"control.momentZ", "N*m", "Yaw moment demanded"},
                           {"control.limited", "1", "1 while the rotors cannot meet the demand"}};
  for (int i = 1; i <= model_.rotors; ++i)
    all.push_back({rotorChannel(i, "speedSetpoint"), "rad/s", "Rotor speed demanded"});
  return all;
}

void FlightAxes::row(double* out) const {
  Eigen::Map<Wrench>{out} = wrench_;
  out[4] = limited_ ? 1.0 : 0.0;
  for (int i = 0; i < model_.rotors; ++i) out[5 + i] = speeds_[i];
}

FlightAxes::Seen FlightAxes::see(const BodyMotion& body, const SetPoint& setPoint) {
  Seen seen;
  seen.lift = std::max(kLeastLiftCosine, std::cos(body.attitude[0]) * std::cos(body.attitude[1]));
  const double yaw = measuredYaw_(body.attitude[2]);
  if (!wantedYaw_.started()) wantedYaw_.startAt(yaw);
  seen.wanted << setPoint.height, setPoint.roll, setPoint.pitch, wantedYaw_(setPoint.yaw);
  seen.measured << body.position[2], body.attitude[0], body.attitude[1], yaw;
  seen.rates << body.velocity[2], body.rates[0], body.rates[1], body.rates[2];
  return seen;
}

void FlightAxes::carryOut(double lift, Axes& demand) {
  const Eigen::Vector3d turn = demand.tail<3>().matrix();
  wrench_ << model_.mass * (model_.gravity + demand[0]) / lift, model_.inertia * turn;

  const auto result = allocation_.allocate(wrench_);
  limited_ = result.limited;
  if (limited_) {
    demand[0] = result.achieved[0] * lift / model_.mass - model_.gravity;
    demand.tail<3>().matrix() = model_.inverseInertia * result.achieved.tail<3>();
  }
  for (int i = 0; i < model_.rotors; ++i)
    speeds_[i] = std::sqrt(result.thrust[i] / model_.thrustFactor[static_cast<std::size_t>(i)]);
}

}  // namespace rotorbench
