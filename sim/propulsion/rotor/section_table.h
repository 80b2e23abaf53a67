// What the annuli of a propeller do against the direction of the flow, in single precision: lift
// over tip loss, which decides the induced velocity, and thrust and torque. Made once for whoever
// solves thousands of states (lane_rotor.h): a section then costs a division and a few reads
// instead of an arc tangent, an arc cosine and four exponentials. The direction is the diamond
// angle s of the axial and the tangential speed, from -2 to 2, which needs no trigonometry:
//   s = a/(|a| + |t|) where t >= 0, +-2 - a/(|a| + |t|) where t < 0
// Linear in s for the induced velocity, cubic for the loads; linear in ln Re for both.
#pragma once

#include <vector>

#include "sim/propulsion/rotor/blade_element.h"

namespace rotorbench {

class SectionTable {
 public:
  static constexpr int kCells = 512;  ///< of the whole circle

  /// `leastReynolds` to `mostReynolds`: of the tip radius and the air speed at 75 % of it.
  SectionTable(const BladeElementRotor& rotor, double leastReynolds, double mostReynolds);

  /// Rows of two neighbouring Reynolds numbers and the weight of the second.
  struct Place {
    std::size_t row;
    float weight;
  };
  /// `logReynolds` of the annulus' own chord and speed.
  [[nodiscard]] Place at(std::size_t annulus, double logReynolds) const;

  /// Lift times cos(phi) over the tip loss, in pairs of the row and the next one, from cell 0 on.
  [[nodiscard]] const float* lift(std::size_t row) const { return &lift_[2 * row * kStride]; }
  /// Thrust and torque coefficients of the row, then of the next one. One cell more than asked for
  /// lies on either side.
  [[nodiscard]] const float* loads(std::size_t row) const {
    return &loads_[4 * (row * kStride + 1)];
  }
  /// Tangent of the inflow angle at which there is no lift.
  [[nodiscard]] float freeSlope(std::size_t row) const { return freeSlope_[row]; }

 private:
  static constexpr std::size_t kStride = kCells + 8;  // no power of two: rows share no cache lines

  std::vector<float> lift_, loads_, freeSlope_;
  std::vector<double> least_;  // ln Re of every annulus' first row
  std::size_t rows_ = 0;       // of one annulus
};

}  // namespace rotorbench
