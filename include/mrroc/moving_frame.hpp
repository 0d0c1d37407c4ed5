#pragma once

#include "mrroc/types.hpp"

namespace mrroc {

/// A moving frame as a sensor measures it: in the robot's base frame, at a tick.
struct MovingFrame {
  Pose pose = Pose::Identity();
  Twist twist = Twist::Zero();  ///< of its origin, in base axes: m/s, rad/s
  Tick tick = 0;                ///< of pose and twist

  /// The frame `seconds` later (or earlier) at constant twist: p + v t, exp(w t) R. The tick is unchanged.
  MovingFrame after(double seconds) const noexcept;
};

/// A sliding frame: `at_zero` moved along `direction` (base axes, of length 1) by `travel` m, at `speed` m/s. For a
/// conveyor's belt that a ConveyorEncoder measures:
///   sliding_frame(part, {0, 1, 0}, encoder.position(), encoder.velocity(), encoder.reading().tick)
MovingFrame sliding_frame(const Pose& at_zero, const Eigen::Vector3d& direction, double travel, double speed,
                          Tick tick) noexcept;

}  // namespace mrroc
