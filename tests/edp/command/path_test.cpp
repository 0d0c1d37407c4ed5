#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "edp/random_values.hpp"
#include "edp/test_robots.hpp"
#include "language/macrostep/macrostep_path.hpp"

namespace mrroc::edp::path_test {
namespace {

constexpr double kServoPeriod = 0.002;

JointVector arm_joints() { return (JointVector(2) << number(-1, 1), number(0.5, 1.2)).finished(); }

DesiredState moving(const JointVector& position, double speed) {
  const auto count = static_cast<int>(position.size());
  return {position, random_vector(count, speed), random_vector(count, speed)};
}

/// Follows the path tick by tick as the servo does; `look` receives every state.
template <class Check>
void follow(const MacrostepPath& path, const DesiredState& from, int steps, Check check) {
  DesiredState state = from;
  for (int k = 1; k <= steps; ++k) {
    DesiredState next;
    RC_ASSERT(path.at(k * kServoPeriod, state.position, next) == ErrorCode::none);
    check(k, state, next);
    state = next;
  }
}

TEST(MacrostepPath, ShaftsFollowTheirQuinticInMotorSpace) {
  EXPECT_TRUE(rc::check([] {
    Slide model;
    const DesiredState from = moving(random_vector(1, 0.5), 0.2), to = moving(random_vector(1, 0.5), 0.2);
    const int steps = 200;
    MacrostepPath joints, motors;
    joints.plan_joints(from, to, steps * kServoPeriod);
    RC_ASSERT(motors.plan_motors(model, from, to, steps * kServoPeriod, kServoPeriod) == ErrorCode::none);
    follow(motors, from, steps, [&](int k, const DesiredState&, const DesiredState& now) {
      DesiredState same;  // the gear is constant: both spaces have the same paths
      joints.at(k * kServoPeriod, now.position, same);
      RC_ASSERT((now.position - same.position).norm() < 1e-12);
      RC_ASSERT((now.velocity - same.velocity).norm() < 1e-4);
      RC_ASSERT((now.acceleration - same.acceleration).norm() < 1e-2);
    });
  }));
}

TEST(MacrostepPath, ToolMovesStraightAndTurnsAboutOneAxisInTaskSpace) {
  EXPECT_TRUE(rc::check([] {
    Gantry model;
    Pose tool = Pose::Identity();
    tool.translation() = Eigen::Vector3d(0.1, 0.2, -0.1);
    const ToolKinematics kinematics(model, tool);
    const DesiredState from = DesiredState::resting_at(random_vector(4, 0.5));
    MovingPose to;
    to.pose = kinematics.direct(from.position + random_vector(4, 0.5));
    const int steps = 300;
    MacrostepPath path;
    RC_ASSERT(path.plan_task(kinematics, from, to, steps * kServoPeriod, kServoPeriod) == ErrorCode::none);
    const Eigen::Vector3d start = kinematics.direct(from.position).translation();
    const Eigen::Vector3d way = to.pose.translation() - start;
    RC_PRE(way.norm() > 1e-3);
    JointVector last;
    follow(path, from, steps, [&](int, const DesiredState&, const DesiredState& now) {
      const Eigen::Vector3d gone = kinematics.direct(now.position).translation() - start;
      RC_ASSERT((gone - gone.dot(way) / way.squaredNorm() * way).norm() < 1e-12);
      last = now.position;
    });
    RC_ASSERT(kinematics.direct(last).isApprox(to.pose, 1e-12));
  }));
}

TEST(MacrostepPath, TaskSpacePathContinuesTheMotionOfTheJoints) {
  EXPECT_TRUE(rc::check([] {
    PlanarArm model;
    const ToolKinematics kinematics(model);
    const DesiredState from = moving(arm_joints(), 0.3), to = moving(from.position + random_vector(2, 0.1), 0.3);
    MacrostepPath path;
    const MovingPose goal = tool_motion(kinematics, to, MacrostepPath::kDifference * kServoPeriod);
    RC_ASSERT(path.plan_task(kinematics, from, goal, 0.4, kServoPeriod) == ErrorCode::none);
    for (const double t : {0.0, 0.4}) {
      const DesiredState& expected = t == 0.0 ? from : to;
      DesiredState state;
      RC_ASSERT(path.at(t, expected.position, state) == ErrorCode::none);
      RC_ASSERT((state.position - expected.position).norm() < 1e-9);
      RC_ASSERT((state.velocity - expected.velocity).norm() < 1e-4);
      RC_ASSERT((state.acceleration - expected.acceleration).norm() < 1e-2);
    }
  }));
}

TEST(MacrostepPath, AVelocityIsReachedUnderTheLimitsAndKept) {
  EXPECT_TRUE(rc::check([] {
    Gantry model;
    const auto& axes = model.parameters().axes;
    DesiredState from = DesiredState::resting_at(random_vector(4, 0.5));
    from.velocity = random_vector(4, 0.5);
    const JointVector wanted = random_vector(4, 0.5);
    MacrostepPath path;
    path.plan_velocity(model.parameters(), from, wanted);
    follow(path, from, 500, [&](int, const DesiredState& before, const DesiredState& now) {
      for (int i = 0; i < 4; ++i) {
        const auto& axis = axes[static_cast<std::size_t>(i)];
        RC_ASSERT(std::abs(now.acceleration[i]) <= axis.acceleration_max * (1 + 1e-9));
        RC_ASSERT(std::abs(now.acceleration[i] - before.acceleration[i]) <= axis.jerk_max * kServoPeriod * (1 + 1e-6));
        const double way = now.position[i] - before.position[i];
        RC_ASSERT(std::abs(way - 0.5 * kServoPeriod * (now.velocity[i] + before.velocity[i])) < 1e-5);
      }
    });
    DesiredState end;
    path.at(1.0, from.position, end);
    RC_ASSERT(end.velocity == wanted);
    RC_ASSERT(end.acceleration.isZero(0));
  }));
}

TEST(MacrostepPath, RefusesAToolThatWouldTurnTooFar) {
  Gantry model;
  const ToolKinematics kinematics(model);
  JointVector target = JointVector::Zero(4);
  MovingPose to;
  MacrostepPath path;
  target[3] = 2.9;
  to.pose = kinematics.direct(target);
  const DesiredState from = DesiredState::resting_at(JointVector::Zero(4));
  EXPECT_EQ(path.plan_task(kinematics, from, to, 1, kServoPeriod), ErrorCode::none);
  target[3] = 3.1;
  to.pose = kinematics.direct(target);
  EXPECT_EQ(path.plan_task(kinematics, from, to, 1, kServoPeriod), ErrorCode::invalid_argument);
}

TEST(MacrostepPath, EndsAtTheInverseKinematics) {
  PlanarArm model;
  const ToolKinematics kinematics(model);
  const DesiredState from = DesiredState::resting_at((JointVector(2) << 0.3, 1.0).finished());
  // on the arm's plane positions determine the orientation: a line that keeps the orientation leaves the workspace
  MovingPose to;
  to.pose = kinematics.direct(from.position);
  to.pose.translation().x() += 0.1;
  MacrostepPath path;
  ASSERT_EQ(path.plan_task(kinematics, from, to, 0.2, kServoPeriod), ErrorCode::none);
  DesiredState state;
  EXPECT_EQ(path.at(0.1, from.position, state), ErrorCode::out_of_workspace);
}

}  // namespace
}  // namespace mrroc::edp::path_test
