#include "sim/run/flight_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotorbench {

FlightWatch::FlightWatch(std::vector<HeldQuantity> held, const Board& board)
    : truth_(board.truth),
      belowGround_(std::numeric_limits<double>::quiet_NaN()),
      overturned_(belowGround_) {
  for (HeldQuantity& q : held)
    held_.push_back({.wantedNow = &q.wanted(board.setPoint),
                     .valueNow = &q.value(board.truth),
                     .limit = q.limit,
                     .turns = q.turns,
                     .name = std::move(q.name)});
}

void FlightWatch::move(Held& h, double wanted, double value) {
  const double moved = h.turns ? shortWay(wanted - h.wanted) : wanted - h.wanted;
  if (std::isnan(h.wanted)) {
    h.error = h.turns ? shortWay(wanted - value) : wanted - value;
    h.nearest = std::abs(h.error);
    h.value = value;
  } else {
    h.error += moved;
    h.nearest += std::abs(moved);
  }
  h.wanted = wanted;
}

std::vector<Verdict> FlightWatch::verdicts() const {
  std::vector<Verdict> found;
  if (!std::isnan(belowGround_))
    found.push_back({belowGround_, "below_ground", "below the ground"});
  // Who lays inputs down in advance has asked for the attitude they lead to.
  if (!std::isnan(overturned_) && !held_.empty())
    found.push_back({overturned_, "overturned", "tilted beyond 90 degrees"});
  for (const Held& h : held_) {
    if (std::isnan(h.wanted) || time_ - h.near < kLeastAbsence) continue;
    found.push_back({h.near, h.name + "_lost", "lost control of " + h.name});
  }
  std::ranges::stable_sort(found, {}, &Verdict::time);
  return found;
}

}  // namespace rotorbench
