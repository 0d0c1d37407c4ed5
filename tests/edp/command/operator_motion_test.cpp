#include "edp/command/operator_motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>
#include <random>

#include "edp/rig.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {
namespace {

constexpr Tick kValid = 100;  // ticks of a jog
constexpr double kTolerance = 1e-6;

/// A gantry under the operator's orders; every set-point is compared with the limits.
class Operated : public Rig<Gantry> {
 public:
  explicit Operated(bool synchronised = true) : Rig(true, synchronised) {
    Rig::run(5);
    previous_ = seen().desired;
  }

  void tick() {
    servo.tick(now);
    Reply reply;
    while (effector.poll(reply)) {
      if (!OperatorMotion::is_own(reply.command))
        replies.push_back(reply);
      else if (motion.take(reply))
        answers.push_back(reply);
    }
    if (motion.update(seen().tick, reply)) answers.push_back(reply);
    if (motion.poll_hold(seen().tick, reply)) replies.push_back(reply);
    ++now;
    check_limits();
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  /// An order at the present tick; an answer that comes at once is appended to `answers`.
  std::uint64_t give(const RobotCommand& command) {
    Reply reply;
    if (motion.accept(command, ++orders, seen().tick, reply)) answers.push_back(reply);
    return orders;
  }
  void task_command(const RobotCommand& command) {
    if (motion.accept_of_task(command, number + 1, seen().tick))
      ++number;
    else if (send(command))
      replies.push_back(answer);
  }
  ErrorCode last_error() const { return answers.empty() ? ErrorCode::none : answers.back().state.error.code; }
  const JointVector& position() const { return seen().desired.position; }
  const JointVector& velocity() const { return seen().desired.velocity; }
  bool at_rest() const { return seen().desired.at_rest(); }

  OperatorMotion motion{effector, models, kPeriod};
  std::vector<Reply> answers;
  std::uint64_t orders = 0;

 private:
  void check_limits() {
    const DesiredState& desired = seen().desired;
    if (seen().enabled() && seen().synchronised) {
      for (Eigen::Index i = 0; i < desired.position.size(); ++i) {
        const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
        EXPECT_LE(desired.position[i], axis.position_max + kTolerance) << seen().tick;
        EXPECT_GE(desired.position[i], axis.position_min - kTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.velocity[i]), axis.velocity_max + kTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.acceleration[i]), axis.acceleration_max + kTolerance) << seen().tick;
        EXPECT_LE(std::abs(desired.acceleration[i] - previous_.acceleration[i]), axis.jerk_max * kPeriod + kTolerance);
      }
    }
    previous_ = desired;
  }

  DesiredState previous_;
};

JointVector axis(int index, double value) {
  JointVector values = JointVector::Zero(4);
  values[index] = value;
  return values;
}

RobotCommand jog(int index, double velocity) {
  RobotCommand command;
  command.kind = CommandKind::joint_velocity;
  command.joint_velocity = axis(index, velocity);
  return command;
}

RobotCommand order(CommandKind kind) {
  RobotCommand command;
  command.kind = kind;
  return command;
}

RobotCommand go(const JointVector& joints, bool relative = false) {
  RobotCommand command = order(CommandKind::joint);
  command.joints = joints;
  command.relative = relative;
  return command;
}

/// Ticks from 0.5 m/s to rest under the limits of the axes.
Tick braking_ticks(double velocity) {
  const AxisParameters axis = Gantry().parameters().axes[0];
  AxisStop stop;
  stop.plan(0, velocity, 0, axis.acceleration_max, axis.jerk_max);
  return static_cast<Tick>(std::ceil(stop.duration() / kPeriod)) + 1;
}

TEST(OperatorMotion, JogMovesAtOnceAndStopsWhenNoOtherComes) {
  Operated robot;
  const Tick begin = robot.seen().tick;
  robot.give(jog(0, 0.5));
  EXPECT_EQ(robot.answers.size(), 1U);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(OperatorMotion::kSteps);
  EXPECT_GT(robot.velocity()[0], 0) << "within a macrostep";
  while (robot.seen().tick < begin + kValid) {
    robot.tick();
    EXPECT_GT(robot.velocity()[0], 0);
  }
  robot.run(braking_ticks(0.5));
  EXPECT_TRUE(robot.at_rest()) << "the validity and the braking time have passed";
  EXPECT_EQ(robot.effector.counters().late, 0U);
}

TEST(OperatorMotion, RepeatedJogKeepsItsVelocityAndTakesANewOne) {
  Operated robot;
  for (int i = 0; i < 10; ++i) {
    robot.give(jog(0, 0.2));
    robot.run(25);
    if (i > 3) {
      EXPECT_NEAR(robot.velocity()[0], 0.2, 1e-9);
    }
  }
  robot.give(jog(1, -0.1));
  robot.run(80);
  EXPECT_NEAR(robot.velocity()[0], 0, 1e-9);
  EXPECT_NEAR(robot.velocity()[1], -0.1, 1e-9);
  robot.give(order(CommandKind::hold));
  robot.run(40);
  EXPECT_TRUE(robot.at_rest());
}

TEST(OperatorMotion, JogEndsBeforeALimitAndLeavesIt) {
  Operated robot;
  const double limit = robot.model.parameters().axes[0].position_max;
  for (int i = 0; i < 400; ++i) {
    robot.give(jog(0, 0.5));
    robot.run(20);
  }
  EXPECT_TRUE(robot.at_rest());
  EXPECT_NEAR(robot.position()[0], limit, 0.01);
  EXPECT_NE(robot.last_error(), ErrorCode::none) << "there it goes no farther";
  robot.give(jog(0, -0.5));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(50);
  EXPECT_LT(robot.velocity()[0], 0);
}

TEST(OperatorMotion, TravelReachesItsGoalExactly) {
  Operated robot;
  JointVector goal(4);
  goal << 0.4, -0.2, 0.1, 0.7;
  const std::uint64_t number = robot.give(go(goal));
  EXPECT_TRUE(robot.answers.empty());
  for (Tick i = 0; robot.answers.empty() && i < 5000; ++i) robot.tick();
  ASSERT_EQ(robot.answers.size(), 1U);
  EXPECT_EQ(robot.answers[0].command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  EXPECT_EQ(robot.position(), goal);
  EXPECT_TRUE(robot.at_rest());
  EXPECT_EQ(robot.effector.counters().late, 0U);
  robot.give(go(goal));
  robot.run(50);
  EXPECT_EQ(robot.answers.size(), 2U) << "it is there";
  robot.give(go(axis(2, -0.05), true));
  robot.run(1000);
  EXPECT_NEAR(robot.position()[2], 0.05, 1e-12);
}

TEST(OperatorMotion, ToolStepIsInToolAxesAndBaseStepInBaseAxes) {
  Operated robot;
  robot.give(go(axis(3, 1.0)));
  robot.run(3000);
  RobotCommand step = order(CommandKind::pose);
  step.relative = true;
  step.interpolation = Interpolation::task;
  step.pose.translation().x() = 0.1;
  robot.give(step);
  robot.run(1000);
  EXPECT_NEAR(robot.position()[0], 0.1 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(robot.position()[1], 0.1 * std::sin(1.0), 1e-9);
  step.pose = Pose::Identity();
  step.twist << -0.1, 0, 0, 0, 0, -0.5;
  robot.give(step);
  robot.run(2000);
  EXPECT_NEAR(robot.position()[0], 0.1 * std::cos(1.0) - 0.1, 1e-9);
  EXPECT_NEAR(robot.position()[1], 0.1 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(robot.position()[3], 0.5, 1e-9);
  for (const Reply& answer : robot.answers) EXPECT_EQ(answer.state.error.code, ErrorCode::none);
}

TEST(OperatorMotion, GoalBeyondALimitIsRefusedBeforeTheRobotMoves) {
  Operated robot;
  robot.give(go(axis(0, 100)));
  EXPECT_EQ(robot.last_error(), ErrorCode::joint_limit);
  robot.give(go(axis(0, std::nan(""))));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_finite);
  robot.give(jog(0, std::nan("")));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_finite);
  robot.run(100);
  EXPECT_EQ(robot.answers.size(), 3U);
  EXPECT_EQ(robot.position()[0], 0);
}

TEST(OperatorMotion, HoldEndsATravelAndAnswersIt) {
  Operated robot;
  const std::uint64_t number = robot.give(go(axis(0, 0.4)));
  robot.run(60);
  EXPECT_GT(robot.velocity()[0], 0);
  robot.give(jog(0, 0.1));
  EXPECT_EQ(robot.last_error(), ErrorCode::busy);
  robot.give(order(CommandKind::hold));
  robot.run(2 * OperatorMotion::kSteps + braking_ticks(1));
  EXPECT_TRUE(robot.at_rest());
  EXPECT_EQ(robot.answers.back().command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::busy);
  robot.give(go(axis(0, 0.4)));
  robot.run(2000);
  EXPECT_EQ(robot.position()[0], 0.4);
}

TEST(OperatorMotion, TaskTakesTheRobotAndHasItUntilItIsIdle) {
  Operated robot;
  robot.give(jog(0, 0.3));
  robot.run(50);
  RobotCommand command = joint_command(axis(0, 0.3), 500, 500);
  robot.task_command(command);
  robot.give(jog(0, 0.3));
  EXPECT_EQ(robot.last_error(), ErrorCode::busy);
  robot.run(1500);
  ASSERT_EQ(robot.replies.size(), 1U);
  EXPECT_EQ(robot.replies[0].state.error.code, ErrorCode::none) << "it is planned from the end of the braking";
  EXPECT_EQ(robot.position()[0], 0.3);
  robot.give(jog(0, -0.3));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
}

/// The task of a pause: holds, one after the other.
void hold_for(
    Operated& robot, int macrosteps, const std::function<void()>& each = [] {}) {
  for (int i = 0; i < macrosteps; ++i) {
    RobotCommand hold = order(CommandKind::hold);
    hold.motion_steps = 10;
    hold.reply_step = 8;
    const std::size_t before = robot.replies.size();
    robot.task_command(hold);
    each();
    for (int tick = 0; tick < 40 && robot.replies.size() == before; ++tick) robot.tick();
    ASSERT_EQ(robot.replies.size(), before + 1) << "every hold is answered";
    EXPECT_EQ(robot.replies.back().state.error.code, ErrorCode::none);
  }
}

TEST(OperatorMotion, RobotOfAPausedTaskJogsAndItsHoldsAreAnswered) {
  Operated robot;
  hold_for(robot, 5);
  robot.give(jog(0, 0.3));
  EXPECT_EQ(robot.last_error(), ErrorCode::busy) << "the task is not paused";
  RobotCommand paused = jog(0, 0.3);
  paused.choice = OperatorMotion::kTaskPaused;
  hold_for(robot, 40, [&] { robot.give(paused); });
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  EXPECT_NEAR(robot.velocity()[0], 0.3, 1e-9);
  EXPECT_FALSE(robot.replies.back().state.at_rest()) << "the task sees that the robot moves";
  hold_for(robot, 40);
  EXPECT_TRUE(robot.replies.back().state.at_rest());
  paused = go(axis(0, 0.1));
  paused.choice = OperatorMotion::kTaskPaused;
  robot.give(paused);
  hold_for(robot, 100);
  EXPECT_EQ(robot.position()[0], 0.1);
  EXPECT_EQ(robot.effector.counters().late, 0U);
  robot.task_command(joint_command(axis(0, 0.3), 500, 500));
  robot.run(1500);
  EXPECT_EQ(robot.replies.back().state.error.code, ErrorCode::none);
  EXPECT_EQ(robot.position()[0], 0.3);
}

RobotCommand motor_jog(int index, double velocity) {
  RobotCommand command = order(CommandKind::motor);
  command.joint_velocity = axis(index, velocity);
  return command;
}

TEST(OperatorMotion, MotorJogMovesTheJointsOfASynchronisedRobot) {
  Operated robot;
  robot.give(motor_jog(1, 10));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(50);
  EXPECT_NEAR(robot.velocity()[1], 10 / GearedModel::kGear, 1e-9);
}

TEST(OperatorMotion, RobotThatIsNotSynchronisedTakesMotorJogsOnly) {
  Operated robot(false);
  robot.give(go(axis(0, 0.1)));
  EXPECT_EQ(robot.last_error(), ErrorCode::not_synchronised);
  RobotCommand twist = order(CommandKind::twist);
  twist.twist[0] = 0.1;
  robot.give(twist);
  EXPECT_EQ(robot.last_error(), ErrorCode::not_synchronised);
  const double before = robot.position()[1];
  robot.give(motor_jog(1, 3));
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.run(400);
  EXPECT_GT(robot.position()[1], before);
  EXPECT_TRUE(robot.at_rest());
}

TEST(OperatorMotion, EmergencyStopEndsAJogAndRecoveryAllowsTheNext) {
  Operated robot;
  robot.give(jog(0, 0.3));
  robot.run(50);
  robot.operators.press();
  robot.run(300);
  robot.give(jog(0, 0.3));
  EXPECT_NE(robot.last_error(), ErrorCode::none);
  robot.operators.reset();
  robot.run(5);
  const std::uint64_t number = robot.give(order(CommandKind::recover));
  robot.run(300);
  EXPECT_EQ(robot.answers.back().command, number);
  EXPECT_EQ(robot.last_error(), ErrorCode::none);
  robot.give(jog(0, -0.3));
  robot.run(50);
  EXPECT_LT(robot.velocity()[0], 0);
}

TEST(OperatorMotion, OneOutputChangesAndTheOthersStay) {
  Operated robot;
  RobotCommand set = order(CommandKind::set_outputs);
  set.choice = 3;
  set.outputs.set(3, true);
  robot.give(set);
  robot.run(5);
  set.choice = ControllerIo::kDigital + 2;
  set.outputs = {};
  set.outputs.analog[2] = 1.5;
  robot.give(set);
  robot.run(5);
  const ControllerIo outputs = robot.query().outputs;
  EXPECT_TRUE(outputs.on(3));
  EXPECT_EQ(outputs.analog[2], 1.5);
}

/// Any orders at any time: the limits hold in every tick, every order gets one answer, the robot comes to rest.
TEST(OperatorMotion, RandomOrdersKeepTheLimits) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto chance = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    Operated robot;
    for (int i = 0; i < 60; ++i) {
      const int index = static_cast<int>(random() % 4);
      switch (random() % 8) {
        case 0:
        case 1:
        case 2:
          robot.give(jog(index, chance(-1.2, 1.2)));
          break;
        case 3: {
          RobotCommand twist = order(CommandKind::twist);
          twist.relative = random() % 2 == 0;
          twist.twist[static_cast<Eigen::Index>(random() % 3)] = chance(-0.5, 0.5);
          robot.give(twist);
          break;
        }
        case 4:
          robot.give(go(axis(index, chance(-0.6, 0.6))));
          break;
        case 5:
          robot.give(go(axis(index, chance(-0.2, 0.2)), true));
          break;
        case 6:
          robot.give(order(CommandKind::hold));
          break;
        default:
          if (random() % 3 == 0) robot.task_command(joint_command(robot.position(), 50, 40));
          break;
      }
      robot.run(static_cast<Tick>(random() % 120));
    }
    robot.run(5000);
    RC_ASSERT(robot.at_rest());
    RC_ASSERT(robot.seen().fault.code == ErrorCode::none);
    std::vector<std::uint64_t> answered;
    for (const Reply& answer : robot.answers) answered.push_back(answer.command);
    std::sort(answered.begin(), answered.end());
    RC_ASSERT(answered.size() == robot.orders);
    RC_ASSERT(std::adjacent_find(answered.begin(), answered.end()) == answered.end());
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

}  // namespace
}  // namespace mrroc::edp
