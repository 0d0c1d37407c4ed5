#include "mrroc/generators/joint_path.hpp"

#include "language/joints/joint_spline.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/joints/motor_range.hpp"
#include "language/paths/tool_path.hpp"

namespace mrroc {

namespace {

constexpr const char* kName = "JointPath";
constexpr int kLooks = 32;  // checks of the motors, from waypoint to waypoint on average

void require_waypoints(bool there) {
  if (!there) throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + " without a waypoint");
}

/// "waypoint 2", counted from 1.
std::string waypoint_text(std::size_t i) { return std::string{"waypoint "} + std::to_string(i + 1); }

std::string after_text(double part) {
  return std::string{"the path after "} + std::to_string(static_cast<int>(100 * part)) + " %:";
}

}  // namespace

JointPath::JointPath(Robot& robot, std::vector<JointVector> waypoints, double speed)
    : PathGenerator(robot, kName), waypoints_(std::move(waypoints)), speed_(speed) {
  check_speed(speed);
  require_waypoints(!waypoints_.empty());
  for (std::size_t i = 0; i < waypoints_.size(); ++i) check_joints(robot, waypoints_[i], waypoint_text(i));
}

JointPath::JointPath(Robot& robot, const std::vector<Pose>& waypoints, double speed)
    : PathGenerator(robot, kName), speed_(speed) {
  check_speed(speed);
  require_waypoints(!waypoints.empty());
  for (const Pose& pose : waypoints) poses_.push_back(checked_pose(pose, kName));
}

std::unique_ptr<RobotPath> JointPath::path_from(const JointVector& joints) {
  std::vector<JointVector> all{joints};
  all.insert(all.end(), waypoints_.begin(), waypoints_.end());
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    all.push_back(posture_of(robot(), poses_[i], all.back(), waypoint_text(i)).joints);
  }
  auto path = std::make_unique<JointSpline>(robot().parameters(), all, speed_, robot().step_duration());
  const int looks = kLooks * static_cast<int>(all.size() - 1);
  for (int k = 0; k <= looks; ++k)
    check_motors(robot(), path->joints(path->length() * k / looks), after_text(static_cast<double>(k) / looks));
  return path;
}

}  // namespace mrroc
