// Commands towards targets that jump, checked as the EDP would.
#include "mrroc/tracker.hpp"

#include "geometry/quintic.hpp"
#include "language/fakes.hpp"
#include "language/limit_check.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes::tracker_test {
namespace {

/// Shows each step's target and command to the test.
class Follow : public Generator {
 public:
  Follow(Robot& robot, double speed) : Generator("Follow"), tracker(robot, speed) {}
  void next_state() override { act(tracker); }
  Tracker tracker;
  std::function<void(Tracker&)> act;
};

JointVector random_joints(const Robot& robot, double part = 1) {
  JointVector joints = JointVector::Zero(static_cast<Eigen::Index>(robot.parameters().axes.size()));
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    const AxisParameters& axis = robot.parameters().axes[static_cast<std::size_t>(i)];
    joints[i] = part * number(axis.position_min, axis.position_max);
  }
  return joints;
}

/// Every command of the Move as the EDP checks it: the polynomial of degree five to its end.
class Checked {
 public:
  explicit Checked(const Robot& robot) : robot_(robot), check_(*robot.models().front(), 0.002) {}

  /// Class and code of the first violation; none: 0.
  ErrorCode violation() {
    const RobotState& state = robot_.state();
    const RobotCommand& command = robot_.command();
    const DesiredState from{state.desired_joints, state.desired_velocity, state.desired_acceleration};
    const DesiredState to{command.joints, command.joint_velocity, command.joint_acceleration};
    Quintic path;
    path.plan(from, to, command.motion_steps * 0.002);
    return check_
        .check(from, to, command.motion_steps, &path,
               [&](double t, const JointVector&, DesiredState& at) {
                 at = path.at(t);
                 return ErrorCode::none;
               })
        .code;
  }

 private:
  const Robot& robot_;
  LimitCheck check_;
};

TEST(Tracker, CommandsKeepEveryLimitWhereverTheTargetJumps) {
  check_property(200, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    Follow follow(*arm, number(0.3, 1));
    Checked checked(*arm);
    JointVector target = JointVector::Zero(6);
    follow.act = [&](Tracker& tracker) {
      if (number(0, 1) < 0.1) target = random_joints(*arm);
      tracker.to(target);
      RC_ASSERT(checked.violation() == ErrorCode::none);
    };
    int steps = 0;
    Move({*arm}, {}, follow.until(When{"over", [&] { return ++steps > 100; }}));
  });
}

TEST(Tracker, ArrivesExactlyAndStays) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Follow follow(*arm, 1);
  const JointVector target = JointVector::Constant(6, 0.3);
  follow.act = [&](Tracker& tracker) { tracker.to(target); };
  int after = 0;
  Move({*arm}, {}, follow.until(When{"there", [&] { return follow.tracker.arrived() && ++after > 3; }}));
  EXPECT_EQ(arm->state().desired_joints, target);
  EXPECT_TRUE(arm->state().at_rest());
}

TEST(Tracker, CatchesUpWithAMovingTarget) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Follow follow(*arm, 1);
  JointVector target = JointVector::Constant(6, 0.1);
  const JointVector velocity = JointVector::Constant(6, 0.05);
  follow.act = [&](Tracker& tracker) {
    tracker.to(target, velocity);
    target += arm->step_duration() * velocity;
  };
  Move({*arm}, {}, follow.until(When{"there", [&] { return follow.tracker.arrived(); }}));
  EXPECT_LT((arm->state().desired_joints - target).norm(), 1e-9);
  EXPECT_LT((arm->state().desired_velocity - velocity).norm(), 1e-9);
}

TEST(Tracker, FollowsAPose) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Follow follow(*arm, 1);
  const Pose target = arm->models().front()->flange(JointVector::Constant(6, 0.2));
  follow.act = [&](Tracker& tracker) { tracker.to(target); };
  Move({*arm}, {}, follow.until(When{"there", [&] { return follow.tracker.arrived(); }}));
  EXPECT_LT((arm->kinematics().direct(arm->state().desired_joints).matrix() - target.matrix()).norm(), 1e-9);
}

TEST(Tracker, RefusesTargetsThatCannotBeReached) {
  FakeTask task;
  const auto arm = task.robot("arm");
  EXPECT_THROW(Tracker(*arm, 0), NonFatalError);
  EXPECT_THROW(Tracker(*arm, 1.1), NonFatalError);
  const auto code = [&](const std::function<void(Tracker&)>& act) {
    Follow follow(*arm, 1);
    follow.act = act;
    try {
      Move({*arm}, {}, follow);
    } catch (const NonFatalError& error) {
      return error.code();
    }
    return ErrorCode::none;
  };
  const AxisParameters& axis = arm->parameters().axes[0];
  JointVector outside = JointVector::Zero(6);
  outside[0] = axis.position_max + 0.1;
  EXPECT_EQ(code([&](Tracker& tracker) { tracker.to(outside); }), ErrorCode::joint_limit);
  EXPECT_EQ(code([](Tracker& tracker) { tracker.to(JointVector::Zero(5)); }), ErrorCode::invalid_argument);
  EXPECT_EQ(code([](Tracker& tracker) { tracker.to(JointVector::Constant(6, NAN)); }), ErrorCode::not_finite);
  Pose pose = Pose::Identity();
  pose.translation().x() = NAN;
  EXPECT_EQ(code([&](Tracker& tracker) { tracker.to(pose); }), ErrorCode::not_finite);
  const JointVector fast = JointVector::Constant(6, 2 * axis.velocity_max);
  EXPECT_EQ(code([&](Tracker& tracker) { tracker.to(JointVector::Zero(6), fast); }), ErrorCode::velocity_limit);
}

}  // namespace
}  // namespace mrroc::fakes::tracker_test
