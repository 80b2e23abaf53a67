#include "sim/signal/signals.h"

#include <limits>

#include <array>

namespace rotorbench {

const char* nameOf(Signal signal) {
  constexpr std::array<const char*, kSignals> kNames{"Truth",    "Measurement", "Estimate",
                                                     "SetPoint", "RotorDemand", "RotorCommand"};
  return kNames[static_cast<std::size_t>(signal)];
}

Board::Board(int count) : rotors(count) {
#ifndef NDEBUG
  const int beyond = kMostRotors - count;
  for (PerRotor* lanes :
       {&truth.drives.speed, &truth.drives.current, &measurement.drives.speed,
        &measurement.drives.current, &demand.speed, &command.value, &command.rate}) {
    lanes->tail(beyond).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
#endif
}

}  // namespace rotorbench
