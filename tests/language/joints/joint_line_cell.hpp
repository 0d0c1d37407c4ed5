#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "language/fakes.hpp"
#include "language/motion_recorder.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/move.hpp"

/// A robot for the tests of JointLine, and the laws of every line.
namespace mrroc::joint_line {

using fakes::FakeTask;
using fakes::MotionRecorder;
using fakes::pick;

inline constexpr int kCases = 500;

/// Positions from -1.9 to 1.9, with limits of +-2.
inline JointVector random_joints(int axes) {
  JointVector joints(axes);
  for (Eigen::Index i = 0; i < axes; ++i) joints[i] = 0.001 * pick(-1900, 1900);
  return joints;
}

inline double random_speed() { return 0.01 * pick(5, 100); }

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

/// The states at the boundaries of the macrosteps: the start and every commanded end.
inline std::vector<Sample> samples(const MotionRecorder& recorder) {
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
inline void assert_within_limits(const Cell& cell, const std::vector<Sample>& path, double speed) {
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

inline void assert_ends_at(const Cell& cell, const JointVector& target) {
  const RobotCommand& last = cell.recorder.commands.back();
  RC_ASSERT(last.kind == CommandKind::joint);
  RC_ASSERT(last.joints == target);  // exactly, and at rest
  RC_ASSERT(last.joint_velocity.size() == 0);
  RC_ASSERT(last.joint_acceleration.size() == 0);
}

/// Random joints, or joints near those of `arm`, ahead of it or behind it.
inline JointVector random_target(const Robot& arm, int axes) {
  if (pick(0, 1) == 0) return random_joints(axes);
  JointVector target = arm.state().desired_joints;
  for (Eigen::Index i = 0; i < axes; ++i) target[i] = std::clamp(target[i] + 0.001 * pick(-100, 100), -1.9, 1.9);
  return target;
}

/// Drives `cell` along a line and leaves it in motion, without recording.
inline void set_in_motion(Cell& cell, double speed) {
  JointLine first(*cell.arm, random_joints(cell.axes), speed);
  first.until(ElapsedSteps{static_cast<std::uint64_t>(pick(1, 40))});
  Move({*cell.arm}, {}, first);
  cell.recorder.states.clear();
  cell.recorder.commands.clear();
}

}  // namespace mrroc::joint_line
