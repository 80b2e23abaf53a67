// Four functions of three coordinates, read between the points of a uniform grid by Catmull-Rom
// cubics: once differentiable, over any scalar. Held in single precision, which is far finer than
// any grid.
#pragma once

#include <cmath>
#include <iosfwd>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/numerics/refined_grid.h"

namespace rotorbench {

/// Weights of the four points around an interval, at the fraction t of it (Catmull, Rom, 1974).
template <class S>
void catmullRom(const S& t, S (&weight)[4]) {
  const S s = 1.0 - t;
  weight[0] = -0.5 * t * s * s;
  weight[1] = 1.0 + t * t * (1.5 * t - 2.5);
  weight[2] = 1.0 + s * s * (1.5 * s - 2.5);
  weight[3] = -0.5 * s * t * t;
}

/// Interval of a coordinate in units of the grid, 0 to `last`, and the fraction in it: the nearest
/// end holds outside. NaN is taken as 0.
template <class S>
std::size_t gridInterval(const S& coordinate, double last, S& fraction) {
  const double inside = std::fmin(std::fmax(valueOf(coordinate), 0), last);
  const double interval = std::fmin(std::floor(inside), last - 1);
  fraction = S(coordinate - interval);
  if (!(valueOf(coordinate) == inside)) fraction = S(inside - interval);
  return static_cast<std::size_t>(interval);
}

class CubicTable {
 public:
  CubicTable() = default;
  explicit CubicTable(const RefinedGrid& grid);

  /// The table as bytes of this machine. read() returns whether there was one.
  void write(std::ostream& out) const;
  bool read(std::istream& in);

  /// Values at coordinates from 0 to 1; the nearest end holds outside. No heap, no exception.
  template <class S>
  void at(const S& x, const S& y, const S& z, S (&values)[kGridValues]) const {
    S fraction, weight[kGridAxes][4];
    const S* coordinates[kGridAxes] = {&x, &y, &z};
    std::size_t first[kGridAxes];
    for (std::size_t axis = 0; axis < kGridAxes; ++axis) {
      first[axis] = gridInterval(S(*coordinates[axis] * last_[axis]), last_[axis], fraction);
      catmullRom(fraction, weight[axis]);
    }
    // Sums of their own, or every addition would wait for the last one to reach the memory.
    S sum[kGridValues] = {S(0.0), S(0.0), S(0.0), S(0.0)};
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t b = 0; b < 4; ++b) {
        const float* row = &values_[offset(first[0], first[1] + b, first[2] + c)];
        const S both = weight[2][c] * weight[1][b];
        for (std::size_t q = 0; q < kGridValues; ++q) {
          const auto value = [&](std::size_t a) {
            return static_cast<double>(row[a * kGridValues + q]);
          };
          const S along = weight[0][0] * value(0) + weight[0][1] * value(1) +
                          weight[0][2] * value(2) + weight[0][3] * value(3);
          sum[q] += both * along;
        }
      }
    }
    for (std::size_t q = 0; q < kGridValues; ++q) values[q] = sum[q];
  }

 private:
  [[nodiscard]] std::size_t offset(std::size_t a, std::size_t b, std::size_t c) const {
    return ((c * stride_[1] + b) * stride_[0] + a) * kGridValues;
  }

  std::vector<float> values_;  // one more point than the grid on every side
  std::array<std::size_t, kGridAxes> stride_{};
  std::array<double, kGridAxes> last_{};
};

}  // namespace rotorbench
