#include "edp/force_motion.hpp"

#include <algorithm>
#include <cmath>

#include "edp/force_law.hpp"
#include "edp/moving_pose.hpp"
#include "edp/velocity_follower.hpp"
#include "language/rigid_motion.hpp"

namespace mrroc::edp {
void ForceMotion::use(const RobotModel& model) noexcept {
  model_ = &model;
  limits_.use(model);
}

void ForceMotion::start(const DesiredState& from, const Pose& tool) noexcept {
  limits_.begin(from);
  previous_ = ToolKinematics(*model_, tool).jacobian(from.position) * from.velocity;
}

ErrorReport ForceMotion::step(const ForceTarget& target, const Wrench& measured, const Pose& mount, double dt,
                              DesiredState& desired) noexcept {
  const ToolKinematics kinematics(*model_, target.tool);
  const Eigen::Matrix3d rotation = kinematics.direct(desired.position).linear();
  const Wrench wrench = seen_from(mount.inverse() * target.tool, measured);
  const Twist twist =
      turned(rotation, follow_force(target.law, target.velocity, wrench, turned(rotation.transpose(), previous_), dt));
  JointVector velocity = joint_velocity_of(kinematics, desired.position, twist);
  double share = 1;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) {
    const double limit = kFraction * model_->parameters().axes[static_cast<std::size_t>(i)].velocity_max;
    share = std::min(share, limit / std::max(std::abs(velocity[i]), limit));
  }
  velocity *= share;
  const DesiredState next = follow_velocity(model_->parameters(), desired, velocity, dt);
  if (const ErrorReport report = limits_.check_next(next); report.error_class != ErrorClass::none) return report;
  previous_ = share * twist;
  desired = next;
  return {};
}

}  // namespace mrroc::edp
