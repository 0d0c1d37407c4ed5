#pragma once

#include "edp/rig.hpp"

namespace mrroc::edp {

inline constexpr int kTerminal = 3;  ///< input of the emergency stop, closed while it is not pressed

/// Like Slide, with limits that a moving robot reaches within a test.
class WatchedSlide : public Slide {
 public:
  WatchedSlide() { parameters_.axes[0].current_max_time = 0.1; }
};
using SafeRig = Rig<WatchedSlide>;

inline RobotCommand recover_command() {
  RobotCommand command;
  command.kind = CommandKind::recover;
  return command;
}

inline RobotCommand by(double way, std::uint16_t steps = 500) {
  RobotCommand command = joint_command(one(way), steps, steps);
  command.relative = true;
  return command;
}

/// Recovers; returns the code of the answer.
inline ErrorCode recover(SafeRig& rig) {
  rig.replies.clear();
  EXPECT_FALSE(rig.send(recover_command()));
  rig.run(3);
  EXPECT_EQ(rig.replies.size(), 1u);
  return rig.replies.empty() ? ErrorCode::busy : rig.replies[0].state.error.code;
}

}  // namespace mrroc::edp
