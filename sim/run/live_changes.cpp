#include "sim/run/live_changes.h"

#include <algorithm>
#include <utility>

#include "sim/core/schema_tree.h"

namespace rotorbench {

namespace {

bool isBelow(const std::string& path, const std::string& part) {
  return path.starts_with(part) &&
         (path.size() == part.size() || path[part.size()] == '.' || path[part.size()] == '[');
}

}  // namespace

LiveChanges::LiveChanges(const Flight& flight, std::vector<LivePart> parts)
    : flight_(flight), parts_(std::move(parts)), changes_(std::move(flight_.changes)) {
  flight_.changes.clear();
  nextTick_ = tickOf(0);
}

std::int64_t LiveChanges::tickOf(std::size_t i) const {
  if (i == changes_.size()) return std::numeric_limits<std::int64_t>::max();
  return tickOfChange(changes_[i].time, flight_.tick);
}

std::optional<Problem> LiveChanges::make(std::int64_t tick, double time) {
  while (nextTick_ <= tick) {
    if (auto problem = makeOne(changes_[next_], time)) return problem;
    nextTick_ = tickOf(++next_);
  }
  return {};
}

std::optional<Problem> LiveChanges::makeOne(const Change& change, double time) {
  const std::string path = flightPath(change.parameter);
  const auto part =
      std::ranges::find_if(parts_, [&](const LivePart& p) { return isBelow(path, p.path); });
  if (part == parts_.end()) {
    Flight unchanged = flight_;
    if (auto problem = makeChange(unchanged, change)) return problem;
    return Problem{path, "cannot change during this flight", "it needs a new run"};
  }
  if (auto problem = makeChange(flight_, change)) return problem;
  part->take(flight_, time);
  return {};
}

std::optional<Problem> LiveChanges::add(Change change, std::int64_t tick, double time) {
  for (Problem& problem : schema::validate(schema::ref(std::as_const(change))))
    return std::move(problem);
  // What is due now came first, here as in a repetition.
  if (auto problem = make(tick, time)) return problem;
  if (tickOfChange(change.time, flight_.tick) > tick) {
    Flight then = flight_;
    if (auto problem = makeChange(then, change)) return problem;
    const auto place = std::ranges::upper_bound(changes_, change.time, {}, &Change::time);
    changes_.insert(place, std::move(change));
  } else {
    // Not before one that was made at this tick and is later by rounding: times must not fall.
    change.time = next_ > 0 ? std::max(time, changes_[next_ - 1].time) : time;
    if (auto problem = makeOne(change, time)) return problem;
    changes_.insert(changes_.begin() + static_cast<std::ptrdiff_t>(next_++), std::move(change));
  }
  nextTick_ = tickOf(next_);
  return {};
}

}  // namespace rotorbench
