#include "language/paths/tool_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/require.hpp"
#include "geometry/difference_stencils.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/joints/motor_range.hpp"

namespace mrroc {

namespace {

constexpr double kToolJerkRate = 10;  // 1/s: the tool's jerk is this times its acceleration
// intervals of the joints' grid
constexpr std::size_t kIntervals = 400, kFewest = 16, kMost = 96;

constexpr double kFineGrid = 2e-5;  // m or rad of the tool from one node to the next
constexpr double kReach = 1e-3;     // m or rad of the tool for a difference

/// Sum of five neighbours' values with the weights of a stencil.
template <class Value, class Get>
Value weighted(const DifferenceStencils::Row& weights, std::size_t from, double scale, Get get) {
  Value sum = weights[0] * get(from);
  for (std::size_t i = 1; i < weights.size(); ++i) sum += weights[i] * get(from + i);
  return sum * scale;
}

}  // namespace

void check_limits(const PathLimits& limits, const char* name) {
  require_above_zero(name, "speed", limits.speed);
  require_above_zero(name, "acceleration", limits.acceleration);
  require_above_zero(name, "angular speed", limits.angular_speed);
  require_above_zero(name, "angular acceleration", limits.angular_acceleration);
}

Pose checked_pose(const Pose& pose, const char* name) {
  Pose exact = pose;
  if (!make_rigid(exact))
    throw NonFatalError(ErrorCode::invalid_argument, std::string{name} + ": the pose is not a rigid transform");
  exact.linear() = orthonormal(pose.linear());
  return exact;
}

ToolPath::ToolPath(const Robot& robot, const JointVector& near, Plan plan)
    : path_(std::move(plan.path)), kinematics_(robot.kinematics()) {
  breaks_ = path_->breaks();
  stops_ = std::move(plan.stops);
  waypoints_ = std::move(plan.waypoints);
  timed_ = plan.timed;
  if (timed_) {
    pace_ = {1, 2};  // after an interruption it is caught up with
  } else {
    const PathLimits& tool = plan.limits;
    limits_.push_back({0, 3, tool.speed, tool.acceleration, kToolJerkRate * tool.acceleration});
    limits_.push_back({3, 3, tool.angular_speed, tool.angular_acceleration, kToolJerkRate * tool.angular_acceleration});
  }
  for (std::size_t i = 0; i < robot.parameters().axes.size(); ++i) {
    const AxisParameters& axis = robot.parameters().axes[i];
    limits_.push_back({kJointRow + static_cast<int>(i), 1, kVelocityShare * axis.velocity_max,
                       kAccelerationShare * axis.acceleration_max, kJerkShare * axis.jerk_max});
  }
  const std::size_t pieces = breaks_.size() - 1;
  intervals_ = std::clamp(kIntervals / pieces, kFewest, kMost);
  tables_.resize(pieces);
  JointVector last = near;
  for (std::size_t piece = 0; piece < pieces; ++piece) fill(robot, piece, last);
}

std::unique_ptr<ToolPath> ToolPath::whole(const Robot& robot, const JointVector& near, std::unique_ptr<PosePath> path,
                                          const PathLimits& limits) {
  const std::vector<double> ends{0, path->breaks().back()};
  return std::make_unique<ToolPath>(robot, near, Plan{std::move(path), ends, ends, false, limits});
}

double ToolPath::spacing(std::size_t piece) const noexcept {
  return (breaks_[piece + 1] - breaks_[piece]) / static_cast<double>(intervals_);
}

JointVector ToolPath::joints_on_path(const Robot& robot, const Pose& pose, const JointVector& near, double s) const {
  std::string what = "the path after " + std::to_string(static_cast<int>(100 * s / length())) + " %:";
  JointVector joints = joints_on_branch(robot, pose, near, what);
  if (within_limits(robot.kinematics().model(), joints)) return joints;
  what += " the branch" + branch_text(robot, near) + " ends at" + place_text(pose) + ":";
  check_joints(robot, joints, what + " position");
  check_motors(robot, joints, what);
  return joints;
}

void ToolPath::fill(const Robot& robot, std::size_t piece, JointVector& near) {
  Table& table = tables_[piece];
  const double h = spacing(piece);
  double pace = 0;
  for (std::size_t i = 0; i <= intervals_; ++i) {
    const double s = i < intervals_ ? breaks_[piece] + static_cast<double>(i) * h : breaks_[piece + 1];
    const PathPose tool = path_->at(piece, s);
    pace = std::max(pace, tool.first.lpNorm<Eigen::Infinity>());
    near = joints_on_path(robot, tool.pose, near, s);
    table.joints.push_back(near);
    PathRates rates;
    rates.first.head<6>() = tool.first;
    rates.second.head<6>() = tool.second;
    table.rates.push_back(rates);
  }
  for (std::size_t i = 0; i <= intervals_; ++i) {
    const std::size_t from = std::min(i < 2 ? 0 : i - 2, intervals_ + 1 - DifferenceStencils::kPoints), k = i - from;
    const auto joints = [&table](std::size_t point) -> const JointVector& { return table.joints[point]; };
    const auto second = [&table](std::size_t point) -> Twist { return table.rates[point].second.head<6>(); };
    PathRates& rates = table.rates[i];
    const Eigen::Index count = near.size();
    rates.first.segment(kJointRow, count) =
        weighted<JointVector>(DifferenceStencils::kFirst[k], from, 1 / (12 * h), joints);
    rates.second.segment(kJointRow, count) =
        weighted<JointVector>(DifferenceStencils::kSecond[k], from, 1 / (12 * h * h), joints);
    rates.third.segment(kJointRow, count) =
        weighted<JointVector>(DifferenceStencils::kThird[k], from, 1 / (2 * h * h * h), joints);
    rates.third.head<6>() = weighted<Twist>(DifferenceStencils::kFirst[k], from, 1 / (12 * h), second);
    if (pace * h < kFineGrid)
      differentiate(table.joints[i], path_->at(piece, breaks_[piece] + static_cast<double>(i) * h), rates);
  }
}

void ToolPath::differentiate(const JointVector& joints, const PathPose& tool, PathRates& rates) const {
  const Twist first = tool.first, second = tool.second, third = rates.third.head<6>();
  const double h =
      std::min({kReach / first.norm(), std::sqrt(2 * kReach / second.norm()), std::cbrt(6 * kReach / third.norm())});
  if (!std::isfinite(h)) return;
  std::array<JointVector, DifferenceStencils::kPoints> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = (static_cast<double>(i) - 2) * h;
    // of the rotation: Magnus' expansion
    Twist way = t * (first + t * (second / 2 + (t / 6) * third));
    way.tail<3>() -= (t * t * t / 12) * first.tail<3>().cross(second.tail<3>());
    Pose pose = tool.pose;
    pose.translation() += way.head<3>();
    pose.linear() = exp_rotation(way.tail<3>()) * tool.pose.linear();
    points[i] = joints;
    if (kinematics_.follow(pose, joints, points[i]) != ErrorCode::none) return;
  }
  const auto point = [&points](std::size_t i) -> const JointVector& { return points[i]; };
  const Eigen::Index count = joints.size();
  rates.first.segment(kJointRow, count) = weighted<JointVector>(DifferenceStencils::kFirst[2], 0, 1 / (12 * h), point);
  rates.second.segment(kJointRow, count) =
      weighted<JointVector>(DifferenceStencils::kSecond[2], 0, 1 / (12 * h * h), point);
  rates.third.segment(kJointRow, count) =
      weighted<JointVector>(DifferenceStencils::kThird[2], 0, 1 / (2 * h * h * h), point);
}

PathRates ToolPath::rates(std::size_t piece, double s) const noexcept {
  const double place = (s - breaks_[piece]) / spacing(piece);
  const auto i = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(intervals_ - 1)));
  const double u = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
  const PathRates &a = tables_[piece].rates[i], &b = tables_[piece].rates[i + 1];
  PathRates rates{(1 - u) * a.first + u * b.first, (1 - u) * a.second + u * b.second, (1 - u) * a.third + u * b.third};
  const PathPose tool = path_->at(piece, s);  // exact: half-way between two directions a mean is too short
  rates.first.head<6>() = tool.first;
  rates.second.head<6>() = tool.second;
  return rates;
}

JointVector ToolPath::joints(double s) const noexcept {
  const std::size_t piece = piece_at(s);
  const double place = (s - breaks_[piece]) / spacing(piece);
  const auto i = static_cast<std::size_t>(std::clamp(std::round(place), 0.0, static_cast<double>(intervals_)));
  JointVector joints = tables_[piece].joints[i];
  kinematics_.follow(path_->at(piece, s).pose, tables_[piece].joints[i], joints);
  return joints;
}

void ToolPath::command(double s, double speed, double acceleration, RobotCommand& command) const noexcept {
  const PathPose tool = path_->at(piece_at(s), s);
  command.kind = CommandKind::pose;
  command.pose = tool.pose;
  command.twist = speed * tool.first;
  command.twist_acceleration = acceleration * tool.first + (speed * speed) * tool.second;
}

}  // namespace mrroc
