#pragma once

#include "mrroc/robot_command.hpp"

namespace mrroc::edp {

/// What an order of the operator asks for (OperatorMotion). Any thread.

/// A velocity, which holds for a short time: the operator repeats it.
inline bool is_jog(const RobotCommand& command) noexcept {
  return command.kind == CommandKind::joint_velocity || command.kind == CommandKind::twist ||
         (command.kind == CommandKind::motor && command.joints.size() == 0);
}

/// A goal.
inline bool is_travel(const RobotCommand& command) noexcept {
  return !is_jog(command) && (command.kind == CommandKind::joint || command.kind == CommandKind::motor ||
                              command.kind == CommandKind::pose);
}

}  // namespace mrroc::edp
