#include "bench/kinematics/postures.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::bench {
namespace {

bool within_motor_limits(const RobotModel& model, const JointVector& joints) {
  JointVector motors;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return false;
  Eigen::Index i = 0;
  for (const AxisParameters& axis : model.parameters().axes) {
    const double motor = motors[i++];
    if (motor < axis.motor_min || motor > axis.motor_max) return false;
  }
  return true;
}

}  // namespace

JointVector Postures::draw_joints() {
  JointVector joints(kinematics_.model().joint_count());
  Eigen::Index i = 0;
  for (const AxisParameters& axis : kinematics_.model().parameters().axes) {
    const double low = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
    const double high = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
    joints[i++] = std::uniform_real_distribution<double>(low, high)(random_);
  }
  return joints;
}

Posture Postures::next() {
  Posture posture;
  do posture.joints = draw_joints();
  while (!within_motor_limits(kinematics_.model(), posture.joints));
  posture.pose = kinematics_.direct(posture.joints);
  posture.near = posture.joints;
  for (double& joint : posture.near) joint += std::bernoulli_distribution()(random_) ? off_ : -off_;
  return posture;
}

}  // namespace mrroc::bench
