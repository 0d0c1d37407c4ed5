#include "edp/command/planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "edp/random_values.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp::planner_test {
namespace {

template <class Model>
struct Planning {
  Model model;
  Planner planner{model, kPeriod};
  Macrostep macrostep;
  ErrorReport plan(const RobotCommand& command, const DesiredState& from, Pace pace = Pace::as_commanded) {
    return planner.plan(command, from, pace, macrostep);
  }
  ErrorReport plan(const RobotCommand& command) {
    return plan(command, DesiredState::resting_at(model.parameters().home));
  }
};

TEST(Planner, RefusesStepsOutOfRange) {
  Planning<Slide> p;
  const JointVector target = one(0.26);
  EXPECT_EQ(p.plan(joint_command(target, 0, 1)).code, ErrorCode::invalid_motion_steps);
  EXPECT_EQ(p.plan(joint_command(target, kMaxMotionSteps + 1, 1)).code, ErrorCode::invalid_motion_steps);
  EXPECT_EQ(p.plan(joint_command(target, 100, 0)).code, ErrorCode::invalid_reply_step);
  EXPECT_EQ(p.plan(joint_command(target, 100, 102)).code, ErrorCode::invalid_reply_step);
  EXPECT_EQ(p.plan(joint_command(target, 100, 1)).code, ErrorCode::none);
  EXPECT_EQ(p.plan(joint_command(target, 100, 101)).code, ErrorCode::none);
  EXPECT_EQ(p.plan(joint_command(target, kMaxMotionSteps, kMaxMotionSteps)).code, ErrorCode::none);
}

TEST(Planner, RefusesNonFiniteValuesAndVectorsOfTheWrongSize) {
  Planning<Gantry> p;
  RobotCommand command = joint_command(JointVector::Zero(4), 100, 100);
  command.joints[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(p.plan(command).code, ErrorCode::not_finite);
  EXPECT_EQ(p.plan(command).detail.view(), "joints of axis 3 is nan");
  command.joints = JointVector::Zero(3);
  EXPECT_EQ(p.plan(command).code, ErrorCode::invalid_argument);
  command.joints = JointVector::Zero(4);
  command.joint_velocity = JointVector::Zero(5);
  EXPECT_EQ(p.plan(command).code, ErrorCode::invalid_argument);
  command.joint_velocity = JointVector::Constant(4, std::numeric_limits<double>::infinity());
  EXPECT_EQ(p.plan(command).code, ErrorCode::not_finite);
  command.kind = static_cast<CommandKind>(77);
  EXPECT_EQ(p.plan(command).code, ErrorCode::invalid_argument);
  command = RobotCommand{};
  command.kind = CommandKind::pose;
  command.pose.linear() *= 1.1;
  EXPECT_EQ(p.plan(command).code, ErrorCode::invalid_argument);
  command.pose = Eigen::Translation3d(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_EQ(p.plan(command).code, ErrorCode::not_finite);
}

TEST(Planner, NamesAxisTickValueAndLimit) {
  Planning<Gantry> p;
  JointVector target = JointVector::Zero(4);
  target[1] = 2.5;
  EXPECT_EQ(p.plan(joint_command(target, 5000, 1)).code, ErrorCode::joint_limit);
  EXPECT_EQ(p.plan(joint_command(target, 5000, 1)).detail.view(), "axis 2 (y), tick 5000: position 2.5, limit 2");
  target[1] = 0.5;
  EXPECT_EQ(p.plan(joint_command(target, 400, 1)).code, ErrorCode::velocity_limit);  // peak 1.875 * 0.5 / 0.8 s
  EXPECT_EQ(p.plan(joint_command(target, 1000, 1)).code, ErrorCode::none);
  target[1] = 0.01;
  EXPECT_EQ(p.plan(joint_command(target, 35, 1)).code, ErrorCode::acceleration_limit);
  p.model.change().axes[1].jerk_max = 1000;
  EXPECT_EQ(p.plan(joint_command(target, 35, 1)).code, ErrorCode::jerk_limit);  // 60 * 0.01 / 0.07^3
}

// original's defect 7: limits were checked at the end point only
TEST(Planner, RefusesAPathThatLeavesTheLimitsBetweenItsEnds) {
  Planning<Slide> p;
  RobotCommand command = joint_command(one(1.95), 500, 1);
  command.joint_velocity = one(-0.5);
  DesiredState from = DesiredState::resting_at(one(1.95));
  from.velocity[0] = 0.5;
  const ErrorReport report = p.plan(command, from);
  EXPECT_EQ(report.code, ErrorCode::joint_limit) << report.detail.view();
}

TEST(Planner, RefusesAMotionWithoutAStopInTime) {
  Planning<Slide> p;
  DesiredState from = DesiredState::resting_at(one(1.9));
  from.velocity[0] = 0.5;
  RobotCommand command = joint_command(one(1.99), 80, 1);
  command.joint_velocity = one(0.5);
  const ErrorReport report = p.plan(command, from);
  EXPECT_EQ(report.code, ErrorCode::joint_limit);
  EXPECT_NE(report.detail.view().find("a stop would reach"), std::string_view::npos) << report.detail.view();
}

/// Two joints whose second motor turns with their sum.
class CoupledModel : public PlanarArm {
 public:
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = kGear * joints;
    motors[1] += motors[0];
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector&) const noexcept override {
    return (JointMatrix(2, 2) << kGear, 0, kGear, kGear).finished();
  }
};

TEST(Planner, ChecksTheMotorsAtEveryTickOfTheStop) {
  for (const double motor_max : {250.0, 0.2}) {
    // the first joint stops at once, the second slowly: their sum overshoots before it returns
    CoupledModel model;
    model.change().axes[1].acceleration_max = 0.4;
    model.change().axes[1].motor_max = motor_max;
    Planner planner(model, kPeriod);
    DesiredState from = DesiredState::resting_at((JointVector(2) << -0.06, 0.04).finished());
    from.velocity << 0.6, -0.4;
    RobotCommand command = joint_command(JointVector::Zero(2), 50, 1);
    command.joint_velocity = from.velocity;
    Macrostep macrostep;
    const ErrorReport report = planner.plan(command, from, Pace::as_commanded, macrostep);
    if (motor_max > 1) {
      EXPECT_EQ(report.code, ErrorCode::none) << report.detail.view();
    } else {
      EXPECT_EQ(report.code, ErrorCode::motor_limit);
      EXPECT_NE(report.detail.view().find("motor position in a stop"), std::string_view::npos) << report.detail.view();
    }
  }
}

TEST(Planner, NoAcceptedMotionHasAStopWhoseMotorsLeaveTheirLimits) {
  int accepted = 0, refused = 0;
  EXPECT_TRUE(rc::check([&] {
    CoupledModel model;
    // mostly as above: the sum overshoots and returns
    model.change().axes[1].acceleration_max = number(0.3, 1);
    model.change().axes[1].motor_max = number(0.05, 1);
    Planner planner(model, kPeriod);
    DesiredState to = DesiredState::resting_at(JointVector::Zero(2));
    to.velocity << number(0.2, 0.6), number(-0.6, 0);
    DesiredState from = to;
    from.position -= to.velocity * (50 * kPeriod);
    RobotCommand command = joint_command(to.position, 50, 1);
    command.joint_velocity = to.velocity;
    Macrostep macrostep;
    if (planner.plan(command, from, Pace::as_commanded, macrostep).code != ErrorCode::none) {
      ++refused;
      return;
    }
    ++accepted;
    // a robot that starts outside a limit may move, but no farther out
    JointVector start(2), motors(2);
    model.joints_to_motors(from.position, start);
    Stop stop(model.parameters(), kPeriod);
    stop.plan(to);
    for (std::uint32_t k = 0; k <= stop.ticks(); ++k) {
      model.joints_to_motors(stop.at(k * kPeriod).position, motors);
      RC_ASSERT(motors[1] <= std::max(model.parameters().axes[1].motor_max, start[1]) + 1e-6);
    }
  }));
  EXPECT_GT(accepted, 10);
  EXPECT_GT(refused, 10);
}

TEST(Planner, ChecksTheMotorsToo) {
  Planning<Slide> p;
  p.model.change().axes[0].motor_max = 100;  // the joint alone could go to 2
  EXPECT_EQ(p.plan(joint_command(one(0.9), 2000, 1)).code, ErrorCode::none);
  const ErrorReport report = p.plan(joint_command(one(1.1), 2000, 1));
  EXPECT_EQ(report.code, ErrorCode::motor_limit);
  EXPECT_EQ(report.detail.view(), "axis 1 (x), tick 2000: motor position 110, limit 100");
}

TEST(Planner, RobotOutsideItsLimitsMayOnlyMoveInwards) {
  Planning<Slide> p;
  const DesiredState outside = DesiredState::resting_at(one(2.1));
  EXPECT_EQ(p.plan(joint_command(one(2.0), 1000, 1), outside).code, ErrorCode::none);
  EXPECT_EQ(p.plan(joint_command(one(2.2), 1000, 1), outside).code, ErrorCode::joint_limit);
}

// nothing may hide between the ticks of a short macrostep
TEST(Planner, OneTickStepIsCheckedToo) {
  Planning<Slide> p;
  p.model.change().axes[0].jerk_max = 1e5;
  EXPECT_EQ(p.plan(joint_command(one(0.2515), 1, 1)).code, ErrorCode::acceleration_limit);
  EXPECT_EQ(p.plan(joint_command(one(0.25001), 1, 1)).code, ErrorCode::acceleration_limit);  // slow, but 14 m/s^2
  EXPECT_EQ(p.plan(joint_command(one(0.250003), 1, 1)).code, ErrorCode::none);
  RobotCommand command = joint_command(one(0.2507), 1, 1);
  command.joint_velocity = one(0.7);  // a jump of the velocity
  EXPECT_EQ(p.plan(command).code, ErrorCode::acceleration_limit);
  // what a trajectory at constant velocity asks for
  DesiredState moving = DesiredState::resting_at(one(0.25));
  moving.velocity[0] = 0.7;
  command.joints = one(0.2514);
  EXPECT_EQ(p.plan(command, moving).code, ErrorCode::none);
}

TEST(Planner, RelativeIsRelativeToDesiredForJointsAndForPoses) {
  EXPECT_TRUE(rc::check([] {
    Planning<Gantry> p;
    const DesiredState from = DesiredState::resting_at(random_vector(4, 0.9));
    RobotCommand command = joint_command(random_vector(4, 0.1), 1000, 1);
    command.relative = true;
    RC_ASSERT(p.plan(command, from).code == ErrorCode::none);
    RC_ASSERT((p.macrostep.to.position - from.position - command.joints).norm() < 1e-15);

    command.kind = CommandKind::pose;
    command.pose = p.model.flange(command.joints);
    RC_ASSERT(p.plan(command, from).code == ErrorCode::none);
    RC_ASSERT(p.model.flange(p.macrostep.to.position).isApprox(p.model.flange(from.position) * command.pose, 1e-12));
  }));
}

TEST(Planner, TwistGivesTheJointVelocity) {
  EXPECT_TRUE(rc::check([] {
    Planning<PlanarArm> p;
    const JointVector near = (JointVector(2) << number(-1, 1), number(0.5, 1.2)).finished();
    const JointVector velocity = random_vector(2, 0.3);
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.motion_steps = 1000;
    command.pose = p.model.flange(near);
    command.twist = p.model.jacobian(near, Eigen::Vector3d::Zero()) * velocity;
    const ErrorReport report = p.plan(command, DesiredState::resting_at(near));
    RC_ASSERT(report.code == ErrorCode::none);
    RC_ASSERT((p.macrostep.to.velocity - velocity).norm() < 1e-9);
    RC_ASSERT((p.macrostep.to.position - near).norm() < 1e-9);
    command.twist[2] = 0.1;  // out of the plane
    RC_ASSERT(p.plan(command, DesiredState::resting_at(near)).code == ErrorCode::singular);
  }));
}

TEST(Planner, RefusesAPoseOutOfReach) {
  Planning<PlanarArm> p;
  RobotCommand command;
  command.kind = CommandKind::pose;
  command.pose = Eigen::Translation3d(1, 0.2, 0);
  const ErrorReport report = p.plan(command);
  EXPECT_EQ(report.code, ErrorCode::out_of_workspace);
  EXPECT_EQ(report.detail.view(), "position (1, 0.2, 0)");
}

TEST(Planner, MotionIsStretchedUntilTheLimitsHold) {
  Planning<Slide> p;
  RobotCommand command = joint_command(one(0.75), 10, 11);
  const DesiredState from = DesiredState::resting_at(one(0.25));
  EXPECT_NE(p.plan(command, from).code, ErrorCode::none);
  EXPECT_EQ(p.plan(command, from, Pace::stretched).code, ErrorCode::none);
  EXPECT_GT(p.macrostep.steps, 500u);
  EXPECT_LT(p.macrostep.steps, 1000u);
  EXPECT_EQ(p.macrostep.reply_step, p.macrostep.steps + 1);
  EXPECT_EQ(p.macrostep.to.position[0], 0.75);

  command.joint_velocity = one(0.4);  // there is room for a run-up
  EXPECT_EQ(p.plan(command, from, Pace::stretched).code, ErrorCode::none);
  EXPECT_EQ(p.macrostep.to.velocity[0], 0.4);
  command.joints = one(-1.99);  // no room for a run-up: ends at rest
  EXPECT_EQ(p.plan(command, DesiredState::resting_at(one(-1.98)), Pace::stretched).code, ErrorCode::none);
  EXPECT_TRUE(p.macrostep.to.at_rest());
  command.joints = one(3);  // no duration is long enough
  EXPECT_EQ(p.plan(command, from, Pace::stretched).code, ErrorCode::joint_limit);
}

}  // namespace
}  // namespace mrroc::edp::planner_test
