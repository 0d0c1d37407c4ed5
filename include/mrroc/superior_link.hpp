#pragma once

#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc {

/// The connection of a `Superior` to the MP's Moves: an ECP's link, a test's fake. Every command that `take` returns is
/// answered with one `reply`. Called by the task's thread only.
class SuperiorLink {
 public:
  virtual ~SuperiorLink() = default;
  /// From now on, until `leave`, the MP's commands are for `take`.
  virtual void join() = 0;
  virtual void leave() noexcept = 0;
  /// The MP's next command; false when it has sent nothing. Does not wait.
  virtual bool take(RobotCommand& command) = 0;
  /// Answers the command taken last.
  virtual void reply(const RobotState& state) = 0;
  /// Waits until something has arrived, from the MP or from another process. Throws Stopped.
  virtual void wait() = 0;
};

}  // namespace mrroc
