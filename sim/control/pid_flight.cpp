#include "sim/control/pid_flight.h"

namespace rotorbench {

namespace {

PidGains<Lanes<4>> gainsOf(const PidFlightParameters& p) {
  return besides<4>({pidGains(p.altitude, 1 / p.rate), pidGains(p.roll, 1 / p.rate),
                     pidGains(p.pitch, 1 / p.rate), pidGains(p.yaw, 1 / p.rate)});
}

}  // namespace

PidFlight::PidFlight(const PidFlightParameters& p, const ControlModel& model, Timing timing,
                     const Place& vehicle)
    : Controller("controller", timing), axes_(model, vehicle), pid_(gainsOf(p)) {}

void PidFlight::retune(const PidFlightParameters& parameters) {
  pid_.retune(gainsOf(parameters));
}

void PidFlight::act(const ClockTick& /*tick*/, Board& board, double* row) {
  board.demand.speed = update(board.estimate.body, board.setPoint);
  axes_.row(row);
}

const PerRotor& PidFlight::update(const BodyMotion& body, const SetPoint& setPoint) {
  const FlightAxes::Seen seen = axes_.see(body, setPoint);
  Lanes<4> demand = pid_.propose(seen.wanted, seen.measured);
  axes_.carryOut(seen.lift, demand);
  pid_.accept(demand);
  return axes_.speeds();
}

}  // namespace rotorbench
