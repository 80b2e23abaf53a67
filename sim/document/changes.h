// What changes while a flight goes on: gains, set-points, wind. A change is what `--set path=value`
// is before a flight, with a time. It acts between two ticks: from the first tick on that is not
// before its time. Changes laid down in advance and changes made by hand during a run are the same;
// a run keeps both, so that its experiment repeats it bit for bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench {

struct Experiment;
struct Flight;

struct Change {
  double time = 0;        ///< s
  std::string parameter;  ///< path from the flight on: "control.controller.roll.kp"
  std::string value;      ///< as a person types it: "30", "[5, 0, 0] m/s"; without a unit SI
  bool operator==(const Change&) const = default;
};

template <>
struct Describe<Change> {
  static void fields(schema::Builder<Change>& b);
};

/// Gives the parameter its value. Returns what is wrong, with the flight unchanged: no such
/// parameter, one that needs a new run, or a value that is not allowed. The paths of problems are
/// those of the flight.
std::optional<Problem> makeChange(Flight& flight, const Change& change);

/// A path from the flight on, also where it was given from the root of the experiment, as forms and
/// `--set` name it: "setup.control..." is "control...".
std::string flightPath(const std::string& path);

/// The set-points that hands can take from the timeline.
enum class HandAxis { Height, Roll, Pitch, Yaw };
/// Whether a flight has set-points that a hand can take.
bool hasSetPoints(const Flight& flight);
/// The hand takes a set-point, or moves it: to `value`, m or rad.
std::vector<Change> takenByHand(HandAxis axis, double value);
/// The timeline has it again.
Change givenBack(HandAxis axis);

/// The experiment of a run, with what has changed in it; nothing happens to one that is no flight.
void setChanges(Experiment& experiment, const std::vector<Change>& changes);

/// The tick, counted from 0, before which a change of this time acts.
std::int64_t tickOfChange(double time, double tick);

/// What one flight must be told to become the other while it goes on.
struct LiveDifference {
  std::vector<Change> changes;  ///< their times are 0
  std::string other;  ///< label of the first difference that only another run can have; empty: none
};
LiveDifference liveDifference(const Flight& from, const Flight& to);

}  // namespace rotorbench
