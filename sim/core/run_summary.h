// What is said of a finished run beside its recordings: its figures, what it came to, and what was
// doubtful before it.
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

struct RunSummary {
  MetricTable metrics;
  std::vector<Verdict> verdicts;  ///< in the order of time
  std::vector<Problem> warnings;  ///< of the experiment
};

}  // namespace rotorbench
