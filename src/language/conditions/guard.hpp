#pragma once

#include "mrroc/force_law.hpp"

namespace mrroc {

inline constexpr double kGuardMargin = 2;  ///< settled force per contact force
inline constexpr double kGuardLag = 0.01;  ///< s: b m of a guarded axis

/// Makes those linear axes of `law` guarded that `velocity` (tool axes, not zero) moves along, so that the tool stops
/// on its own when it presses with kGuardMargin times `contact_force`. Allocates nothing, never throws.
inline void guard(ForceLaw& law, const Eigen::Vector3d& velocity, double contact_force) {
  const double damping = velocity.norm() / (kGuardMargin * contact_force);
  for (int i = 0; i < 3; ++i) {
    if (velocity[i] == 0) continue;
    law.guarded(i);
    law.admittance[i] = damping;
    law.inertia[i] = kGuardLag / damping;
  }
}

}  // namespace mrroc
