#include "sim/run/preflight.h"

#include <algorithm>
#include <iterator>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment.h"
#include "sim/document/kinds.h"
#include "sim/run/drive_warnings.h"
#include "sim/run/flight_warnings.h"

namespace rotorbench {

namespace {

/// Kinds without an overload have nothing to doubt beyond their own rules.
struct WarningsOf {
  template <class Kind>
  std::vector<Problem> operator()(const Kind& /*setup*/) const {
    return {};
  }
  std::vector<Problem> operator()(const Flight& flight) const { return flightWarnings(flight); }
  std::vector<Problem> operator()(const MotorBench& m) const {
    std::vector<Problem> problems;
    warnOfUnstableStep(m.stand, m.run.solver, m.run.tick, problems);
    return problems;
  }
  std::vector<Problem> operator()(const ThrustStand& s) const {
    std::vector<Problem> problems;
    warnOfUnstableStep(s.stand, s.run.solver, s.run.tick, problems);
    return problems;
  }
  std::vector<Problem> operator()(const MotorSpeedRun& m) const {
    std::vector<Problem> problems;
    warnOfDelays(m.stand.esc, "stand.esc", m.controller.rate, problems);
    checkRate(m.controller.rate, m.run.tick, "controller.rate", problems);
    warnOfUnstableStep(m.stand, m.run.solver, m.run.tick, problems);
    return problems;
  }
};

}  // namespace

std::vector<Problem> runWarnings(const Experiment& experiment) {
  const auto faults = schema::validate(schema::ref(experiment));
  // Nothing can be built of what has faults.
  if (!std::ranges::all_of(faults, &Problem::warning)) return {};
  std::vector<Problem> warnings = visitAlternative(WarningsOf{}, experiment.setup);
  for (Problem& warning : warnings) warning.path = "setup." + warning.path;
  return warnings;
}

std::vector<Problem> preflight(const Experiment& experiment) {
  auto problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return !p.warning; });
  std::ranges::move(runWarnings(experiment), std::back_inserter(problems));
  return problems;
}

}  // namespace rotorbench
