// The command of a displaced tool: its pose, twist and rate belong together.
#include "language/coordination/displacement.hpp"

#include "geometry/moving_pose.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc::fakes::displacement_test {
namespace {

constexpr double kStep = 0.02, kLag = 0.05;
const Eigen::Vector2d kMost{0.2, 1.0};

Displacement::Axes random_axes(double most) {
  Displacement::Axes axes;
  for (Eigen::Index i = 0; i < 6; ++i) axes[i] = number(-most, most);
  return axes;
}

RobotCommand wished_at(const MovingPose& motion) {
  RobotCommand command;
  command.kind = CommandKind::pose;
  command.pose = motion.pose;
  command.twist = motion.twist;
  command.twist_acceleration = motion.rate;
  return command;
}

/// A displacement a short time before or after a macrostep's end, to first order.
struct Coordinates {
  Displacement::Axes value, speed;
  Pose at(double t) const {
    const Displacement::Axes x = value + t * speed;
    Pose pose = Pose::Identity();
    pose.translation() = x.head<3>();
    pose.linear() = exp_rotation(x.tail<3>());
    return pose;
  }
};

TEST(Displacement, TwistAndRateAreThoseOfTheDisplacedPose) {
  check_property(500, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    MovingPose motion;
    motion.pose.translation() = random_axes(0.5).head<3>();
    motion.pose.linear() = exp_rotation(random_axes(1.5).tail<3>());
    motion.twist = random_axes(0.5);
    motion.rate = random_axes(2);
    Displacement displacement;
    for (int i = 0; i < 5; ++i) displacement.advance(random_axes(0.1), kLag, kStep, kMost);
    displacement.command(*arm, wished_at(motion), "test");
    const RobotCommand command = arm->command();
    RC_ASSERT(command.kind == CommandKind::pose);

    const Coordinates x{displacement.value(), displacement.speed()};
    const double h = 1e-4;
    const auto pose_at = [&](double t) { return motion.after(t) * x.at(t); };
    const Pose here = pose_at(0), later = pose_at(h), earlier = pose_at(-h);
    RC_ASSERT((command.pose.matrix() - here.matrix()).norm() < 1e-12);
    const Eigen::Vector3d flow = (later.translation() - earlier.translation()) / (2 * h);
    const Eigen::Vector3d turn = rotation_vector(later.linear() * earlier.linear().transpose()) / (2 * h);
    RC_ASSERT((command.twist.head<3>() - flow).norm() < 1e-6);
    RC_ASSERT((command.twist.tail<3>() - turn).norm() < 1e-6);
  });
}

TEST(Displacement, RateIsThatOfTheTwistAlongTheMotion) {
  check_property(500, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    MovingPose motion;
    motion.pose.linear() = exp_rotation(random_axes(1.5).tail<3>());
    motion.twist = random_axes(0.3);
    motion.rate = random_axes(1);
    // two displacements, one short macrostep apart, in which x has a constant jerk
    const double h = 1e-4;
    const Displacement::Axes first = random_axes(0.1);
    Displacement earlier;
    for (int i = 0; i < 6; ++i) earlier.advance(first, kLag, kStep, kMost);
    Displacement later = earlier;
    later.advance(first, kLag, h, kMost);
    const auto commanded = [&](const Displacement& displacement, double t) {
      MovingPose there = motion;
      there.pose = motion.after(t);
      there.twist = motion.twist + t * motion.rate;
      displacement.command(*arm, wished_at(there), "test");
      return arm->command();
    };
    const RobotCommand a = commanded(earlier, 0), b = commanded(later, h);
    const Eigen::VectorXd mean = 0.5 * (Eigen::VectorXd(a.twist_acceleration) + Eigen::VectorXd(b.twist_acceleration));
    RC_ASSERT(((b.twist - a.twist) / h - mean).norm() < 1e-3);
  });
}

TEST(Displacement, WithoutADisplacementTheCommandIsTheMpsOwn) {
  FakeTask task;
  const auto arm = task.robot("arm");
  RobotCommand wished;
  wished.kind = CommandKind::joint;
  wished.joints = JointVector::Constant(6, 0.123456789);
  wished.joint_velocity = JointVector::Constant(6, 0.1);
  wished.start_tick = 77;
  Displacement displacement;
  displacement.advance(Displacement::Axes::Zero(), kLag, kStep, kMost);
  displacement.command(*arm, wished, "test");
  EXPECT_EQ(arm->command().kind, CommandKind::joint);
  EXPECT_EQ(arm->command().joints, wished.joints);
  EXPECT_EQ(arm->command().joint_velocity, wished.joint_velocity);
  EXPECT_EQ(arm->command().joint_acceleration.size(), 0);
  EXPECT_EQ(arm->command().start_tick, 77U);
}

TEST(Displacement, StaysWithinItsAccelerationAndJerk) {
  check_property(500, [] {
    Displacement displacement;
    Displacement::Axes speed = displacement.speed();
    for (int i = 0; i < 60; ++i) {
      displacement.advance(random_axes(1), kLag, kStep, kMost);
      const Displacement::Axes mean = (displacement.speed() - speed) / kStep;
      RC_ASSERT(mean.head<3>().norm() <= kMost[0] * 1.0001);
      RC_ASSERT(mean.tail<3>().norm() <= kMost[1] * 1.0001);
      speed = displacement.speed();
    }
  });
}

TEST(Displacement, RefusesCommandsWithoutAPlace) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Displacement displacement;
  const auto code = [&](CommandKind kind, bool relative) {
    RobotCommand wished;
    wished.kind = kind;
    wished.relative = relative;
    wished.joints = JointVector::Zero(6);
    try {
      displacement.command(*arm, wished, "test");
    } catch (const NonFatalError& error) {
      return error.code();
    }
    return ErrorCode::none;
  };
  EXPECT_EQ(code(CommandKind::joint, false), ErrorCode::none);
  EXPECT_EQ(code(CommandKind::pose, false), ErrorCode::none);
  for (const CommandKind kind :
       {CommandKind::motor, CommandKind::joint_velocity, CommandKind::twist, CommandKind::force})
    EXPECT_EQ(code(kind, false), ErrorCode::invalid_argument);
  EXPECT_EQ(code(CommandKind::pose, true), ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace mrroc::fakes::displacement_test
