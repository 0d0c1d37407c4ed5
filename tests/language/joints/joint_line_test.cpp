#include <cmath>
#include <limits>

#include "language/joints/joint_line_cell.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/property.hpp"

namespace mrroc::joint_line::joint_line_test {
namespace {

using fakes::check_property;

TEST(JointLine, MovesStraightToItsTargetWithinTheScaledLimits) {
  check_property(kCases, [] {
    Cell cell;
    const JointVector target = random_joints(cell.axes);
    const double speed = random_speed();
    JointLine line(*cell.arm, target, speed);
    const Outcome end = Move({*cell.arm}, {}, line);
    RC_ASSERT(end.ending == Ending::generator);
    const JointVector way = target - cell.home;
    if (way.norm() == 0) return RC_ASSERT(end.steps == 0u);
    assert_ends_at(cell, target);
    const auto path = samples(cell.recorder);
    assert_within_limits(cell, path, speed);
    for (const Sample& sample : path) {
      const double fraction = (sample.position - cell.home).dot(way) / way.squaredNorm();
      RC_ASSERT(fraction >= -1e-9);
      RC_ASSERT(fraction <= 1 + 1e-9);
      RC_ASSERT((sample.position - cell.home - fraction * way).norm() < 1e-9);
    }
    const double steps = line.duration() / cell.arm->step_duration();
    RC_ASSERT(static_cast<double>(end.steps) >= steps - 1e-6);
    RC_ASSERT(static_cast<double>(end.steps) < steps + 1);
  });
}

TEST(JointLine, TakesTheMinimumTimeUnderTheLimits) {
  FakeTask task;
  const auto arm = task.robot("arm", 1);
  // far enough for the full velocity: distance / v + v / a + a / j, with the shares that the interpolation permits
  JointLine line(*arm, JointVector::Constant(1, 1.5), 1.0);
  Move({*arm}, {}, line);
  EXPECT_NEAR(line.duration(), 1.5 / 0.99 + 0.99 / 3.6 + 3.6 / 18.0, 1e-9);
}

TEST(JointLine, SpeedOnlyStretchesTime) {
  check_property(kCases, [] {
    Cell cell;
    const JointVector target = random_joints(cell.axes);
    JointLine fast(*cell.arm, target, 1.0);
    Wait({*cell.arm}, {}, ElapsedSteps{0});
    fast.start();
    const double speed = random_speed();
    JointLine slow(*cell.arm, target, speed);
    slow.start();
    RC_ASSERT(std::abs(slow.duration() * speed - fast.duration()) < 1e-6);
  });
}

TEST(JointLine, EverySpeedOnlyStretchesTime) {
  check_property(kCases, [] {
    Cell cell;
    Wait({*cell.arm}, {}, ElapsedSteps{0});
    const JointVector target = random_target(*cell.arm, cell.axes);
    JointLine fast(*cell.arm, target, 1.0);
    fast.start();
    const double speed = std::pow(10, -0.1 * pick(0, 60));
    JointLine slow(*cell.arm, target, speed);
    slow.start();
    RC_ASSERT(std::abs(slow.duration() * speed - fast.duration()) < 1e-6);
  });
}

TEST(JointLine, ContinuesFromRestToTheSameTargetAfterAPause) {
  check_property(kCases, [] {
    Cell cell;
    const JointVector target = random_joints(cell.axes);
    cell.task.requests.assign(static_cast<std::size_t>(pick(1, 60)), OperatorRequest::none);
    cell.task.requests.insert(cell.task.requests.end(), 3, OperatorRequest::pause);
    const Outcome end = Move({*cell.arm}, {}, JointLine(*cell.arm, target, random_speed()));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(cell.arm->state().desired_joints == (end.steps == 0 ? cell.home : target));
    RC_ASSERT(cell.arm->state().desired_velocity.isZero());
  });
}

TEST(JointLine, MotionOfAWholeNumberOfStepsEndsAtRest) {
  FakeTask task;
  MotionRecorder recorder;
  task.step_observer = &recorder;
  const auto arm = task.robot("arm", 1);
  // with full jerk only, the duration is 4 (d / 2j)^(1/3): choose d so that it is exactly 20 steps of 20 ms
  const double d = 2 * (0.45 * 40) * std::pow(0.4 / 4, 3);
  JointLine line(*arm, JointVector::Constant(1, d), 1.0);
  const Outcome end = Move({*arm}, {}, line);
  EXPECT_NEAR(line.duration(), 0.4, 1e-9);
  EXPECT_EQ(end.steps, 20u);
  EXPECT_EQ(recorder.commands.back().joints[0], d);
  EXPECT_EQ(recorder.commands.back().joint_velocity.size(), 0);
}

TEST(JointLine, ReachesAPoseThroughTheInverseKinematics) {
  FakeTask task;
  const auto arm = task.robot("arm", 4);
  Pose pose = Pose::Identity();
  pose.translation() << 0.3, -0.2, 0.5;
  pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Move({*arm}, {}, JointLine(*arm, pose));
  EXPECT_TRUE(arm->state().desired_joints.isApprox(Eigen::Vector4d(0.3, -0.2, 0.5, 0.7), 1e-12));

  pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()).toRotationMatrix();
  try {
    Move({*arm}, {}, JointLine(*arm, pose));
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::out_of_workspace);
    EXPECT_EQ(error.origin().device, "arm");
  }
  pose = Pose::Identity();
  pose.translation().x() = 2.5;
  try {
    Move({*arm}, {}, JointLine(*arm, pose));
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::joint_limit);
  }
}

ErrorCode refusal(Robot& robot, const JointVector& target, double speed = 0.5) {
  try {
    JointLine line(robot, target, speed);
  } catch (const NonFatalError& error) {
    return error.code();
  }
  return ErrorCode::none;
}

TEST(JointLine, RefusesInvalidTargets) {
  FakeTask task;
  const auto arm = task.robot("arm", 3);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(*arm, Eigen::Vector3d(0, 0, 2)), ErrorCode::none);
  EXPECT_EQ(refusal(*arm, JointVector::Zero(2)), ErrorCode::invalid_argument);
  EXPECT_EQ(refusal(*arm, JointVector::Zero(4)), ErrorCode::invalid_argument);
  EXPECT_EQ(refusal(*arm, JointVector{}), ErrorCode::invalid_argument);
  EXPECT_EQ(refusal(*arm, Eigen::Vector3d(0, kNan, 0)), ErrorCode::not_finite);
  EXPECT_EQ(refusal(*arm, Eigen::Vector3d(0, 0, -kInfinity)), ErrorCode::not_finite);
  EXPECT_EQ(refusal(*arm, Eigen::Vector3d(0, 0, 2.001)), ErrorCode::joint_limit);
  EXPECT_EQ(refusal(*arm, Eigen::Vector3d(-2.001, 0, 0)), ErrorCode::joint_limit);
  for (const double speed : {0.0, -0.1, 1.001, 0.9e-6, 1e-300, kNan, kInfinity}) {
    EXPECT_EQ(refusal(*arm, JointVector::Zero(3), speed), ErrorCode::invalid_argument) << speed;
  }
  EXPECT_EQ(refusal(*arm, JointVector::Zero(3), 1.0), ErrorCode::none);
  EXPECT_EQ(refusal(*arm, JointVector::Zero(3), 1e-6), ErrorCode::none);
  Pose pose = Pose::Identity();
  pose.translation().x() = kNan;
  EXPECT_THROW(JointLine(*arm, pose), NonFatalError);
}

TEST(JointLine, RefusesARobotThatIsNotInTheList) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  try {
    Move({*right}, {}, JointLine(*left, JointVector::Zero(6)));
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_EQ(error.origin().device, "left");
  }
}

}  // namespace
}  // namespace mrroc::joint_line::joint_line_test
