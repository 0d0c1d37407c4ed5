#pragma once

#include "mrroc/types.hpp"

/// Rigid motions of frames. Any thread; never allocates or throws.
namespace mrroc {

/// Whether the pose is a rigid motion: all values finite, R^T R = I within 1e-6, right-handed.
bool is_rigid(const Pose& pose) noexcept;

/// The frame at `position` (m), turned by `turns` (rad): roll, pitch, yaw about the fixed axes x, y, z in this order,
/// R = Rz(yaw) Ry(pitch) Rx(roll), as in URDF.
Pose frame_at(const Eigen::Vector3d& position, const Eigen::Vector3d& turns) noexcept;

/// The same twist of the same point in axes turned by `rotation`: (R v, R w).
Twist turned(const Eigen::Matrix3d& rotation, const Twist& twist) noexcept;

}  // namespace mrroc
