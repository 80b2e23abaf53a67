#include "sim/numerics/cubic_table.h"

#include <cstdint>
#include <istream>
#include <ostream>

namespace rotorbench {

CubicTable::CubicTable(const RefinedGrid& grid) {
  std::array<long, kGridAxes> points{};
  for (std::size_t axis = 0; axis < kGridAxes; ++axis) {
    points[axis] = static_cast<long>(grid.points()[axis]);
    stride_[axis] = grid.points()[axis] + 2;
    last_[axis] = static_cast<double>(points[axis] - 1);
  }
  values_.resize(stride_[0] * stride_[1] * stride_[2] * kGridValues);
  const auto place = [&](long a, long b, long c) {
    return offset(static_cast<std::size_t>(a + 1), static_cast<std::size_t>(b + 1),
                  static_cast<std::size_t>(c + 1));
  };
  for (long c = 0; c < points[2]; ++c) {
    for (long b = 0; b < points[1]; ++b) {
      for (long a = -1; a <= points[0]; ++a) {
        const GridValues v =
            grid.along({0, static_cast<std::size_t>(b), static_cast<std::size_t>(c)}, 0, a);
        for (std::size_t q = 0; q < kGridValues; ++q)
          values_[place(a, b, c) + q] = static_cast<float>(v[q]);
      }
    }
  }
  // Beyond the ends of the other two axes, margins of the first included: mirrored, or on a
  // parabola.
  const auto margin = [&](std::size_t axis, std::size_t to, std::ptrdiff_t inwards) {
    const bool mirrored = inwards > 0 && grid.axes()[axis].even;
    const float* from = &values_[to];
    for (std::size_t q = 0; q < kGridValues; ++q, ++from) {
      values_[to + q] = mirrored ? from[2 * inwards]
                                 : 3 * from[inwards] - 3 * from[2 * inwards] + from[3 * inwards];
    }
  };
  const auto row = static_cast<std::ptrdiff_t>(stride_[0] * kGridValues),
             slab = row * static_cast<std::ptrdiff_t>(stride_[1]);
  for (long c = 0; c < points[2]; ++c) {
    for (long a = -1; a <= points[0]; ++a) {
      margin(1, place(a, -1, c), row);
      margin(1, place(a, points[1], c), -row);
    }
  }
  for (long b = -1; b <= points[1]; ++b) {
    for (long a = -1; a <= points[0]; ++a) {
      margin(2, place(a, b, -1), slab);
      margin(2, place(a, b, points[2]), -slab);
    }
  }
}

void CubicTable::write(std::ostream& out) const {
  for (const std::uint64_t stride : stride_)
    out.write(reinterpret_cast<const char*>(&stride), sizeof stride);
  out.write(reinterpret_cast<const char*>(values_.data()),
            static_cast<std::streamsize>(values_.size() * sizeof(float)));
}

bool CubicTable::read(std::istream& in) {
  // No table is larger: a number that says so was never one.
  constexpr std::uint64_t kMost = 1 << 20;
  std::uint64_t count = kGridValues;
  for (std::size_t axis = 0; axis < kGridAxes; ++axis) {
    std::uint64_t stride = 0;
    in.read(reinterpret_cast<char*>(&stride), sizeof stride);
    if (!in || stride < 4 || stride > kMost || count > (std::uint64_t{1} << 40) / stride)
      return false;
    stride_[axis] = stride;
    last_[axis] = static_cast<double>(stride - 3);
    count *= stride;
  }
  const std::istream::pos_type here = in.tellg();
  const std::istream::pos_type end = in.seekg(0, std::ios::end).tellg();
  if (!in || static_cast<std::uint64_t>(end - here) != count * sizeof(float)) return false;
  in.seekg(here);
  values_.resize(count);
  in.read(reinterpret_cast<char*>(values_.data()),
          static_cast<std::streamsize>(count * sizeof(float)));
  return static_cast<bool>(in);
}

}  // namespace rotorbench
