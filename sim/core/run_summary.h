// What is said of a finished run beside its recordings: its figures, what it came to, what happened
// on the way, and what was doubtful before it.
#pragma once

#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/metrics.h"

namespace rotorbench {

/// Something a run came to that nobody asked for. The run goes on; whoever reads its figures must
/// know.
struct Verdict {
  double time = 0;   ///< s, since when
  std::string name;  ///< snake_case, "below_ground"
  std::string what;  ///< reads on after "Finished:" and before "at 3.1 s": "below the ground"
  bool operator==(const Verdict&) const = default;
};

/// "below the ground at 3.1 s".
std::string sentence(const Verdict& verdict);

/// Something that happened to a run and that may well have been meant: a motor at full throttle, a
/// recording thinned out. Verdicts are among them.
struct RunEvent {
  double time = 0, end = 0;  ///< s; the same for an instant and for what lasts to the end
  std::string name;          ///< snake_case, "motors_saturated"
  std::string what;          ///< reads on before "at 3.1 s": "motor 2 saturated"
  bool operator==(const RunEvent&) const = default;
};

/// "motor 2 saturated at 3.1 s for 0.25 s".
std::string sentence(const RunEvent& event);

struct RunSummary {
  MetricTable metrics;
  std::vector<Verdict> verdicts;   ///< in the order of time
  std::vector<Problem> warnings;   ///< of the experiment
  std::vector<RunEvent> events{};  ///< in the order of time
};

}  // namespace rotorbench
