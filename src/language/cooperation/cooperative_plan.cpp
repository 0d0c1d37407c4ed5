#include "language/cooperation/cooperative_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/moving_pose.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/joints/motor_range.hpp"
#include "language/limits.hpp"
#include "language/motion_check.hpp"
#include "language/tool_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kPlanDifference = 1e-4;  // s, for the derivatives of the poses
constexpr double kReturn = 1.0;           // s, to the path after a pause
constexpr double kRestSpeed = 1e-5;       // m/s: below it the arms may stop within one macrostep
constexpr double kRestRate = 1e-3;        // m/s^2
constexpr double kPlanRounding = 1e-9;    // s
constexpr double kPathSamples = 256;      // of the path, to check whether an arm can follow it, at least
constexpr double kSampleTime = 0.1;       // s between them, at most

/// The mean of several poses that are close to each other.
Pose middle_of(const std::vector<Pose>& poses) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  for (const Pose& pose : poses) {
    position += pose.translation() / static_cast<double>(poses.size());
    turn += rotation_vector(poses[0].linear().transpose() * pose.linear()) / static_cast<double>(poses.size());
  }
  Pose middle = Pose::Identity();
  middle.translation() = position;
  middle.linear() = poses[0].linear() * exp_rotation(turn);
  return middle;
}

ErrorOrigin origin_of(const CooperatingArm& arm) {
  const Robot& robot = *arm.robot;
  return {robot.task().process_name(), robot.name(), 0, robot.state().tick};
}

}  // namespace

CooperativePlan::CooperativePlan(std::vector<CooperatingArm> arms, const std::vector<Pose>& poses,
                                 const CooperativeLimits& limits, const InternalForce& force)
    : arms_(std::move(arms)), poses_(poses), limits_(limits), force_(force), path_(poses, limits) {}

double CooperativePlan::internal_force() const noexcept {
  double most = 0;
  for (std::size_t i = 0; i < grasps_.size(); ++i) most = std::max(most, of(excess_, i).head<3>().norm());
  return most;
}

double CooperativePlan::internal_torque() const noexcept {
  double most = 0;
  for (std::size_t i = 0; i < grasps_.size(); ++i)
    most = std::max(most, force_.length * of(excess_, i).tail<3>().norm());
  return most;
}

void CooperativePlan::start() {
  step_ = arms_[0].robot->step_duration();
  path_ = ObjectPath(poses_, limits_);
  grasps_.clear();
  std::vector<Eigen::Vector3d> places;
  for (const CooperatingArm& arm : arms_) {
    const RobotState& state = arm.robot->known_state();
    if (arm.robot->step_duration() != step_)
      throw NonFatalError(ErrorCode::invalid_argument,
                          "CooperativeMotion: a macrostep of " + std::to_string(arm.robot->step_duration()) +
                              " s, expected " + std::to_string(step_) + " s as of the first arm",
                          origin_of(arm));
    grasps_.push_back(poses_[0].inverse() * arm.base * state.desired_pose);
    places.push_back(grasps_.back().translation());
  }
  internal_ = InternalWrench(places, force_.length);
  wanted_ = internal_.squeeze(force_.squeeze);
  const auto size = static_cast<Eigen::Index>(6 * arms_.size());
  for (Eigen::VectorXd* stack : {&measured_, &excess_, &given_, &speed_, &rate_, &jerk_}) stack->setZero(size);
  time_ = clock_ = 0;
  braking_ = false;
  off_.setZero();
  object_ = poses_[0];
  for (std::size_t i = 0; i < arms_.size(); ++i) check_arm(i);
  for (std::size_t i = 0; i < arms_.size(); ++i) take_motion(i);
}

void CooperativePlan::check_arm(std::size_t i) const {
  const double length = path_.duration();
  if (!(length > 0)) return;
  const Robot& robot = *arms_[i].robot;
  const ToolKinematics kinematics = robot.kinematics();
  const auto& axes = robot.parameters().axes;
  const auto joints_at = [&](double t, const JointVector& near) {
    JointVector joints = near;
    const ErrorCode code = kinematics.follow(tool_at(i, t), near, joints);
    if (code == ErrorCode::none || code == ErrorCode::singular) return joints;
    throw NonFatalError(code, "CooperativeMotion: after " + std::to_string(t) + " s", origin_of(arms_[i]));
  };
  const int samples =
      static_cast<int>(std::ceil(length / std::max(step_, std::min(length / kPathSamples, kSampleTime))));
  const double interval = length / samples;
  std::vector<JointVector> table{robot.state().desired_joints};
  for (int k = 1; k <= samples; ++k) {
    const std::string what = "CooperativeMotion: after " + std::to_string(k * interval) + " s";
    table.push_back(joints_at(k * interval, table.back()));
    check_joints(robot, table.back(), what + " position");
    check_motors(robot, table.back(), what + ",");
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const auto row = static_cast<Eigen::Index>(a);
      const double speed = (table.back()[row] - table[table.size() - 2][row]) / interval;
      if (!exceeds(speed, axes[a].velocity_max)) continue;
      throw NonFatalError(ErrorCode::velocity_limit,
                          what + " joint " + axes[a].name + " at " +
                              number_text(std::abs(speed), axes[a].velocity_max) + ", limit " +
                              number_text(axes[a].velocity_max, std::abs(speed)),
                          origin_of(arms_[i]));
    }
  }
  const MotionCheck::States states = [&](double t) {
    const JointVector& near = table[static_cast<std::size_t>(std::lround(std::min(t, length) / interval))];
    const JointVector before = joints_at(t - kPlanDifference, near), there = joints_at(t, near),
                      after = joints_at(t + kPlanDifference, near);
    return DesiredState{there, (after - before) / (2 * kPlanDifference),
                        (after - 2 * there + before) / (kPlanDifference * kPlanDifference)};
  };
  MotionCheck(robot).require(states, length);
}

void CooperativePlan::take_motion(std::size_t arm) {
  const MovingPose tool = desired_motion(*arms_[arm].robot);
  const Eigen::Matrix3d axes = poses_[0].linear().transpose() * arms_[arm].base.linear();
  of(speed_, arm) = rotate_twist(axes, tool.twist);
  of(rate_, arm) = rotate_twist(axes, tool.rate);
  of(speed_, arm).tail<3>() *= force_.length;
  of(rate_, arm).tail<3>() *= force_.length;
}

void CooperativePlan::resume() {
  // the object's pose according to each arm, corrected for the displacement by which it has given way; the remaining
  // difference is added to that displacement
  std::vector<Pose> seen;
  for (std::size_t i = 0; i < arms_.size(); ++i)
    seen.push_back(arms_[i].base * arms_[i].robot->state().desired_pose * grasp_at(i, 0).inverse());
  object_ = middle_of(seen);
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    const Pose grasp = object_.inverse() * arms_[i].base * arms_[i].robot->state().desired_pose;
    of(given_, i) << grasp.translation() - grasps_[i].translation(),
        force_.length * rotation_vector(grasp.linear() * grasps_[i].linear().transpose());
  }
  speed_.setZero();
  rate_.setZero();
  const Pose there = path_.restart(time_, object_, kReturn);
  off_ << object_.translation() - there.translation(), rotation_vector(there.linear().transpose() * object_.linear());
  time_ = clock_ = 0;
  braking_ = false;
}

void CooperativePlan::brake() {
  path_.stop(time_);
  time_ = 0;
  braking_ = true;
}

bool CooperativePlan::over(double t) const {
  return (braking_ || poses_.size() > 1) && time_ + t >= path_.duration() - kPlanRounding &&
         (clock_ + t >= kReturn || off_.isZero(0));
}

Pose CooperativePlan::object_at(double t) const {
  Pose pose = path_.at(time_ + t);
  const double u = std::clamp((clock_ + t) / kReturn, 0.0, 1.0);
  const double left = 1 - u * u * u * (10 - u * (15 - 6 * u));
  if (left == 0 || off_.isZero(0)) return pose;
  pose.translation() += left * off_.head<3>();
  pose.linear() = pose.linear() * exp_rotation(left * off_.tail<3>());
  return pose;
}

Pose CooperativePlan::grasp_at(std::size_t arm, double t) const {
  const Twist d = of(given_, arm) + t * (of(speed_, arm) + t * (of(rate_, arm) / 2 + (t / 6) * of(jerk_, arm)));
  Pose grasp = grasps_[arm];
  grasp.translation() += d.head<3>();
  grasp.linear() = exp_rotation(d.tail<3>() / force_.length) * grasp.linear();
  return grasp;
}

Pose CooperativePlan::tool_at(std::size_t arm, double t) const {
  return arms_[arm].base.inverse() * object_at(t) * grasp_at(arm, t);
}

void CooperativePlan::measure() {
  for (std::size_t i = 0; arms_[0].wrench && i < arms_.size(); ++i) {
    const Wrench wrench = arms_[i].wrench();
    if (!wrench.allFinite())
      throw NonFatalError(ErrorCode::sensor_not_ready, "CooperativeMotion: the wrench of an arm is not finite",
                          origin_of(arms_[i]));
    of(measured_, i) << grasps_[i].linear() * wrench.head<3>(), grasps_[i].linear() * wrench.tail<3>() / force_.length;
  }
  internal_.of(measured_, excess_);
  check_limits();
}

void CooperativePlan::check_limits() const {
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    const double newtons = of(excess_, i).head<3>().norm();
    if (newtons > force_.limit)
      throw NonFatalError(ErrorCode::force_limit,
                          "internal force of " + number_text(newtons, force_.limit) + " N, limit " +
                              number_text(force_.limit, newtons) + " N",
                          origin_of(arms_[i]));
    const double way = std::max(of(given_, i).head<3>().norm(), of(given_, i).tail<3>().norm());
    if (way > force_.travel)
      throw NonFatalError(ErrorCode::force_limit,
                          "for the desired internal force the arm would have to give way by " +
                              number_text(1000 * way, 1000 * force_.travel) + " mm, limit " +
                              number_text(1000 * force_.travel, 1000 * way) + " mm",
                          origin_of(arms_[i]));
  }
}

void CooperativePlan::give_way() {
  const bool ends = over(0);
  if (ends && speed_.lpNorm<Eigen::Infinity>() < kRestSpeed && rate_.lpNorm<Eigen::Infinity>() < kRestRate) {
    for (Eigen::VectorXd* stack : {&speed_, &rate_, &jerk_}) stack->setZero();
    return;
  }
  // linear to the rate that brings the speed to b (P h - wanted) within the lag; to rest at the end of the path
  const double gain = ends ? 0 : force_.admittance, lag = std::max(force_.lag, step_);
  jerk_ = ((gain * (excess_ - wanted_) - speed_) / lag - rate_) / step_;
}

void CooperativePlan::command(std::size_t i) const {
  const double h = kPlanDifference;
  const Pose before = tool_at(i, step_ - h), there = tool_at(i, step_), after = tool_at(i, step_ + h);
  RobotCommand& command = arms_[i].robot->command();
  command.kind = CommandKind::pose;
  command.pose = there;
  if (over(step_) && speed_.isZero(0) && jerk_.isZero(0)) return;  // to rest
  const Eigen::Vector3d first = rotation_vector(there.linear() * before.linear().transpose()) / h;
  const Eigen::Vector3d second = rotation_vector(after.linear() * there.linear().transpose()) / h;
  command.twist << (after.translation() - before.translation()) / (2 * h), 0.5 * (first + second);
  Twist rate;
  rate << (after.translation() - 2 * there.translation() + before.translation()) / (h * h), (second - first) / h;
  command.twist_acceleration = rate;
}

void CooperativePlan::advance() {
  object_ = object_at(step_);
  given_ += step_ * (speed_ + step_ * (rate_ / 2 + (step_ / 6) * jerk_));
  speed_ += step_ * (rate_ + (step_ / 2) * jerk_);
  rate_ += step_ * jerk_;
  time_ += step_;
  clock_ += step_;
}

}  // namespace mrroc
