#include "sim/core/run_summary.h"

#include <cmath>

#include "sim/core/number_text.h"

namespace rotorbench {

std::string sentence(const Verdict& verdict) {
  return verdict.what + " at " + numberText(std::round(verdict.time * 1000) / 1000) + " s";
}

}  // namespace rotorbench
