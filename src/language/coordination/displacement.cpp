#include "language/coordination/displacement.hpp"

#include <algorithm>
#include <string>

#include "geometry/moving_pose.hpp"
#include "geometry/rigid_motion.hpp"
#include "geometry/rotation_rates.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kPoseDifference = 1e-3;               // s
constexpr double kJerkRate = 10;                       // 1/s: jerk per acceleration
constexpr double kRestSpeed = 1e-7, kRestRate = 1e-5;  // m/s, rad/s and per s: below, it rests

JointVector or_zero(const JointVector& values, Eigen::Index count) {
  return values.size() != 0 ? values : JointVector(JointVector::Zero(count));
}

/// The motion that the MP wishes at the macrostep's end. `whole`: with the acceleration.
MovingPose wished_motion(const Robot& robot, const RobotCommand& wished, bool whole) {
  if (wished.kind == CommandKind::joint) {
    const Eigen::Index count = wished.joints.size();
    return tool_motion(robot.kinematics(), wished.joints, or_zero(wished.joint_velocity, count),
                       or_zero(wished.joint_acceleration, count), kPoseDifference);
  }
  MovingPose motion{wished.pose, wished.twist, Twist::Zero()};
  if (whole && wished.twist_acceleration.size() == 6) motion.rate = wished.twist_acceleration;
  return motion;
}

bool ends_at_rest(const RobotCommand& wished) {
  return wished.kind == CommandKind::joint ? wished.joint_velocity.isZero(0) : wished.twist.isZero(0);
}

/// The MP leaves the acceleration at the macrostep's end to the EDP, and the robot does not rest there.
bool without_acceleration(const RobotCommand& wished) {
  const JointVector& given = wished.kind == CommandKind::joint ? wished.joint_acceleration : wished.twist_acceleration;
  return given.size() == 0 && !ends_at_rest(wished);
}

/// The translation and the rotation, each shortened.
Displacement::Axes bounded(const Displacement::Axes& x, const Eigen::Vector2d& most) {
  const auto factor = [](double norm, double limit) { return norm > limit ? limit / norm : 1; };
  Displacement::Axes shortened = x;
  shortened.head<3>() *= factor(x.head<3>().norm(), most[0]);
  shortened.tail<3>() *= factor(x.tail<3>().norm(), most[1]);
  return shortened;
}

}  // namespace

void Displacement::reset() noexcept {
  value_.setZero();
  halt();
}

void Displacement::halt() noexcept {
  speed_.setZero();
  rate_.setZero();
}

void Displacement::advance(const Axes& wanted, double lag, double step, const Eigen::Vector2d& most) noexcept {
  const Axes rate = bounded((wanted - speed_) / std::max(lag, step), most);
  const Axes jerk = bounded((rate - rate_) / step, kJerkRate * most);
  value_ += step * (speed_ + step * (rate_ / 2 + (step / 6) * jerk));
  speed_ += step * (rate_ + (step / 2) * jerk);
  rate_ += step * jerk;
  if (wanted.isZero(0) && speed_.lpNorm<Eigen::Infinity>() < kRestSpeed && rate_.lpNorm<Eigen::Infinity>() < kRestRate)
    halt();
}

void Displacement::command(Robot& robot, const RobotCommand& wished, const char* caller) const {
  if ((wished.kind != CommandKind::joint && wished.kind != CommandKind::pose) || wished.relative)
    throw NonFatalError(ErrorCode::invalid_argument,
                        std::string{caller}.append(": the MP commands kind ") +
                            std::to_string(static_cast<int>(wished.kind)) + (wished.relative ? ", relative" : "") +
                            ", expected joints or a pose",
                        {robot.task().process_name(), robot.name(), 0, robot.state().tick});
  RobotCommand& command = robot.command();
  if (value_.isZero(0) && speed_.isZero(0) && rate_.isZero(0)) {
    command = wished;
    return;
  }
  const bool whole = !without_acceleration(wished);
  const MovingPose motion = wished_motion(robot, wished, whole);
  const Eigen::Matrix3d& axes = motion.pose.linear();
  const Eigen::Vector3d way = axes * value_.head<3>(), flow = axes * speed_.head<3>();
  const Eigen::Vector3d turn = motion.twist.tail<3>(), spin = motion.rate.tail<3>();
  const Turning turning = turning_of(value_.tail<3>(), speed_.tail<3>(), rate_.tail<3>());
  command.kind = CommandKind::pose;
  command.interpolation = wished.interpolation;
  command.pose.translation() = motion.pose.translation() + way;
  command.pose.linear() = axes * exp_rotation(value_.tail<3>());
  command.twist << motion.twist.head<3>() + turn.cross(way) + flow, turn + axes * turning.velocity;
  if (!whole) return;
  Twist rate;
  rate << motion.rate.head<3>() + spin.cross(way) + turn.cross(turn.cross(way)) + 2 * turn.cross(flow) +
              axes * rate_.head<3>(),
      spin + turn.cross(axes * turning.velocity) + axes * turning.rate;
  command.twist_acceleration = rate;
}

}  // namespace mrroc
