#include "sim/run/energy_watch.h"

#include "sim/core/number_text.h"

namespace rotorbench {

RunFailure EnergyWatch::failure(double time, double gained, double drawn) {
  return {time, "energy",
          "body and rotors have " + shortNumber(gained, 3) +
              " J more than they began with and the " + shortNumber(drawn, 3) +
              " J of the supply gave them: a step is too long for the equations, or a rotor is "
              "faster in the air than its model holds (inflow of 0)."};
}

}  // namespace rotorbench
