#include "mrroc/generators/joint_line.hpp"

#include <cmath>
#include <limits>

#include "language/fakes.hpp"
#include "language/joint_targets.hpp"
#include "language/motion_recorder.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::MotionRecorder;
using fakes::pick;

constexpr int kCases = 500;

/// Positions from -1.9 to 1.9, the limits being +-2.
JointVector random_joints(int axes) {
  JointVector joints(axes);
  for (Eigen::Index i = 0; i < axes; ++i) joints[i] = 0.001 * pick(-1900, 1900);
  return joints;
}

double random_speed() { return 0.01 * pick(5, 100); }

/// A task with one robot at rest at random joints, with a random macrostep.
struct Cell {
  Cell() : axes(pick(1, kMaxJoints)), arm(task.robot("arm", axes)), home(random_joints(axes)) {
    task.robot_fake("arm").state.desired_joints = home;
    task.robot_fake("arm").state.desired_pose = arm->kinematics().direct(home);
    const auto motion_steps = static_cast<std::uint16_t>(pick(1, 40));
    arm->set_macrostep(motion_steps, static_cast<std::uint16_t>(pick(1, motion_steps)));
    task.step_observer = &recorder;
  }
  FakeTask task;
  int axes;
  std::unique_ptr<Robot> arm;
  JointVector home;
  MotionRecorder recorder;
};

struct Sample {
  JointVector position, velocity, acceleration;
};

/// The states at the boundaries of the macrosteps: where it started, and every commanded end.
std::vector<Sample> samples(const MotionRecorder& recorder) {
  std::vector<Sample> found;
  if (recorder.states.empty()) return found;
  const RobotState& start = recorder.states.front();
  found.push_back({start.desired_joints, start.desired_velocity, start.desired_acceleration});
  const auto axes = start.desired_joints.size();
  const auto full = [&](const JointVector& v) { return v.size() == 0 ? JointVector(JointVector::Zero(axes)) : v; };
  for (const RobotCommand& command : recorder.commands) {
    found.push_back({command.joints, full(command.joint_velocity), full(command.joint_acceleration)});
  }
  return found;
}

/// The scaled limits hold at the samples, and from each to the next nothing changes faster than they allow.
void assert_within_limits(const Cell& cell, const std::vector<Sample>& path, double speed) {
  const AxisParameters& axis = cell.arm->parameters().axes[0];
  const double dt = cell.arm->step_duration();
  const double v = axis.velocity_max * speed;
  const double a = axis.acceleration_max * speed * speed;
  const double j = axis.jerk_max * speed * speed * speed;
  constexpr double kTolerance = 1e-6;
  for (std::size_t k = 1; k < path.size(); ++k) {
    RC_ASSERT(path[k].velocity.cwiseAbs().maxCoeff() <= v + kTolerance);
    RC_ASSERT(path[k].acceleration.cwiseAbs().maxCoeff() <= a + kTolerance);
    RC_ASSERT((path[k].position - path[k - 1].position).cwiseAbs().maxCoeff() <= v * dt + kTolerance);
    RC_ASSERT((path[k].velocity - path[k - 1].velocity).cwiseAbs().maxCoeff() <= a * dt + kTolerance);
    RC_ASSERT((path[k].acceleration - path[k - 1].acceleration).cwiseAbs().maxCoeff() <= j * dt + kTolerance);
  }
}

void assert_ends_at(const Cell& cell, const JointVector& target) {
  const RobotCommand& last = cell.recorder.commands.back();
  RC_ASSERT(last.kind == CommandKind::joint);
  RC_ASSERT(last.joints == target);  // exactly, and at rest
  RC_ASSERT(last.joint_velocity.size() == 0);
  RC_ASSERT(last.joint_acceleration.size() == 0);
}

TEST(JointLine, GoesStraightToItsTargetWithinTheScaledLimits) {
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

TEST(JointLine, TakesTheLeastTimeThatTheLimitsAllow) {
  FakeTask task;
  const auto arm = task.robot("arm", 1);
  // far enough for the whole velocity: distance / v + v / a + a / j, with the shares that the interpolation leaves
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

/// Random joints, or some near to where `arm` is, ahead of it or behind it.
JointVector random_target(const Robot& arm, int axes) {
  if (pick(0, 1) == 0) return random_joints(axes);
  JointVector target = arm.state().desired_joints;
  for (Eigen::Index i = 0; i < axes; ++i) target[i] = std::clamp(target[i] + 0.001 * pick(-100, 100), -1.9, 1.9);
  return target;
}

/// Drives `cell` along a line and leaves it in motion, nothing of it recorded.
void set_in_motion(Cell& cell, double speed) {
  JointLine first(*cell.arm, random_joints(cell.axes), speed);
  first.until(ElapsedSteps{static_cast<std::uint64_t>(pick(1, 40))});
  Move({*cell.arm}, {}, first);
  cell.recorder.states.clear();
  cell.recorder.commands.clear();
}

TEST(JointLine, GoesOnFromAMotionUnderWay) {
  check_property(kCases, [] {
    Cell cell;
    const double speed = random_speed();
    set_in_motion(cell, speed);
    const JointVector target = random_target(*cell.arm, cell.axes);
    const double second_speed = std::min(1.0, speed + 0.01 * pick(0, 50));
    Move({*cell.arm}, {}, JointLine(*cell.arm, target, second_speed));
    if (cell.recorder.commands.empty()) return;  // it was there already
    assert_ends_at(cell, target);
    assert_within_limits(cell, samples(cell.recorder), 1);  // it may have to brake
  });
}

TEST(JointLine, BrakesAMotionUnderWayWithTheWholeLimitsWhateverItsSpeed) {
  int slow = 0, fast = 0;
  check_property(kCases, [&] {
    Cell cell;
    set_in_motion(cell, random_speed());
    const JointVector start = cell.arm->state().desired_joints, rest = resting_joints(*cell.arm);
    const JointVector target = random_target(*cell.arm, cell.axes);
    const double speed = std::pow(10, -0.1 * pick(0, 60));
    JointLine line(*cell.arm, target, speed);
    line.until(ElapsedSteps{1000});
    Move({*cell.arm}, {}, line);
    RC_ASSERT(std::isfinite(line.duration()));
    const std::vector<Sample> path = samples(cell.recorder);
    assert_within_limits(cell, path, 1);
    // beside its way an axis is only as far as it needs to brake; within a mrad, since one that speeds up needs more
    const JointVector low = start.cwiseMin(target).cwiseMin(rest), high = start.cwiseMax(target).cwiseMax(rest);
    const AxisParameters& axis = cell.arm->parameters().axes[0];
    for (const Sample& sample : path) {
      RC_ASSERT((low - sample.position).maxCoeff() < 1e-3);
      RC_ASSERT((sample.position - high).maxCoeff() < 1e-3);
    }
    // a second after the start, all that was fast has been braked
    const double dt = cell.arm->step_duration();
    for (std::size_t k = 0; k < path.size(); ++k)
      if (static_cast<double>(k) * dt > 1)
        RC_ASSERT(path[k].velocity.cwiseAbs().maxCoeff() <= speed * axis.velocity_max + 1e-9);
    ++(speed < 0.01 ? slow : fast);
  });
  EXPECT_GT(slow, kCases / 4);
  EXPECT_GT(fast, kCases / 8);
}

TEST(JointLine, ASlowLineEndsAtItsTarget) {
  check_property(50, [] {
    Cell cell;
    Wait({*cell.arm}, {}, ElapsedSteps{0});
    if (pick(0, 1) == 1) set_in_motion(cell, random_speed());
    JointVector target = cell.arm->state().desired_joints;
    for (Eigen::Index i = 0; i < cell.axes; ++i) target[i] += pick(-10, 10) * std::pow(10, -pick(5, 10));
    JointLine line(*cell.arm, target, std::pow(10, -0.1 * pick(10, 25)));
    const Outcome end = Move({*cell.arm}, {}, line);
    RC_ASSERT(end.ending == Ending::generator);
    if (end.steps > 0) assert_ends_at(cell, target);
  });
}

TEST(JointLine, AtEverySpeedOnlyTimeIsStretched) {
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

TEST(JointLine, AfterAPauseItGoesOnFromRestToTheSameTarget) {
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

TEST(JointLine, AMotionOfAWholeNumberOfStepsEndsAtRest) {
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

TEST(JointLine, RefusesWhatIsNoTarget) {
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
}  // namespace mrroc
