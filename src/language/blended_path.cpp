#include "mrroc/generators/blended_path.hpp"

#include <algorithm>
#include <cmath>

#include "language/rigid_motion.hpp"
#include "language/tool_path.hpp"

namespace mrroc {

namespace {

constexpr const char* kName = "BlendedPath";

/// A line between two corners, and how much of it its blends take, as times at full speed.
struct Line {
  Pose from, to;
  double length = 0;
  PathPose at(double s) const {
    PathPose there = line_between(from, to, length).from;
    if (s >= length) {
      there.pose = to;
      return there;
    }
    there.pose.translation() += s * there.first.head<3>();
    there.pose.linear() = rotation_of(s * there.first.tail<3>()) * from.linear();
    return there;
  }
  /// The part of it that lies within `radius` of one of its ends, at most a half.
  double within(double radius) const {
    const double way = (to.translation() - from.translation()).norm();
    return length * (radius < 0.5 * way ? radius / way : 0.5);
  }
};

}  // namespace

BlendedPath::BlendedPath(Robot& robot, std::vector<BlendPoint> points, const PathLimits& limits)
    : PathGenerator(robot, kName), points_(std::move(points)), limits_(limits) {
  check_limits(limits, kName);
  if (points_.empty()) throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + " without a point");
  for (BlendPoint& point : points_) {
    point.pose = checked_pose(point.pose, kName);
    if (!(point.radius >= 0) || !std::isfinite(point.radius))
      throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + ": radius " + std::to_string(point.radius) +
                                                           ", expected a finite number of at least 0");
  }
}

std::unique_ptr<RobotPath> BlendedPath::path_from(const JointVector& joints) {
  std::vector<Line> lines;
  std::vector<double> radii;  // at the lines' ends
  Pose last = robot().kinematics().direct(joints);
  for (const BlendPoint& point : points_) {
    const double length = full_speed_time(last, point.pose, limits_.speed, limits_.angular_speed);
    if (length < ToolPath::kShortest) continue;
    lines.push_back({last, point.pose, length});
    radii.push_back(point.radius);
    last = point.pose;
  }
  if (lines.empty()) return nullptr;
  ToolPath::Plan plan;
  auto path = std::make_unique<PiecedPath>();
  plan.stops.push_back(0);
  double begin = 0;  // of the line that is left, behind the blend before it
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool last_one = i + 1 == lines.size();
    const bool blends = !last_one && radii[i] > 0;
    const double blend = blends ? std::min(lines[i].within(radii[i]), lines[i + 1].within(radii[i])) : 0;
    const double end = lines[i].length - blend;
    if (end - begin > ToolPath::kShortest) path->add(lines[i].at(begin), lines[i].at(end), end - begin);
    if (blends) {
      path->add(lines[i].at(end), lines[i + 1].at(blend), 2 * blend);
    } else {
      plan.stops.push_back(path->breaks().back());
    }
    begin = blend;
  }
  plan.waypoints = plan.stops;
  plan.limits = limits_;
  plan.path = std::move(path);
  return std::make_unique<ToolPath>(robot(), joints, std::move(plan));
}

}  // namespace mrroc
