#include "mrroc/generators/guarded_motion.hpp"

#include <algorithm>

#include "core/require.hpp"
#include "language/conditions/guard.hpp"
#include "language/force/force_step.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

GuardedMotion::GuardedMotion(Robot& robot, const Eigen::Vector3d& velocity, double contact_force, double acceleration)
    : Generator("GuardedMotion"),
      robot_(&robot),
      velocity_(velocity),
      contact_force_(contact_force),
      acceleration_(acceleration) {
  require_above_zero("GuardedMotion", "speed", velocity.norm());
  require_above_zero("GuardedMotion", "contact force", contact_force);
  require_above_zero("GuardedMotion", "acceleration", acceleration);
}

void GuardedMotion::start() {
  touched_.reset();
  resume();
}

void GuardedMotion::resume() { commanded_.setZero(); }

bool GuardedMotion::terminal_condition() {
  const RobotState& state = robot_->state();
  if (!touched_ && -state.wrench.head<3>().dot(velocity_.normalized()) >= contact_force_) touched_ = state.pose;
  return touched_.has_value();
}

void GuardedMotion::next_state() {
  const Eigen::Vector3d velocity = robot_->task().operator_speed() * velocity_;
  commanded_ = stepped(commanded_, velocity, acceleration_ * robot_->step_duration());
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  command.twist.head<3>() = commanded_;
  // while it slows down, the guard is that of the present velocity
  guard(command.force, std::max(1.0, commanded_.norm() / velocity.norm()) * velocity, contact_force_);
}

}  // namespace mrroc
