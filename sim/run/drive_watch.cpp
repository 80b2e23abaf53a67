#include "sim/run/drive_watch.h"

#include <algorithm>
#include <iterator>

namespace rotorbench {

namespace {

/// "motor 2", "motors 1, 2 and 4"; "motors" where no bit of a rotor is set.
std::string motorsOf(unsigned rotors) {
  std::vector<int> numbers;
  for (int i = 0; i < kMostRotors; ++i)
    if ((rotors >> i & 1U) != 0) numbers.push_back(i + 1);
  std::string text = numbers.size() == 1 ? "motor" : "motors";
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool last = k > 0 && k + 1 == numbers.size();
    text += (k == 0 ? " " : last ? " and " : ", ") + std::to_string(numbers[k]);
  }
  return text;
}

}  // namespace

void Episodes::add(const ClockTick& tick, unsigned rotors) {
  const double end = tick.time + tick.length;
  if (all_.empty() || tick.time - all_.back().end > kGap) {
    if (!all_.empty() && !all_.back().counts()) all_.pop_back();
    if (all_.size() < kMost) all_.push_back({tick.time, end, 0});
  }
  all_.back().end = end;
  all_.back().rotors |= rotors;
}

std::vector<RunEvent> Episodes::events(const std::string& name, const std::string& what) const {
  std::vector<RunEvent> events;
  for (const Episode& e : all_)
    if (e.counts()) events.push_back({e.begin, e.end, name, motorsOf(e.rotors) + " " + what});
  return events;
}

double Episodes::seconds() const {
  double sum = 0;
  for (const Episode& e : all_)
    if (e.counts()) sum += e.end - e.begin;
  return sum;
}

std::vector<Verdict> DriveWatch::verdicts() const {
  if (std::isnan(gone_)) return {};
  return {{gone_, "supply_collapsed", "the supply fell to 0 V under the motors' currents"}};
}

std::vector<RunEvent> DriveWatch::events() const {
  std::vector<RunEvent> events = full_.events("motors_saturated", "saturated");
  std::ranges::move(current_.events("current_limited", "at the current limit"),
                    std::back_inserter(events));
  return events;
}

}  // namespace rotorbench
