#pragma once

#include "mrroc/force_law.hpp"

namespace mrroc::edp {

/// The target of a force macrostep.
struct ForceTarget {
  ForceLaw law;
  Twist velocity = Twist::Zero();  ///< in tool axes
  Pose tool = Pose::Identity();    ///< in the flange frame
};

}  // namespace mrroc::edp
