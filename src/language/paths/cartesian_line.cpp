#include "mrroc/generators/cartesian_line.hpp"

#include "language/paths/tool_path.hpp"

namespace mrroc {

namespace {

constexpr const char* kLineName = "CartesianLine";

}  // namespace

CartesianLine::CartesianLine(Robot& robot, const Pose& target, const PathLimits& limits)
    : PathGenerator(robot, kLineName), target_(checked_pose(target, kLineName)), limits_(limits) {
  check_limits(limits, kLineName);
}

std::unique_ptr<RobotPath> CartesianLine::path_from(const JointVector& joints) {
  const Pose start = robot().kinematics().direct(joints);
  const double length = full_speed_time(start, target_, limits_.speed, limits_.angular_speed);
  if (length < ToolPath::kShortest) return nullptr;
  auto path = std::make_unique<PiecedPath>();
  const LineEnds line = line_between(start, target_, length);
  path->add(line.from, line.to, length);
  return ToolPath::whole(robot(), joints, std::move(path), limits_);
}

}  // namespace mrroc
