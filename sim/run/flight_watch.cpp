#include "sim/run/flight_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rotorbench {

FlightWatch::FlightWatch(std::vector<HeldQuantity> held)
    : belowGround_(std::numeric_limits<double>::quiet_NaN()), overturned_(belowGround_) {
  for (HeldQuantity& quantity : held) held_.push_back({.quantity = std::move(quantity)});
}

std::vector<Verdict> FlightWatch::verdicts() const {
  std::vector<Verdict> found;
  if (!std::isnan(belowGround_))
    found.push_back({belowGround_, "below_ground", "below the ground"});
  // Who lays inputs down in advance has asked for the attitude they lead to.
  if (!std::isnan(overturned_) && !held_.empty())
    found.push_back({overturned_, "overturned", "tilted beyond 90 degrees"});
  for (const Held& h : held_) {
    if (!h.started || time_ - h.near < kLeastAbsence) continue;
    found.push_back(
        {h.near, h.quantity.name + "_lost", "the set-point of " + h.quantity.name + " was left"});
  }
  std::ranges::stable_sort(found, {}, &Verdict::time);
  return found;
}

}  // namespace rotorbench
