#include "sim/core/run_summary.h"

#include <cmath>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

std::string seconds(double time) {
  return numberText(std::round(time * 1000) / 1000) + " s";
}

}  // namespace

std::string sentence(const Verdict& verdict) {
  return verdict.what + " at " + seconds(verdict.time);
}

std::string sentence(const RunEvent& event) {
  const std::string at = event.what + " at " + seconds(event.time);
  return event.end > event.time ? at + " for " + seconds(event.end - event.time) : at;
}

}  // namespace rotorbench
