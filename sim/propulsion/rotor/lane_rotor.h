// BladeElementRotor::oblique() for whoever solves thousands of states, such as a propeller map:
// the same annuli, azimuths, momentum theory and rule of several roots, but in single precision
// with several annuli side by side (lane_inflow.h), and with sections read from a table
// (section_table.h). Some ten times as fast, and within 1e-4 of the static loads of it.
#pragma once

#include "sim/propulsion/rotor/lane_inflow.h"
#include "sim/propulsion/rotor/section_table.h"

namespace rotorbench {

class LaneRotor {
 public:
  /// `leastReynolds` to `mostReynolds`: of the tip radius and the air speed at 75 % of it.
  LaneRotor(const BladeElementRotor& rotor, double leastReynolds, double mostReynolds);

  /// As BladeElementRotor::oblique(), the in-plane speed above 0.
  [[nodiscard]] ObliqueLoad oblique(double omega, double axialSpeed, double inPlaneSpeed,
                                    const AirState& air) const;

 private:
  /// What does not change from state to state; lengths over the tip radius.
  struct Block {
    FloatLanes radius, hoverFactor, area;  // solidity/(4 k) over the azimuths; B c dr over them
    std::array<std::size_t, kFloatLanes> annulus;
    std::array<double, kFloatLanes> chord;
  };

  SectionTable table_;
  std::vector<Block> blocks_;
  std::vector<float> azimuths_;
  double radius_;
};

}  // namespace rotorbench
