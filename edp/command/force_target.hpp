#pragma once

#include "mrroc/force_law.hpp"

namespace mrroc::edp {

/// What a force macrostep follows.
struct ForceTarget {
  ForceLaw law;
  Twist velocity = Twist::Zero();  ///< in tool axes
  Pose tool = Pose::Identity();    ///< in the flange frame
};

}  // namespace mrroc::edp
