#include "mrroc/robots/posture_motion.hpp"

#include <algorithm>
#include <vector>

#include "geometry/least_norm.hpp"
#include "language/joints/joint_spline.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/joints/nearest_posture.hpp"
#include "language/paths/tool_path.hpp"

namespace mrroc {

namespace {

constexpr double kStep = 0.05;  // rad or m of the fastest joint, between two waypoints
constexpr double kEnd = 1e-3;   // rad or m: no joint has a longer way to go
constexpr int kSteps = 1000;

JointVector descent(const RobotModel& model, const JointVector& joints, const JointVector& wished) {
  const Jacobian jacobian = model.jacobian(joints, Eigen::Vector3d::Zero());
  const JointVector way = wished - joints;
  const Twist moved = jacobian * way;
  return way - least_norm_solution(jacobian, moved);
}

}  // namespace

PostureMotion::PostureMotion(Robot& robot, const JointVector& wished, double speed)
    : PathGenerator(robot, "PostureMotion"), wished_(wished), speed_(speed) {
  check_speed(speed);
  check_joints(robot, wished, "the wished posture");
}

std::unique_ptr<RobotPath> PostureMotion::path_from(const JointVector& joints) {
  const RobotModel& model = robot().kinematics().model();
  const Pose flange = model.flange(joints);
  std::vector<JointVector> waypoints{joints};
  for (int i = 0; i < kSteps; ++i) {
    const JointVector step = descent(model, waypoints.back(), wished_);
    const double longest = step.cwiseAbs().maxCoeff();
    if (!(longest > kEnd)) break;
    const JointVector near = waypoints.back() + step * std::min(1.0, kStep / longest);
    JointVector next;
    if (model.inverse(flange, near, next) != ErrorCode::none || !within_limits(model, next)) break;
    if ((next - wished_).squaredNorm() >= (waypoints.back() - wished_).squaredNorm()) break;
    waypoints.push_back(next);
  }
  if (waypoints.size() == 1) return nullptr;
  return std::make_unique<JointSpline>(robot().parameters(), waypoints, speed_, robot().step_duration());
}

}  // namespace mrroc
