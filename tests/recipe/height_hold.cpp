#include "sim/control/height_hold.h"

#include <cmath>

namespace rotorbench {

HeightHold::HeightHold(const HeightHoldParameters& parameters, const ControlModel& model,
                       Timing timing, const Place& vehicle)
    : Controller("controller", timing),
      parameters_(parameters),
      model_(model),
      allocation_(model, vehicle) {}

std::vector<HeldQuantity> HeightHold::held() const {
  return {{"altitude", "position.z", "setpoint.z", 1, false,
           [](const SetPoint& s) -> const double& { return s.height; },
           [](const Truth& t) -> const double& { return t.body.position[2]; }}};
}

std::vector<Channel> HeightHold::channels() const {
  return {{"controller.climb", "m/s^2", "Climb demanded"}};
}

void HeightHold::act(const ClockTick& /*tick*/, Board& board, double* row) {
  const BodyMotion& is = board.estimate.body;
  const double climb = parameters_.stiffness * (board.setPoint.height - is.position[2]) -
                       parameters_.damping * is.velocity[2];
  const Eigen::Vector3d turn = -100 * is.attitude - 20 * is.rates;  // poles at -10 rad/s
  Wrench wrench;
  wrench << model_.mass * (model_.gravity + climb), model_.inertia * turn;
  const auto thrust = allocation_.allocate(wrench).thrust;
  for (int i = 0; i < model_.rotors; ++i) {
    const auto k = static_cast<std::size_t>(i);
    board.demand.speed[i] = std::sqrt(thrust[i] / model_.thrustFactor[k]);
  }
  row[0] = climb;
}

void Describe<HeightHoldParameters>::fields(schema::Builder<HeightHoldParameters>& b) {
  using P = HeightHoldParameters;
  b.title("height-hold", "Height hold", "Holds the height and keeps the vehicle level.");
  b.number("rate", &P::rate, "Rate", "", "Hz").range(schema::above(0), schema::upTo(1e5));
  b.number("stiffness", &P::stiffness, "Stiffness", "k", "1/s^2")
      .range(schema::atLeast(0), schema::upTo(1e3));
  b.number("damping", &P::damping, "Damping", "d", "1/s")
      .range(schema::atLeast(0), schema::upTo(1e3));
}

}  // namespace rotorbench
