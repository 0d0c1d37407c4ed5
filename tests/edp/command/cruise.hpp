#pragma once

#include <gtest/gtest.h>

#include "edp/rig.hpp"

/// A slide in motion at constant velocity, for tests of the effector.
namespace mrroc::edp {

/// `steps` of motion at 0.5 rad/s, ending in motion.
inline RobotCommand cruise(double to, std::uint16_t steps, std::uint16_t reply_step) {
  RobotCommand command = joint_command(one(to), steps, reply_step);
  command.joint_velocity = one(0.5);
  command.joint_acceleration = one(0);
  return command;
}

/// Runs up to 0.5 rad/s; the macrostep (reply at v = 198) ends at tick 200 at 0.4 rad.
inline void run_up(Rig<Slide>& rig) {
  ASSERT_FALSE(rig.send(cruise(0.4, 200, 198)));
  rig.run(198);
  ASSERT_EQ(rig.replies.size(), 1u);
  rig.replies.clear();
}

}  // namespace mrroc::edp
