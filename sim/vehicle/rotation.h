// The rotation matrix of an attitude, over any scalar.
#pragma once

#include <Eigen/Core>

namespace rotorbench::detail {

/// Rotation matrix of a unit quaternion [w x y z], row by row.
template <class S>
struct Rotation {
  S xx, xy, xz, yx, yy, yz, zx, zy, zz;
  Rotation(const S& w, const S& x, const S& y, const S& z) {
    xx = 1.0 - 2.0 * (y * y + z * z), xy = 2.0 * (x * y - w * z), xz = 2.0 * (x * z + w * y);
    yx = 2.0 * (x * y + w * z), yy = 1.0 - 2.0 * (x * x + z * z), yz = 2.0 * (y * z - w * x);
    zx = 2.0 * (x * z - w * y), zy = 2.0 * (y * z + w * x), zz = 1.0 - 2.0 * (x * x + y * y);
  }

  /// Components in body axes of a vector given in inertial ones.
  [[nodiscard]] Eigen::Matrix<S, 3, 1> intoBody(const S& vx, const S& vy, const S& vz) const {
    Eigen::Matrix<S, 3, 1> v;
    v[0] = xx * vx + yx * vy + zx * vz;
    v[1] = xy * vx + yy * vy + zy * vz;
    v[2] = xz * vx + yz * vy + zz * vz;
    return v;
  }
};

}  // namespace rotorbench::detail
