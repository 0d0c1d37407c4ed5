#include "mrroc/generators/joint_line.hpp"

#include "language/joints/joint_leg.hpp"
#include "language/joints/joint_targets.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

struct JointLine::Plan {
  JointLeg leg;
  double time = 0;  // of the macrostep commanded last
};

JointLine::JointLine(Robot& robot, const JointVector& target, double speed)
    : Generator("JointLine"), robot_(&robot), to_pose_(false), target_(target), speed_(speed) {
  check_speed(speed);
  check_target(target);
}

JointLine::JointLine(Robot& robot, const Pose& target, double speed)
    : Generator("JointLine"),
      robot_(&robot),
      to_pose_(true),
      target_pose_(rigid_pose(robot, target, "target")),
      speed_(speed) {
  check_speed(speed);
}

JointLine::~JointLine() = default;
JointLine::JointLine(JointLine&&) noexcept = default;
JointLine& JointLine::operator=(JointLine&&) noexcept = default;

void JointLine::check_target(const JointVector& target) const { check_joints(*robot_, target, "target"); }

void JointLine::start() {
  const RobotState& state = robot_->known_state();
  if (to_pose_) {
    const Posture posture = posture_of(*robot_, target_pose_, state.desired_joints, "target");
    target_ = posture.joints;
    deviation_ = posture.deviation;
  }
  plan_ = std::make_unique<Plan>(Plan{JointLeg(*robot_)});
  plan_->leg.plan(target_, speed_);
}

bool JointLine::terminal_condition() { return plan_->leg.over(plan_->time); }

void JointLine::next_state() {
  plan_->time += robot_->step_duration();
  plan_->leg.write(plan_->time, robot_->command());
}

double JointLine::duration() const noexcept { return plan_ ? plan_->leg.duration() : 0; }

}  // namespace mrroc
