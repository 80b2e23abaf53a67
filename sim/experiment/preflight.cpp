#include "sim/experiment/preflight.h"

#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/experiment/experiment.h"
#include "sim/experiment/hover_check.h"

namespace rotorbench {

std::vector<Problem> flightWarnings(const Experiment& experiment) {
  std::vector<Problem> warnings;
  const auto* flight = std::get_if<Flight>(&experiment.setup);
  if (flight == nullptr) return warnings;
  const auto problems = schema::validate(schema::ref(experiment));
  if (std::ranges::all_of(problems, &Problem::warning)) warnOfHover(*flight, warnings);
  for (Problem& warning : warnings) warning.path = "setup." + warning.path;
  return warnings;
}

std::vector<Problem> preflight(const Experiment& experiment) {
  auto problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return !p.warning; });
  std::ranges::move(flightWarnings(experiment), std::back_inserter(problems));
  return problems;
}

}  // namespace rotorbench
