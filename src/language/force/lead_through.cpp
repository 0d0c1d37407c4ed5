#include "mrroc/generators/lead_through.hpp"

#include <algorithm>

#include "core/require.hpp"
#include "language/force/force_step.hpp"

namespace mrroc {

namespace {

/// Of three axes with the same compliance.
struct Compliance {
  Eigen::Vector3d ignored;  ///< the part of the force below the threshold
  double damping;           ///< D'
};

Compliance compliance(const Eigen::Vector3d& force, double damping, double speed, double threshold) {
  const double size = force.norm();
  if (!(size > threshold)) return {force, damping};
  return {force * (threshold / size), std::max(damping, (size - threshold) / speed)};
}

}  // namespace

LeadThrough::LeadThrough(Robot& robot, const Guidance& guidance)
    : Generator("LeadThrough"), robot_(&robot), guidance_(guidance) {
  require_above_zero("LeadThrough", "damping", guidance.damping);
  require_above_zero("LeadThrough", "angular damping", guidance.angular_damping);
  require_above_zero("LeadThrough", "speed", guidance.speed);
  require_above_zero("LeadThrough", "angular speed", guidance.angular_speed);
  require_not_negative("LeadThrough", "mass", guidance.mass);
  require_not_negative("LeadThrough", "inertia", guidance.inertia);
  require_not_negative("LeadThrough", "force threshold", guidance.force_threshold);
  require_not_negative("LeadThrough", "torque threshold", guidance.torque_threshold);
  check_load("LeadThrough", guidance.load, guidance.gravity);
  const auto free = std::count(guidance.free.begin(), guidance.free.end(), true);
  require(free > 0, "LeadThrough", "free axes", 0, "at least one");
}

void LeadThrough::next_state() {
  const RobotState& state = robot_->state();
  const Wrench weight = weight_of(guidance_.load, state.pose.linear(), guidance_.gravity);
  Wrench hand = state.wrench - weight;
  for (std::size_t i = 0; i < 6; ++i)
    if (!guidance_.free[i]) hand[static_cast<Eigen::Index>(i)] = 0;
  const Compliance linear = compliance(hand.head<3>(), guidance_.damping, guidance_.speed, guidance_.force_threshold);
  const Compliance angular =
      compliance(hand.tail<3>(), guidance_.angular_damping, guidance_.angular_speed, guidance_.torque_threshold);
  Wrench ignored = weight;
  ignored.head<3>() += linear.ignored;
  ignored.tail<3>() += angular.ignored;

  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  for (int i = 0; i < 6; ++i)
    if (guidance_.free[static_cast<std::size_t>(i)]) command.force.contact(i, ignored[i]);
  command.force.inertia << Eigen::Vector3d::Constant(guidance_.mass), Eigen::Vector3d::Constant(guidance_.inertia);
  command.force.admittance << Eigen::Vector3d::Constant(1 / linear.damping),
      Eigen::Vector3d::Constant(1 / angular.damping);
}

}  // namespace mrroc
