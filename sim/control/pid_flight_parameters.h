// Settings of controller 1 (sim/control/pid_flight.h).
// Default gains place the poles of the double integrator angle'' = u with integral action at one
// real pole -p and a pair (w, zeta): kd = 2 zeta w + p, kp = w^2 + 2 zeta w p, ki = w^2 p; the
// set-point weight ki/(p kp) cancels the real pole, so that a step answers like the pair alone.
#pragma once

#include <cmath>

#include "sim/control/pid_parameters.h"

namespace rotorbench {

/// Gains by pole placement as above, in rad/s.
template <PidUse Use>
PidParameters<Use> pidForPoles(double pair, double damping, double real, double limit) {
  PidParameters<Use> p;
  // Four digits, as a person would enter them.
  const auto rounded = [](double gain) {
    const double scale = std::pow(10.0, 3 - std::floor(std::log10(gain)));
    return std::round(gain * scale) / scale;
  };
  p.kp = rounded(pair * pair + 2 * damping * pair * real);
  p.ki = rounded(pair * pair * real);
  p.kd = rounded(2 * damping * pair + real);
  p.setPointWeight = rounded(p.ki / (real * p.kp));
  p.limit = limit;
  return p;
}

struct PidFlightParameters {
  double rate = 500;  ///< Hz, of the altitude and attitude loops
  PidParameters<PidUse::Height> altitude = pidForPoles<PidUse::Height>(2, 0.9, 1.5, 6);
  PidParameters<PidUse::Angle> roll = pidForPoles<PidUse::Angle>(7, 0.8, 4, 100);
  PidParameters<PidUse::Angle> pitch = pidForPoles<PidUse::Angle>(7, 0.8, 4, 100);
  PidParameters<PidUse::Angle> yaw = pidForPoles<PidUse::Angle>(2, 0.9, 1.5, 10);
  bool operator==(const PidFlightParameters&) const = default;
};

template <>
struct Describe<PidFlightParameters> {
  static void fields(schema::Builder<PidFlightParameters>& b);
};

}  // namespace rotorbench
