#include "sim/numerics/refined_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/core/parallel.h"

namespace rotorbench {

namespace {

/// The cubic through four points at equal steps, in the middle of them.
GridValues middle(const GridValues& a, const GridValues& b, const GridValues& c,
                  const GridValues& d) {
  GridValues m;
  for (std::size_t q = 0; q < kGridValues; ++q) m[q] = (9 * (b[q] + c[q]) - (a[q] + d[q])) / 16;
  return m;
}

}  // namespace

RefinedGrid::RefinedGrid(const std::array<GridAxis, kGridAxes>& axes, const GridValues& tolerance,
                         const Solve& solve)
    : axes_(axes) {
  std::size_t count = 1;
  int most = 0;
  for (std::size_t axis = 0; axis < kGridAxes; ++axis) {
    points_[axis] = axes[axis].points;
    count *= axes[axis].points;
    most = std::max(most, axes[axis].refinements);
  }
  values_ = inParallel(count, [&](std::size_t k) { return solve(place(indexOf(k))); });
  solved_ = count;
  for (int level = 0; level < most; ++level) {
    for (std::size_t axis = kGridAxes; axis-- > 0;) {
      if (level < axes[axis].refinements) refine(axis, tolerance, solve);
    }
  }
}

RefinedGrid::Index RefinedGrid::indexOf(std::size_t offset) const {
  return {offset % points_[0], offset / points_[0] % points_[1], offset / points_[0] / points_[1]};
}

GridPlace RefinedGrid::place(const Index& i) const {
  GridPlace p;
  for (std::size_t axis = 0; axis < kGridAxes; ++axis)
    p[axis] = static_cast<double>(i[axis]) / static_cast<double>(points_[axis] - 1);
  return p;
}

GridValues RefinedGrid::along(Index i, std::size_t axis, long k) const {
  const auto value = [&](long place) -> const GridValues& {
    i[axis] = static_cast<std::size_t>(place);
    return at(i);
  };
  const long last = static_cast<long>(points_[axis]) - 1;
  if (k >= 0 && k <= last) return value(k);
  if (k < 0 && axes_[axis].even) return value(-k);
  const long end = k < 0 ? 0 : last, inwards = k < 0 ? 1 : -1;
  const auto t = static_cast<double>(k < 0 ? -k : k - last);
  const GridValues a = value(end), b = value(end + inwards), c = value(end + 2 * inwards);
  GridValues beyond;
  for (std::size_t q = 0; q < kGridValues; ++q) {
    beyond[q] = a[q] * (t + 1) * (t + 2) / 2 - b[q] * t * (t + 2) + c[q] * t * (t + 1) / 2;
  }
  return beyond;
}

/// Midway between point i and the next one along the axis.
GridValues RefinedGrid::midway(const Index& i, std::size_t axis) const {
  const long k = static_cast<long>(i[axis]);
  return middle(along(i, axis, k - 1), along(i, axis, k), along(i, axis, k + 1),
                along(i, axis, k + 2));
}

/// How far every point is from the cubic through its neighbours along an axis, in tolerances.
std::vector<float> RefinedGrid::surplus(std::size_t axis, const GridValues& tolerance) const {
  // A cubic that leans on points beyond the end is worse by about this much.
  constexpr double kEndFactor = 4;
  std::vector<float> field(values_.size());
  const long last = static_cast<long>(points_[axis]) - 1;
  for (std::size_t offset = 0; offset < field.size(); ++offset) {
    const Index i = indexOf(offset);
    const long k = static_cast<long>(i[axis]);
    const bool even = axes_[axis].even;
    if (k == last || (k == 0 && !even)) continue;
    const GridValues m = middle(along(i, axis, k - 3), along(i, axis, k - 1), along(i, axis, k + 1),
                                along(i, axis, k + 3));
    double most = 0;
    for (std::size_t q = 0; q < kGridValues; ++q)
      most = std::max(most, std::abs(m[q] - values_[offset][q]) / tolerance[q]);
    const bool atEnd = k + 1 == last || (k == 1 && !even);
    field[offset] = static_cast<float>(atEnd ? kEndFactor * most : most);
  }
  return field;
}

/// Gives every point the most that it or a neighbour along the axis has.
void RefinedGrid::spread(std::vector<float>& field, std::size_t axis) const {
  const std::vector<float> before = field;
  for (std::size_t offset = 0; offset < field.size(); ++offset) {
    Index i = indexOf(offset);
    const std::size_t k = i[axis];
    if (k > 0) {
      i[axis] = k - 1;
      field[offset] = std::max(field[offset], before[this->offset(i)]);
    }
    if (k + 1 < points_[axis]) {
      i[axis] = k + 1;
      field[offset] = std::max(field[offset], before[this->offset(i)]);
    }
  }
}

/// Solves the given points, which hold the cubic's values so far. Along an axis that is never
/// refined only every fourth of them at first: where two neighbours there are off their cubics by
/// the same, to the tolerance, the one between them is so too.
void RefinedGrid::settle(const std::vector<Index>& open, const GridValues& tolerance,
                         const Solve& solve) {
  constexpr std::size_t kFirst = 4;
  std::size_t calm = 0;
  while (calm < kGridAxes && axes_[calm].refinements > 0) ++calm;
  std::vector<GridValues> surpluses(values_.size());
  std::vector<bool> known(values_.size());
  const auto add = [&](const Index& i, const GridValues& surplus) {
    for (std::size_t q = 0; q < kGridValues; ++q) at(i)[q] += surplus[q];
    surpluses[offset(i)] = surplus;
    known[offset(i)] = true;
  };
  const auto solveAll = [&](const std::vector<Index>& points) {
    const auto values =
        inParallel(points.size(), [&](std::size_t k) { return solve(place(points[k])); });
    for (std::size_t k = 0; k < points.size(); ++k) {
      GridValues surplus = values[k];
      for (std::size_t q = 0; q < kGridValues; ++q) surplus[q] -= at(points[k])[q];
      add(points[k], surplus);
    }
    solved_ += points.size();
  };
  if (calm == kGridAxes) return solveAll(open);
  std::vector<Index> now;
  std::ranges::copy_if(open, std::back_inserter(now),
                       [&](const Index& i) { return i[calm] % kFirst == 0; });
  solveAll(now);
  for (std::size_t stride = kFirst / 2; stride > 0; stride /= 2) {
    now.clear();
    for (const Index& i : open) {
      if (i[calm] % (2 * stride) != stride) continue;
      Index before = i, after = i;
      before[calm] -= stride;
      after[calm] += stride;
      const bool inside =
          after[calm] < points_[calm] && known[offset(before)] && known[offset(after)];
      const GridValues &a = surpluses[offset(before)],
                       &b = surpluses[inside ? offset(after) : offset(before)];
      GridValues mean{};
      bool alike = inside;
      for (std::size_t q = 0; q < kGridValues; ++q) {
        mean[q] = (a[q] + b[q]) / 2;
        alike = alike && std::abs(a[q] - b[q]) <= tolerance[q];
      }
      if (alike) {
        add(i, mean);
      } else {
        now.push_back(i);
      }
    }
    solveAll(now);
  }
}

void RefinedGrid::refine(std::size_t axis, const GridValues& tolerance, const Solve& solve) {
  constexpr float kLeastGain = 4;  // of half the spacing, see the header
  std::vector<float> field = surplus(axis, tolerance);
  for (std::size_t neighbour = 0; neighbour < kGridAxes; ++neighbour) {
    if (neighbour == axis || axes_[neighbour].refinements > 0) spread(field, neighbour);
  }
  RefinedGrid finer = *this;
  finer.points_[axis] = 2 * points_[axis] - 1;
  finer.values_.resize(values_.size() / points_[axis] * finer.points_[axis]);
  std::vector<Index> open;
  for (std::size_t k = 0; k < finer.values_.size(); ++k) {
    const Index to = finer.indexOf(k);
    Index from = to;
    from[axis] /= 2;
    if (to[axis] % 2 == 0) {
      finer.values_[k] = at(from);
      continue;
    }
    Index next = from;
    ++next[axis];
    finer.values_[k] = midway(from, axis);
    if (std::max(field[offset(from)], field[offset(next)]) > kLeastGain) open.push_back(to);
  }
  finer.settle(open, tolerance, solve);
  *this = std::move(finer);
}

}  // namespace rotorbench
