#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/types.hpp"

namespace mrroc::serial_parallel {

/// The serial part: three axes that cross in one point, R = Rz(turn) Ry(bend) Rz(roll), rad. Any thread; never
/// allocates or throws.
Eigen::Matrix3d wrist_rotation(const Eigen::Vector3d& angles) noexcept;

/// Angles of a rotation. Of the two branches (turn, bend, roll) and (turn + pi, -bend, roll + pi) the one with the
/// smaller sum of changes from `near`, each angle on its revolution nearest to `near`. `none`; `singular` when turn and
/// roll are about one axis (bend is a multiple of pi; turn is kept from `near`).
ErrorCode wrist_angles(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& near, Eigen::Vector3d& angles) noexcept;

}  // namespace mrroc::serial_parallel
