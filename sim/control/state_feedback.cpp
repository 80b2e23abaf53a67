#include "sim/control/state_feedback.h"

#include <cmath>
#include <limits>

namespace rotorbench {

namespace {

using Gains = StateFeedback::Gains;

void setLane(Gains& all, int axis, const AxisGains& one, double limit, const AxisModel& model) {
  all.position[axis] = one.position;
  all.rate[axis] = one.rate;
  all.acceleration[axis] = one.acceleration;
  all.reference[axis] = one.reference;
  all.integral[axis] = one.integral;
  all.bleeding[axis] = one.bleeding;
  all.limit[axis] = limit;
  all.following[axis] = model.lag > 0 ? std::exp(-model.period / model.lag) : 0;
}

Gains gainsOf(const StateFeedbackParameters& p) {
  const AxisModel model{1 / p.rate, p.thrustLag};
  const bool withIntegral = p.stage != FeedbackStage::Plain,
             final = p.stage == FeedbackStage::Final;
  Gains all;
  const auto set = [&](int axis, const auto& poles) {
    AxisGains one =
        placedGains(model, poles.frequency, poles.damping, poles.integral, withIntegral);
    if (!final) one.bleeding = 0;
    setLane(all, axis, one, final ? poles.limit : std::numeric_limits<double>::infinity(), model);
  };
  set(0, p.altitude);
  set(1, p.roll);
  set(2, p.pitch);
  set(3, p.yaw);
  return all;
}

Gains gainsOf(const LqrParameters& p) {
  const AxisModel model{1 / p.rate, p.thrustLag};
  Gains all;
  const auto set = [&](int axis, const auto& w) {
    setLane(all, axis, optimalGains(model, w.error, w.rate, w.integral, w.demand, p.integral),
            w.limit, model);
  };
  set(0, p.altitude);
  set(1, p.roll);
  set(2, p.pitch);
  set(3, p.yaw);
  return all;
}

/// All of the demand but the integral.
Lanes<4> feedback(const Gains& g, const FlightAxes::Seen& seen, const Lanes<4>& origin,
                  const Lanes<4>& acceleration) {
  return g.reference * (seen.wanted - origin) - g.position * (seen.measured - origin) -
         g.rate * seen.rates - g.acceleration * acceleration;
}

}  // namespace

StateFeedback::StateFeedback(const StateFeedbackParameters& p, const ControlModel& model,
                             Timing timing, const Place& vehicle)
    : Controller("controller", timing), axes_(model, vehicle), gains_(gainsOf(p)) {}

StateFeedback::StateFeedback(const LqrParameters& p, const ControlModel& model, Timing timing,
                             const Place& vehicle)
    : Controller("controller", timing), axes_(model, vehicle), gains_(gainsOf(p)) {}

void StateFeedback::retune(const StateFeedbackParameters& p) {
  take(gainsOf(p));
}
void StateFeedback::retune(const LqrParameters& p) {
  take(gainsOf(p));
}

void StateFeedback::take(const Gains& gains) {
  if (started_) {
    const Lanes<4> difference = feedback(gains_, seen_, origin_, acceleration_) -
                                feedback(gains, seen_, origin_, acceleration_);
    // Without an integral there is nothing to take it up, and what was integrated is let go.
    integral_ = whereNot0(gains.integral, Lanes<4>(integral_ + difference));
  }
  gains_ = gains;
}

void StateFeedback::act(const ClockTick& /*tick*/, Board& board, double* row) {
  board.demand.speed = update(board.estimate.body, board.setPoint);
  axes_.row(row);
}

const PerRotor& StateFeedback::update(const BodyMotion& body, const SetPoint& setPoint) {
  seen_ = axes_.see(body, setPoint);
  if (!started_) {
    // From rest: a set-point equal to the first measurement asks for nothing.
    started_ = true;
    origin_ = seen_.measured;
  }
  const Lanes<4> wish = feedback(gains_, seen_, origin_, acceleration_) + integral_;
  Lanes<4> demand = clamped(wish, Lanes<4>(-gains_.limit), gains_.limit);
  axes_.carryOut(seen_.lift, demand);
  integral_ +=
      gains_.integral * (seen_.wanted - seen_.measured) + gains_.bleeding * (demand - wish);
  acceleration_ = gains_.following * acceleration_ + (1 - gains_.following) * demand;
  return axes_.speeds();
}

}  // namespace rotorbench
