#include "mrroc/generators/tool_velocity.hpp"

#include <limits>

#include "language/fakes.hpp"
#include "language/motion_recorder.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::tool_velocity_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FakeTask;
using fakes::MotionRecorder;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 500;

/// One robot with its tool at a random position and orientation, and a recorded ToolVelocity.
struct Cell {
  Cell() : arm(task.robot("arm", 4)) {
    RobotState& state = task.robot_fake("arm").state;
    state.desired_joints << random_vector(1), 0.01 * pick(-300, 300);
    state.desired_pose = start = arm->kinematics().direct(state.desired_joints);
    const auto motion_steps = static_cast<std::uint16_t>(pick(1, 20));
    arm->set_macrostep(motion_steps, motion_steps);
    task.step_observer = &recorder;
  }
  void move(const Vector3d& linear, const Vector3d& angular, double acceleration, std::uint64_t steps) {
    Move({*arm}, {}, ToolVelocity(*arm, linear, angular, acceleration).until(ElapsedSteps{steps}));
  }
  double dt() const { return arm->step_duration(); }

  FakeTask task;
  std::unique_ptr<Robot> arm;
  Pose start;
  MotionRecorder recorder;
};

/// The twist of a command in the axes of its own tool pose.
Twist in_tool(const RobotCommand& command) {
  const Eigen::Matrix3d back = command.pose.linear().transpose();
  Twist twist;
  twist << back * command.twist.head<3>(), back * command.twist.tail<3>();
  return twist;
}

TEST(ToolVelocity, LinearMotionIsAStraightLineWithoutRotation) {
  check_property(kCases, [] {
    Cell cell;
    const Vector3d linear = random_vector(0.5);
    const double acceleration = 0.01 * pick(1, 200);
    cell.move(linear, Vector3d::Zero(), acceleration, static_cast<std::uint64_t>(pick(1, 60)));
    const Vector3d direction = cell.start.linear() * linear.normalized();
    double along = 0;
    for (const RobotCommand& command : cell.recorder.commands) {
      RC_ASSERT(command.kind == CommandKind::pose);
      RC_ASSERT(command.pose.linear().isApprox(cell.start.linear(), 1e-12));
      const Vector3d way = command.pose.translation() - cell.start.translation();
      RC_ASSERT((way - way.dot(direction) * direction).norm() < 1e-12);
      RC_ASSERT(way.dot(direction) >= along - 1e-12);
      along = way.dot(direction);
    }
  });
}

/// u^2 (3 - 2u), u = t / ramp.
double blend(double t, double ramp) {
  const double u = std::min(t / ramp, 1.0);
  return u * u * (3 - 2 * u);
}

/// The duration of a ramp by `change`, in whole macrosteps of `dt`.
double ramp_of(double change, double acceleration, double dt) {
  const double ramp = std::max(1.5 * change / acceleration, std::sqrt(0.6 * change / acceleration));
  return dt * std::ceil(ramp / dt - 1e-9);
}

TEST(ToolVelocity, TheSpeedRisesSmoothlyAtTheAccelerationAndStays) {
  check_property(kCases, [] {
    Cell cell;
    Twist target;
    target << random_vector(0.5), random_vector(1);
    const double acceleration = 0.01 * pick(1, 200);
    cell.move(target.head<3>(), target.tail<3>(), acceleration, static_cast<std::uint64_t>(pick(1, 60)));
    const double whole = std::max(target.head<3>().norm(), target.tail<3>().norm());
    const double ramp = ramp_of(whole, acceleration, cell.dt());
    std::size_t k = 0;
    for (const RobotCommand& command : cell.recorder.commands) {
      const double reached = whole == 0 ? 1 : blend(static_cast<double>(++k) * cell.dt(), ramp);
      RC_ASSERT((in_tool(command) - reached * target).norm() < 1e-9);
    }
  });
}

TEST(ToolVelocity, TwistIsThePosesDerivativeAndItsRateTheTwists) {
  check_property(kCases, [] {
    Cell cell;
    cell.arm->set_macrostep(1, 1);
    const double acceleration = 0.01 * pick(10, 100);
    cell.move(random_vector(0.5), random_vector(1), acceleration, static_cast<std::uint64_t>(pick(3, 200)));
    const auto& commands = cell.recorder.commands;
    const double dt = cell.dt();
    for (std::size_t k = 1; k + 1 < commands.size(); ++k) {
      RC_ASSERT((commands[k].pose.linear() * commands[k].pose.linear().transpose()).isIdentity(1e-12));
      const Vector3d way = commands[k + 1].pose.translation() - commands[k - 1].pose.translation();
      const Eigen::AngleAxisd turn(commands[k + 1].pose.linear() * commands[k - 1].pose.linear().transpose());
      RC_ASSERT((way / (2 * dt) - commands[k].twist.head<3>()).norm() < 1e-4);
      RC_ASSERT((turn.angle() * turn.axis() / (2 * dt) - commands[k].twist.tail<3>()).norm() < 1e-4);
      // the rate has a corner at the end of the ramp
      const Twist change = commands[k + 1].twist - commands[k - 1].twist;
      RC_ASSERT((change / (2 * dt) - commands[k].twist_acceleration).norm() < 20 * acceleration * dt);
    }
  });
}

/// The twist rate of a command in the axes of its own tool pose.
Twist rate_in_tool(const RobotCommand& command) {
  const Twist twist = in_tool(command);
  const Eigen::Matrix3d back = command.pose.linear().transpose();
  Twist rate;
  rate << back * command.twist_acceleration.head<3>() - twist.tail<3>().cross(twist.head<3>()),
      back * command.twist_acceleration.tail<3>();
  return rate;
}

double larger_norm(const Twist& twist) { return std::max(twist.head<3>().norm(), twist.tail<3>().norm()); }

TEST(ToolVelocity, SpeedAndAccelerationAreContinuousFromAPresentMotion) {
  check_property(kCases, [] {
    Cell cell;
    RobotState& state = cell.task.robot_fake("arm").state;
    state.desired_velocity << random_vector(0.3), 0.01 * pick(-50, 50);
    state.desired_acceleration << random_vector(0.3), 0.01 * pick(-50, 50);
    const double acceleration = 0.01 * pick(50, 200);
    const Eigen::Matrix3d back = cell.start.linear().transpose();
    Twist before, rate;
    before << back * state.desired_velocity.head<3>(), 0, 0, state.desired_velocity[3];
    rate << back * state.desired_acceleration.head<3>() - before.tail<3>().cross(before.head<3>()), 0, 0,
        state.desired_acceleration[3];
    const double most = std::max(acceleration, larger_norm(rate));
    Twist target;
    target << random_vector(0.5), 0, 0, 0.01 * pick(-100, 100);
    cell.move(target.head<3>(), target.tail<3>(), acceleration, static_cast<std::uint64_t>(12 / cell.dt()));
    for (const RobotCommand& command : cell.recorder.commands) {
      const Twist now = in_tool(command), rate_now = rate_in_tool(command);
      RC_ASSERT(larger_norm(now - before) <= most * cell.dt() * (1 + 1e-4) + 1e-9);
      RC_ASSERT(larger_norm(rate_now - rate) <= 10 * acceleration * cell.dt() * (1 + 1e-4) + 1e-9);
      // the twist is the integral of its rate, to the order of Simpson's end terms
      RC_ASSERT(larger_norm(now - before - 0.5 * cell.dt() * (rate + rate_now)) <=
                10 * acceleration * cell.dt() * cell.dt());
      before = now;
      rate = rate_now;
    }
    RC_ASSERT(larger_norm(before - target) < 1e-9);
    RC_ASSERT(larger_norm(rate) < 1e-9);
  });
}

TEST(ToolVelocity, RisesFromRestAgainAfterAPause) {
  FakeTask task;
  const auto arm = task.robot("arm");
  MotionRecorder recorder;
  task.step_observer = &recorder;
  task.requests = {OperatorRequest::none, OperatorRequest::none, OperatorRequest::pause};
  Move({*arm}, {}, ToolVelocity(*arm, Vector3d(0.1, 0, 0), Vector3d::Zero(), 1.0).until(ElapsedSteps{4}));
  ASSERT_EQ(recorder.commands.size(), 4u);
  const double ramp = ramp_of(0.1, 1.0, arm->step_duration());
  EXPECT_NEAR(recorder.commands[1].twist[0], 0.1 * blend(0.04, ramp), 1e-12);
  EXPECT_NEAR(recorder.commands[2].twist[0], 0.1 * blend(0.02, ramp), 1e-12);
}

TEST(ToolVelocity, RefusesInvalidArguments) {
  FakeTask task;
  const auto arm = task.robot("arm");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ToolVelocity(*arm, Vector3d(0, kNan, 0)), NonFatalError);
  EXPECT_THROW(ToolVelocity(*arm, Vector3d::Zero(), Vector3d(0, 0, kNan)), NonFatalError);
  for (const double acceleration : {0.0, -1.0, kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(ToolVelocity(*arm, Vector3d::UnitX(), Vector3d::Zero(), acceleration), NonFatalError);
  }
  const auto other = task.robot("other");
  EXPECT_THROW(Move({*other}, {}, ToolVelocity(*arm, Vector3d::UnitX()).until(ElapsedSteps{5})), NonFatalError);
}

}  // namespace
}  // namespace mrroc::tool_velocity_test
