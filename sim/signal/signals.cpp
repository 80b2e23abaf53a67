#include "sim/signal/signals.h"

#include <array>

namespace rotorbench {

const char* nameOf(Signal signal) {
  constexpr std::array<const char*, kSignals> kNames{"Truth",    "Measurement", "Estimate",
                                                     "SetPoint", "RotorDemand", "RotorCommand"};
  return kNames[static_cast<std::size_t>(signal)];
}

}  // namespace rotorbench
