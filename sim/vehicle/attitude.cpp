#include "sim/vehicle/attitude.h"

#include <algorithm>
#include <cmath>

namespace rotorbench {

Eigen::Vector3d eulerAngles(const Eigen::Vector4d& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double sine = std::clamp(2 * (w * y - z * x), -1.0, 1.0);
  return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
          std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
}

Eigen::Vector4d quaternionOf(const Eigen::Vector3d& a) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(a.z(), Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(a.y(), Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(a.x(), Eigen::Vector3d::UnitX());
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace rotorbench
