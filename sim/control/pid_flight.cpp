#include "sim/control/pid_flight.h"

#include <algorithm>
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

PidFlight::PidFlight(const PidFlightParameters& p, const ControlModel& model, Timing timing,
                     const Place& vehicle)
    : Controller("controller", timing),
      model_(model),
      allocation_(model, vehicle),
      altitude_(p.altitude, 1 / p.rate),
      roll_(p.roll, 1 / p.rate),
      pitch_(p.pitch, 1 / p.rate),
      yaw_(p.yaw, 1 / p.rate) {}

std::vector<HeldQuantity> PidFlight::held() const {
  // Far outside what a step's overshoot or a gust does to a vehicle that flies.
  constexpr double kHeight = 1;                    // m
  constexpr double kAngle = std::numbers::pi / 6;  // rad
  return {
      {"altitude", "position.z", "setpoint.z", kHeight, false,
       [](const SetPoint& s) { return s.height; },
       [](const Truth& t) { return t.body.position[2]; }},
      {"roll", "attitude.roll", "setpoint.roll", kAngle, false,
       [](const SetPoint& s) { return s.roll; }, [](const Truth& t) { return t.body.attitude[0]; }},
      {"pitch", "attitude.pitch", "setpoint.pitch", kAngle, false,
       [](const SetPoint& s) { return s.pitch; },
       [](const Truth& t) { return t.body.attitude[1]; }},
      {"yaw", "attitude.yaw", "setpoint.yaw", kAngle, true, [](const SetPoint& s) { return s.yaw; },
       [](const Truth& t) { return t.body.attitude[2]; }}};
}

std::vector<Channel> PidFlight::channels() const {
  std::vector<Channel> all{{"control.thrust", "N", "Total thrust demanded"},
                           {"control.momentX", "N*m", "Roll moment demanded"},
                           {"control.momentY", "N*m", "Pitch moment demanded"},
                           {"control.momentZ", "N*m", "Yaw moment demanded"},
                           {"control.limited", "1", "1 while the rotors cannot meet the demand"}};
  for (int i = 1; i <= model_.rotors; ++i)
    all.push_back({rotorChannel(i, "speedSetpoint"), "rad/s", "Rotor speed demanded"});
  return all;
}

void PidFlight::act(const ClockTick& /*tick*/, Board& board, double* row) {
  board.demand.speed = update(board.estimate.body, board.setPoint);
  row = std::copy(wrench_.begin(), wrench_.end(), row);
  *row++ = limited_ ? 1.0 : 0.0;
  std::copy_n(speeds_.begin(), model_.rotors, row);
}

const PerRotor& PidFlight::update(const BodyMotion& body, const SetPoint& setPoint) {
  const double lift =
      std::max(kLeastLiftCosine, std::cos(body.attitude[0]) * std::cos(body.attitude[1]));
  const double yaw = measuredYaw_(body.attitude[2]);
  if (!wantedYaw_.started()) wantedYaw_.startAt(yaw);
  const double climb = altitude_.propose(setPoint.height, body.position[2]);
  const Eigen::Vector3d turn(roll_.propose(setPoint.roll, body.attitude[0]),
                             pitch_.propose(setPoint.pitch, body.attitude[1]),
                             yaw_.propose(wantedYaw_(setPoint.yaw), yaw));
  wrench_ << model_.mass * (model_.gravity + climb) / lift, model_.inertia * turn;

  const auto result = allocation_.allocate(wrench_);
  limited_ = result.limited;
  Eigen::Vector3d turned = turn;
  double climbed = climb;
  if (limited_) {
    turned = model_.inverseInertia * result.achieved.tail<3>();
    climbed = result.achieved[0] * lift / model_.mass - model_.gravity;
  }
  altitude_.accept(climbed);
  roll_.accept(turned[0]);
  pitch_.accept(turned[1]);
  yaw_.accept(turned[2]);
  for (int i = 0; i < model_.rotors; ++i)
    speeds_[i] = std::sqrt(result.thrust[i] / model_.thrustFactor[static_cast<std::size_t>(i)]);
  return speeds_;
}

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
