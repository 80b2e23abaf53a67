#include "sim/propulsion/rotor/advance_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotorbench {

AdvancePoint coefficientsOf(const AxialLoad& load, double omega, double axialSpeed, double diameter,
                            double density) {
  const double turns = std::abs(omega) / (2 * std::numbers::pi);
  const double scale = density * turns * turns * std::pow(diameter, 4);
  if (!(scale > 0)) return {};
  AdvancePoint point;
  point.advanceRatio = axialSpeed / (turns * diameter);
  point.thrustCoefficient = load.thrust / scale;
  point.powerCoefficient = 2 * std::numbers::pi * load.torque / (scale * diameter);
  if (point.thrustCoefficient > 0 && point.powerCoefficient > 0)
    point.efficiency =
        std::max(0.0, point.advanceRatio * point.thrustCoefficient / point.powerCoefficient);
  return point;
}

AdvancePoint advancePoint(const BladeElementRotor& rotor, double omega, double axialSpeed,
                          const AirState& air) {
  return coefficientsOf(rotor.axial(omega, axialSpeed, air), omega, axialSpeed, 2 * rotor.radius(),
                        air.density);
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
