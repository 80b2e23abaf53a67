// Roll, pitch and yaw (turned in the order yaw, pitch, roll: Z-Y-X) and unit quaternions [w x y z],
// both from body axes to inertial ones. Angles in rad.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rotorbench {

/// Roll, pitch, yaw of a unit quaternion; yaw in (-pi, pi].
Eigen::Vector3d eulerAngles(const Eigen::Vector4d& wxyz);
/// The unit quaternion of roll, pitch, yaw.
Eigen::Vector4d quaternionOf(const Eigen::Vector3d& rollPitchYaw);

}  // namespace rotorbench
