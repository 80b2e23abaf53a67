// Four functions of three coordinates on a uniform grid, solved only where interpolation between
// points already solved would not do: first a coarse grid, then one axis after the other is halved.
// Along an axis that is never refined a solution between two others is often spared (settle()).
// A new point is solved if a point nearby differs too much from the cubic through its neighbours,
// and interpolated by that cubic if not. A cubic's error falls 16-fold with half the spacing where
// the functions are smooth, and still about 4-fold at the kinks of a stall.
//   after H.-J. Bungartz, M. Griebel, Sparse grids, Acta Numerica 13, 2004 (hierarchical surplus)
// Coordinates run from 0 to 1 along every axis; the values have whatever units the functions have.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace rotorbench {

inline constexpr std::size_t kGridAxes = 3, kGridValues = 4;
using GridValues = std::array<double, kGridValues>;
using GridPlace = std::array<double, kGridAxes>;

struct GridAxis {
  std::size_t points = 4;  ///< of the coarse grid, at least 4
  int refinements = 0;     ///< how often it may be halved
  bool even = false;       ///< the functions are mirrored about 0
};

class RefinedGrid {
 public:
  using Solve = std::function<GridValues(const GridPlace&)>;
  using Index = std::array<std::size_t, kGridAxes>;

  /// `tolerance`: allowed error of interpolation, above 0. `solve` is called from several threads
  /// at once; what comes out does not depend on how many there are.
  RefinedGrid(const std::array<GridAxis, kGridAxes>& axes, const GridValues& tolerance,
              const Solve& solve);

  [[nodiscard]] const Index& points() const { return points_; }
  [[nodiscard]] const std::array<GridAxis, kGridAxes>& axes() const { return axes_; }
  [[nodiscard]] GridValues& at(const Index& i) { return values_[offset(i)]; }
  [[nodiscard]] const GridValues& at(const Index& i) const { return values_[offset(i)]; }
  [[nodiscard]] GridPlace place(const Index& i) const;
  /// The value at a point that may lie up to three points beyond an end of one axis, which is
  /// given: mirrored or on a parabola through the last three points.
  [[nodiscard]] GridValues along(Index i, std::size_t axis, long k) const;
  /// How often `solve` was called.
  [[nodiscard]] std::size_t solved() const { return solved_; }

 private:
  [[nodiscard]] std::size_t offset(const Index& i) const {
    return (i[2] * points_[1] + i[1]) * points_[0] + i[0];
  }
  [[nodiscard]] Index indexOf(std::size_t offset) const;
  [[nodiscard]] GridValues midway(const Index& i, std::size_t axis) const;
  [[nodiscard]] std::vector<float> surplus(std::size_t axis, const GridValues& tolerance) const;
  void spread(std::vector<float>& field, std::size_t axis) const;
  void settle(const std::vector<Index>& open, const GridValues& tolerance, const Solve& solve);
  void refine(std::size_t axis, const GridValues& tolerance, const Solve& solve);

  std::array<GridAxis, kGridAxes> axes_;
  Index points_{};
  std::vector<GridValues> values_;
  std::size_t solved_ = 0;
};

}  // namespace rotorbench
