// The changes of a flight that goes on: those laid down in its experiment and those that come while
// it runs. Owns the flight as it is now; the parts of the simulation that use a changed value take
// it between two ticks.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/document/changes.h"
#include "sim/document/flight.h"

namespace rotorbench {

/// A part of a flight that takes other values between two ticks.
struct LivePart {
  std::string path;  ///< from the flight on; what lies below it is this part's
  std::function<void(const Flight& flight, double time)> take;
};

class LiveChanges {
 public:
  LiveChanges(const Flight& flight, std::vector<LivePart> parts);

  /// Whether anything is to be made before the tick number `tick`.
  [[nodiscard]] bool due(std::int64_t tick) const { return tick >= nextTick_; }
  /// Before the tick number `tick` at `time`, s: makes what is due. A problem says which change
  /// could not be made.
  std::optional<Problem> make(std::int64_t tick, double time);
  /// A change that comes between ticks, before the tick number `tick` at `time`: made now, and with
  /// this time, if its own time is not later, else when its time has come. Returns why not.
  std::optional<Problem> add(Change change, std::int64_t tick, double time);
  /// All changes, made or still to come: with these the flight repeats.
  [[nodiscard]] const std::vector<Change>& all() const { return changes_; }

 private:
  std::optional<Problem> makeOne(const Change& change, double time);
  [[nodiscard]] std::int64_t tickOf(std::size_t i) const;

  Flight flight_;  ///< without its changes, as of now
  std::vector<LivePart> parts_;
  std::vector<Change> changes_;
  std::size_t next_ = 0;  ///< the first of them that has not been made
  std::int64_t nextTick_ = std::numeric_limits<std::int64_t>::max();  ///< of that
};

}  // namespace rotorbench
