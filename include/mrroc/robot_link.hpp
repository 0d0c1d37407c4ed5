#pragma once

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// The connection from a `Robot` to the executor of its commands: an ECP's link to its EDP, an MP's link to an ECP, a
/// test's fake. One exchange is one `send` and one `receive`; at most one is under way. Called by the task's thread
/// only.
class RobotLink {
 public:
  virtual ~RobotLink() = default;
  /// Sends e^{i+1}; does not wait.
  virtual void send(const RobotCommand& command) = 0;
  /// Waits for the reply to the last `send` and stores it. Throws SystemError when the peer died or is silent.
  virtual void receive(RobotState& state) = 0;
};

}  // namespace mrroc
