#include "mrroc/robots/two_finger_gripper.hpp"

#include <limits>

#include "mrroc/task.hpp"
#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

namespace mrroc {

namespace {

constexpr double kHeldOpen = 0.0005;  // m; free fingers follow within 0.05 mm

}  // namespace

TwoFingerGripper::TwoFingerGripper(Task& task, const std::string& name)
    : Robot(task, name, "two_finger_gripper", load_two_finger_gripper) {}

JointVector TwoFingerGripper::at(double opening) { return JointVector::Constant(1, opening); }

Pose TwoFingerGripper::grip_centre() const { return kinematics().model().flange(at(0)); }

double TwoFingerGripper::held_open() const {
  const RobotState& e = state();
  if (e.joints.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  const double ahead = static_cast<double>(e.desired_tick - e.tick) * task().servo_period();
  return e.joints[0] + e.joint_velocity[0] * ahead - e.desired_joints[0];
}

Gripped::Gripped(const TwoFingerGripper& gripper) : Condition(gripper.name() + " gripped"), gripper_(&gripper) {}

bool Gripped::holds() { return gripper_->held_open() > kHeldOpen; }

}  // namespace mrroc
