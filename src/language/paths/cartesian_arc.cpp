#include "mrroc/generators/cartesian_arc.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/pose_arc.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/paths/tool_path.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr const char* kArcName = "CartesianArc";
constexpr double kStraight = 1e-6;    // sine of the angle between two chords: they do not define a circle
constexpr double kShortChord = 1e-3;  // of the longest chord: its direction is undefined
constexpr double kLeastChord = 1e-6;  // m, the same

[[noreturn]] void refuse(const char* what) {
  throw NonFatalError(ErrorCode::invalid_argument, std::string{kArcName} + ": " + what);
}

/// The rotation about the axis of the circle through three points, from the first to the last through the second.
Circle circle_through(const Eigen::Vector3d& from, const Eigen::Vector3d& via, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = via - from, b = to - from, normal = a.cross(b);
  const double first_chord = a.norm(), second_chord = (to - via).norm(), whole_chord = b.norm();
  const double least = std::max(kLeastChord, kShortChord * std::max({first_chord, second_chord, whole_chord}));
  if (!(std::min({first_chord, second_chord, whole_chord}) > least))
    refuse(
        "two of start, via and target are too close to define a circle, expected more than a thousandth "
        "of the longest distance between them, and a micrometre");
  if (!(normal.norm() > kStraight * first_chord * whole_chord))
    refuse("start, via and target lie on a line, expected three points on a circle");
  Circle circle;
  circle.axis = normal.normalized();
  circle.centre =
      from + (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) / (2 * normal.squaredNorm());
  // through via, the rotation is in the sense of the normal
  const Eigen::Vector3d arm = from - circle.centre, last = to - circle.centre;
  const double angle = std::atan2(circle.axis.dot(arm.cross(last)), arm.dot(last));
  circle.angle = angle > 0 ? angle : angle + 2 * std::numbers::pi;
  return circle;
}

}  // namespace

CartesianArc::CartesianArc(Robot& robot, const Eigen::Vector3d& via, const Pose& target, const PathLimits& limits)
    : PathGenerator(robot, kArcName),
      through_(true),
      via_(via),
      target_(checked_pose(target, kArcName)),
      limits_(limits) {
  check_limits(limits, kArcName);
  if (!via.allFinite()) refuse("a coordinate of via that is not finite");
}

CartesianArc::CartesianArc(Robot& robot, const Circle& circle, const PathLimits& limits)
    : PathGenerator(robot, kArcName), through_(false), circle_(circle), limits_(limits) {
  check_limits(limits, kArcName);
  if (!circle.centre.allFinite() || !circle.axis.allFinite() || !std::isfinite(circle.angle))
    refuse("a number of the circle that is not finite");
  if (!(circle.axis.norm() > 0)) refuse("an axis of length 0");
  circle_.axis.normalize();
}

std::unique_ptr<RobotPath> CartesianArc::path_from(const JointVector& joints) {
  const Pose start = robot().kinematics().direct(joints);
  const Eigen::Vector3d from = start.translation();
  const Circle circle = through_ ? circle_through(from, via_, target_.translation()) : circle_;
  const Eigen::Vector3d centre = circle.centre + circle.axis * circle.axis.dot(from - circle.centre);
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  if (circle.tool_turns) turn = circle.angle * circle.axis;
  Pose end = target_;
  if (through_) {
    turn = rotation_vector(target_.linear() * start.linear().transpose());
  } else {
    end.translation() = centre + exp_rotation(circle.angle * circle.axis) * (from - centre);
    end.linear() = exp_rotation(turn) * start.linear();
  }
  const double length =
      std::max(std::abs(circle.angle) * (from - centre).norm() / limits_.speed, turn.norm() / limits_.angular_speed);
  if (length < ToolPath::kShortest) return nullptr;
  return ToolPath::whole(
      robot(), joints, std::make_unique<PoseArc>(start, centre, circle.axis, circle.angle, turn, end, length), limits_);
}

}  // namespace mrroc
