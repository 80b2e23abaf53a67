#include "sim/propulsion/advance_sweep.h"

#include <cmath>
#include <numbers>

namespace rotorbench {

AdvancePoint advancePoint(const BladeElementRotor& rotor, double omega, double axialSpeed,
                          const AirState& air) {
  const double turns = omega / (2 * std::numbers::pi), diameter = 2 * rotor.radius();
  const double scale = air.density * turns * turns * std::pow(diameter, 4);
  AdvancePoint point;
  point.advanceRatio = axialSpeed / (turns * diameter);
  if (!(scale > 0)) return point;
  const AxialLoad load = rotor.axial(omega, axialSpeed, air);
  point.thrustCoefficient = load.thrust / scale;
  point.powerCoefficient = load.torque * 2 * std::numbers::pi / (scale * diameter);
  if (point.thrustCoefficient > 0 && point.powerCoefficient > 0)
    point.efficiency = point.advanceRatio * point.thrustCoefficient / point.powerCoefficient;
  return point;
}

AdvanceSweep advanceSweep(const BladeElementRotor& rotor, double omega, const AirState& air,
                          double step) {
  constexpr double kMostAdvance = 2;
  const double speedPerAdvance = omega / (2 * std::numbers::pi) * 2 * rotor.radius();
  const int most = static_cast<int>(std::floor(kMostAdvance / step + 1e-9));
  AdvanceSweep curves;
  for (int k = 0; k <= most; ++k) {
    const AdvancePoint point = advancePoint(rotor, omega, k * step * speedPerAdvance, air);
    if (!curves.points.empty() && !curves.zeroThrust && point.thrustCoefficient < 0) {
      const AdvancePoint& last = curves.points.back();
      if (last.thrustCoefficient > 0) {
        curves.zeroThrust =
            last.advanceRatio +
            step * last.thrustCoefficient / (last.thrustCoefficient - point.thrustCoefficient);
      }
    }
    curves.points.push_back(point);
    if (point.efficiency > (curves.best ? curves.best->efficiency : 0)) curves.best = point;
    if (point.thrustCoefficient < 0) break;
  }
  const AdvancePoint& rest = curves.points.front();
  if (rest.thrustCoefficient > 0 && rest.powerCoefficient > 0) {
    curves.figureOfMerit = std::pow(rest.thrustCoefficient, 1.5) * std::sqrt(2 / std::numbers::pi) /
                           rest.powerCoefficient;
  }
  return curves;
}

}  // namespace rotorbench
