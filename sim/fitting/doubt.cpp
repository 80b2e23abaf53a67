#include "sim/fitting/doubt.h"

#include <cmath>

#include "sim/core/number_text.h"
#include "sim/fitting/provenance.h"

namespace rotorbench {

namespace {

std::string shown(const FittedParameter& p, double value) {
  return numberIn(value, p.parameter.unit, p.parameter.shown);
}

/// " (start 1100 rpm/V)", or nothing where the start was a guess.
std::string startOf(const FittedParameter& p) {
  return p.parameter.startIsGuess ? "" : " (start " + shown(p, p.parameter.start) + ")";
}

std::string doubtOf(const FittedParameter& p) {
  const std::string& label = p.parameter.label;
  if (!p.determined) return label + ": the data do not determine it" + startOf(p) + ".";
  if (p.atBound()) {
    return label + ": " + shown(p, p.value) + " is the end of its range" + startOf(p) +
           ", the data do not determine it.";
  }
  const double start = p.parameter.start;
  const double change = (p.value - start) / std::abs(start);
  if (p.parameter.startIsGuess || start == 0 || std::abs(change) <= kFarFromStart) return {};
  const bool times = change > 2;
  return label + ": " + shown(p, p.value) + " is " +
         (times ? shortNumber(p.value / start, 2) + " times its start of "
                : shortNumber(100 * std::abs(change), 2) + " % " +
                      (change > 0 ? "above" : "below") + " its start of ") +
         shown(p, start) + ".";
}

}  // namespace

std::vector<std::string> doubtsOf(const FitResult& result) {
  std::vector<std::string> doubts;
  if (!result.usable()) return doubts;
  for (const FittedParameter& p : result.parameters) {
    std::string doubt = doubtOf(p);
    if (!doubt.empty()) doubts.push_back(std::move(doubt));
  }
  return doubts;
}

std::string verdictOf(const FitResult& result) {
  const std::vector<std::string> doubts = doubtsOf(result);
  if (doubts.empty()) return result.sentence;
  std::string text = "Doubtful.";
  for (const std::string& doubt : doubts) text += " " + doubt;
  if (result.end != FitEnd::Converged) text += " " + result.sentence;
  return text;
}

}  // namespace rotorbench
