#include "sim/control/pid.h"

#include <cmath>
#include <string>

namespace rotorbench {

int ticksBetween(double rate, double tick, const Place& place) {
  const double ticks = 1 / (rate * tick);
  const double whole = std::round(ticks);
  if (!(whole >= 1) || !(whole < 1e9) || std::abs(ticks - whole) > 1e-6 * whole) {
    throw place.error({{{},
                        "the rate does not fit the tick of the simulation",
                        "a rate that divides " + std::to_string(std::lround(1 / tick)) + " Hz"}});
  }
  return static_cast<int>(whole);
}

}  // namespace rotorbench
