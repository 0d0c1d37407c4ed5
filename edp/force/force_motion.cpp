#include "edp/force/force_motion.hpp"

#include <algorithm>
#include <cmath>

#include "edp/force/damped_inverse.hpp"
#include "edp/force/force_law.hpp"
#include "edp/motion/velocity_follower.hpp"
#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

namespace {

constexpr double kNothingLost = 1e-9;

double lost_part(const Twist& wanted, const Twist& followed) noexcept {
  const double part = speed_of(wanted - followed) / speed_of(wanted);
  return part > kNothingLost ? std::min(1.0, part) : 0;  // 0 also where nothing is wanted
}

}  // namespace

void ForceMotion::use(const RobotModel& model) noexcept {
  model_ = &model;
  limits_.use(model);
}

void ForceMotion::start(const DesiredState& from, const Pose& tool) noexcept {
  limits_.begin(from);
  lost_ = lost_for_ = 0;
  previous_ = wanted_ = ToolKinematics(*model_, tool).jacobian(from.position) * from.velocity;
}

ErrorReport ForceMotion::step(const ForceTarget& target, const Wrench& measured, const Pose& mount, double dt,
                              DesiredState& desired) noexcept {
  const ToolKinematics kinematics(*model_, target.tool);
  const Eigen::Matrix3d rotation = kinematics.direct(desired.position).linear();
  const Wrench wrench = seen_from(mount.inverse() * target.tool, measured);
  const auto law = [&](const Twist& before) {
    return rotate_twist(
        rotation, follow_force(target.law, target.velocity, wrench, rotate_twist(rotation.transpose(), before), dt));
  };
  const Twist twist = law(previous_);
  wanted_ = law(wanted_);
  auto [velocity, damped, near] = damped_joint_velocity(kinematics, desired.position, twist);
  double share = 1;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) {
    const double limit = kFraction * model_->parameters().axes[static_cast<std::size_t>(i)].velocity_max;
    share = std::min(share, limit / std::max(std::abs(velocity[i]), limit));
  }
  velocity *= share;
  lost_ = near ? lost_part(wanted_, kinematics.jacobian(desired.position) * velocity) : 0;
  lost_for_ = damped && lost_ > kLostMost && speed_of(wanted_) > kLostLeast ? lost_for_ + dt : 0;
  if (lost_for_ > kLostTime) return too_much_lost();
  const DesiredState next = follow_velocity(model_->parameters(), desired, velocity, dt);
  if (const ErrorReport report = limits_.check_next(next); report.error_class != ErrorClass::none) return report;
  previous_ = share * twist;
  desired = next;
  return {};
}

/// The robot brakes from here, so nothing is lost any more.
ErrorReport ForceMotion::too_much_lost() noexcept {
  const double lost = lost_;
  lost_ = lost_for_ = 0;
  return make_report(ErrorClass::non_fatal, ErrorCode::singular,
                     "force motion: %.2f of a twist of %.3g m/s is lost for more than %.2f s, allowed %.2f", lost,
                     speed_of(wanted_), kLostTime, kLostMost);
}

}  // namespace mrroc::edp
