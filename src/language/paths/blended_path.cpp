#include "mrroc/generators/blended_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "geometry/near_places.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/paths/tool_path.hpp"

namespace mrroc {

namespace {

constexpr const char* kName = "BlendedPath";
constexpr double kShortShare = 0.5;  // of the radii at its ends: a shorter line is part of one blend
constexpr double kShortTurn = 0.02;  // rad: and the tool rotates by less on it

/// A line between two corners and the parts of it that its blends use, as times at full speed.
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
    there.pose.linear() = exp_rotation(s * there.first.tail<3>()) * from.linear();
    return there;
  }
  /// The part of it that lies within `radius` of one of its ends, at most a half.
  double within(double radius) const {
    const double way = (to.translation() - from.translation()).norm();
    return length * (radius < 0.5 * way ? radius / way : 0.5);
  }
  bool is_short(double radius) const {
    return (to.translation() - from.translation()).norm() < kShortShare * radius &&
           turn_between(from, to).norm() < kShortTurn;
  }
};

/// Whether the line from `a` to `c` passes `b`.
bool is_between(const Pose& a, const Pose& b, const Pose& c) {
  const Eigen::Vector3d way = c.translation() - a.translation(), turn = turn_between(a, c);
  const double square = way.squaredNorm() + turn.squaredNorm();
  if (square == 0) return false;
  const double part = (way.dot(b.translation() - a.translation()) + turn.dot(turn_between(a, b))) / square;
  if (part < 0 || part > 1) return false;
  Pose there = Pose::Identity();
  there.translation() = a.translation() + part * way;
  there.linear() = exp_rotation(part * turn) * a.linear();
  return are_near(there, b);
}

}  // namespace

BlendedPath::BlendedPath(Robot& robot, std::vector<BlendPoint> points, const PathLimits& limits)
    : PathGenerator(robot, kName), points_(std::move(points)), limits_(limits) {
  check_limits(limits, kName);
  if (points_.empty()) throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + " without a point");
  for (BlendPoint& point : points_) {
    point.pose = checked_pose(point.pose, kName);
    require_not_negative(kName, "radius", point.radius);
  }
}

std::vector<BlendPoint> BlendedPath::corners_from(const Pose& start) const {
  std::vector<BlendPoint> corners{{start, 0}};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    BlendPoint corner = points_[i];
    const bool last = i + 1 == points_.size();
    if (corner.radius < kSamePlace || last) corner.radius = 0;
    // of two coincident corners, keep the one that is passed more exactly
    while (corners.size() > 1 && are_near(corners.back().pose, corner.pose) &&
           (last || corner.radius <= corners.back().radius))
      corners.pop_back();
    if (!last && are_near(corners.back().pose, corner.pose)) continue;
    // a small radius on a straight line is not a corner
    const bool small = !last && corner.radius == 0 && points_[i].radius > 0;
    if (small && is_between(corners.back().pose, corner.pose, points_[i + 1].pose)) continue;
    corners.push_back(corner);
  }
  return corners;
}

std::unique_ptr<RobotPath> BlendedPath::path_from(const JointVector& joints) {
  std::vector<Line> lines;
  std::vector<double> radii;  // at the lines' ends
  const std::vector<BlendPoint> corners = corners_from(robot().kinematics().direct(joints));
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double length = full_speed_time(corners[i - 1].pose, corners[i].pose, limits_.speed, limits_.angular_speed);
    if (length < ToolPath::kShortest) continue;
    lines.push_back({corners[i - 1].pose, corners[i].pose, length});
    radii.push_back(corners[i].radius);
  }
  if (lines.empty()) return nullptr;
  ToolPath::Plan plan;
  auto path = std::make_unique<PiecedPath>();
  plan.stops.push_back(0);
  double begin = 0;  // of the remaining line, behind the previous blend
  for (std::size_t i = 0; i < lines.size();) {
    // the blend at the end of line i: to line `next`, over the short ones between them
    std::size_t next = i + 1;
    double radius = radii[i], skipped = 0;
    while (radius > 0 && next + 1 < lines.size() && radii[next] > 0 &&
           lines[next].is_short(std::min(radius, radii[next]))) {
      radius = std::min(radius, radii[next]);
      skipped += lines[next++].length;
    }
    const bool blends = next < lines.size() && radius > 0;
    const double blend = blends ? std::min(lines[i].within(radius), lines[next].within(radius)) : 0;
    const double end = lines[i].length - blend;
    if (end - begin > ToolPath::kShortest) path->add(lines[i].at(begin), lines[i].at(end), end - begin);
    if (blends) {
      path->add(lines[i].at(end), lines[next].at(blend), 2 * blend + skipped);
    } else {
      plan.stops.push_back(path->breaks().back());
    }
    begin = blend;
    i = next;
  }
  plan.waypoints = plan.stops;
  plan.limits = limits_;
  plan.path = std::move(path);
  return std::make_unique<ToolPath>(robot(), joints, std::move(plan));
}

}  // namespace mrroc
