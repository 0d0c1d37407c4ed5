#include "mrroc/generators/replay.hpp"

#include <limits>

#include "language/fakes.hpp"
#include "language/free_flyer.hpp"
#include "language/motion_recorder.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/teach_in.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/move.hpp"

namespace mrroc::replay_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::FreeFlyer;
using fakes::MotionRecorder;
using fakes::pick;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// q_i(t) = offset + size sin(rate t + phase).
struct Swing {
  JointVector offset, size, rate, phase;

  explicit Swing(int axes) : offset(axes), size(axes), rate(axes), phase(axes) {
    for (Eigen::Index i = 0; i < axes; ++i) {
      offset[i] = 0.01 * pick(-100, 100);
      size[i] = 0.01 * pick(0, 80);
      rate[i] = 0.01 * pick(10, 150);
      phase[i] = 0.01 * pick(0, 628);
    }
  }
  JointVector at(double t) const { return offset.array() + size.array() * (rate.array() * t + phase.array()).sin(); }
  TaughtPath taught(double interval, int points) const {
    TaughtPath path;
    path.timed = true;
    for (int i = 0; i < points; ++i) path.points.push_back({2 + interval * i, at(interval * i), Pose::Identity()});
    return path;
  }
};

struct Cell {
  explicit Cell(int axes) : arm(task.robot("arm", axes)) {
    const auto n = static_cast<std::uint16_t>(pick(1, 20));
    arm->set_macrostep(n, static_cast<std::uint16_t>(pick(1, n)));
    task.step_observer = &recorder;
    task.log.recording = false;
  }
  /// No command exceeds the limits or changes faster than they allow, except over a pause, in which the fake stops at
  /// once.
  void assert_within_limits() const {
    const AxisParameters& axis = arm->parameters().axes[0];
    const double dt = arm->step_duration();
    const JointVector zero = JointVector::Zero(arm->state().joints.size());
    const auto full = [&](const JointVector& v) { return v.size() == 0 ? zero : v; };
    for (std::size_t k = 0; k < recorder.commands.size(); ++k) {
      if (recorder.commands[k].kind != CommandKind::joint) continue;
      const JointVector v = full(recorder.commands[k].joint_velocity),
                        a = full(recorder.commands[k].joint_acceleration);
      RC_ASSERT(v.cwiseAbs().maxCoeff() <= axis.velocity_max + 1e-6);
      RC_ASSERT(a.cwiseAbs().maxCoeff() <= axis.acceleration_max + 1e-6);
      if (k == 0 || recorder.commands[k - 1].kind != CommandKind::joint) continue;
      if (recorder.states[k].desired_tick - recorder.states[k - 1].desired_tick > arm->motion_steps()) continue;
      const JointVector v0 = full(recorder.commands[k - 1].joint_velocity),
                        a0 = full(recorder.commands[k - 1].joint_acceleration);
      RC_ASSERT((recorder.commands[k].joints - recorder.commands[k - 1].joints).cwiseAbs().maxCoeff() <=
                axis.velocity_max * dt + 1e-6);
      RC_ASSERT((v - v0).cwiseAbs().maxCoeff() <= axis.acceleration_max * dt + 1e-6);
      RC_ASSERT((a - a0).cwiseAbs().maxCoeff() <= axis.jerk_max * dt + 1e-6);
    }
  }
  FakeTask task;
  std::unique_ptr<Robot> arm;
  MotionRecorder recorder;
};

/// Distance of a point from the nearest one of the curve between two times.
double distance_to(const Swing& swing, const JointVector& joints, double from, double to) {
  double nearest = 1e9;
  for (double t = from; t <= to; t += 0.002) nearest = std::min(nearest, (swing.at(t) - joints).norm());
  return nearest;
}

TEST(Replay, TimedPathPassesItsPointsWithinTheLimits) {
  check_property(60, [] {
    const int axes = pick(1, kMaxJoints), points = pick(2, 40);
    Cell cell(axes);
    const Swing swing(axes);
    const TaughtPath path = swing.taught(0.1, points);
    const double speed = 0.1 * pick(2, 30);
    Replay replay(*cell.arm, path, speed);
    const Outcome end = Move({*cell.arm}, {}, replay);
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(cell.arm->state().desired_joints == path.points.back().joints);
    RC_ASSERT(cell.recorder.commands.back().joint_velocity.isZero(0));
    RC_ASSERT(replay.rate() > 0 && replay.rate() <= speed);
    RC_ASSERT(replay.point() == path.points.size());
    cell.assert_within_limits();
    // the path begins where the commands first reach the first point
    std::size_t begin = 0;
    while ((cell.recorder.commands[begin].joints - path.points.front().joints).norm() > 1e-9) ++begin;
    const double last = 0.1 * (points - 1);
    for (std::size_t k = begin; k < cell.recorder.commands.size(); ++k)
      RC_ASSERT(distance_to(swing, cell.recorder.commands[k].joints, 0, last + 1e-9) < 4e-3);
    for (const TaughtPoint& point : path.points) {
      double nearest = 1e9;
      for (std::size_t k = begin; k < cell.recorder.commands.size(); ++k)
        nearest = std::min(nearest, (cell.recorder.commands[k].joints - point.joints).norm());
      RC_ASSERT(nearest <= 0.6 * cell.arm->step_duration() * 1.0 * std::sqrt(axes) + 1e-6);
    }
  });
}

TEST(Replay, KeepsTheTaughtTimesWhereTheLimitsAllowIt) {
  check_property(40, [] {
    Cell cell(3);
    Swing swing(3);
    swing.size *= 0.2;  // slow enough
    const int points = pick(20, 60);
    const double speed = 0.25 * pick(1, 4);
    Replay replay(*cell.arm, swing.taught(0.1, points), speed);
    Move({*cell.arm}, {}, JointLine{*cell.arm, swing.at(0)});
    const Outcome end = Move({*cell.arm}, {}, replay);
    RC_ASSERT(replay.rate() == speed);
    // half a second to accelerate and half a second to slow down cost half a second together
    const double expected = 0.1 * (points - 1) / speed + 0.5;
    RC_ASSERT(std::abs(end.duration - expected) < 0.25 + 2 * cell.arm->step_duration());
  });
}

TEST(Replay, VisitsPositionsInOrderAndRestsThere) {
  check_property(60, [] {
    const int axes = pick(1, kMaxJoints), points = pick(1, 6);
    Cell cell(axes);
    TaughtPath path;
    for (int i = 0; i < points; ++i) path.points.push_back({0, Swing(axes).at(0), Pose::Identity()});
    const double speed = 0.01 * pick(20, 100);
    Replay replay(*cell.arm, path, speed);
    const Outcome end = Move({*cell.arm}, {}, replay);
    RC_ASSERT(end.ending == Ending::generator);
    cell.assert_within_limits();
    std::size_t next = 0;
    for (const RobotCommand& command : cell.recorder.commands)
      if (next < path.points.size() && command.joint_velocity.size() == 0 && command.joints == path.points[next].joints)
        ++next;
    RC_ASSERT(next == path.points.size());
    RC_ASSERT(replay.point() == path.points.size());
  });
}

TEST(Replay, PosesBecomeJointsOfTheSamePath) {
  check_property(40, [] {
    FreeFlyer task(Pose::Identity());
    TaughtPath path;
    path.space = TaughtPath::Space::poses;
    path.timed = pick(0, 1) == 1;
    Pose pose = Pose::Identity();
    for (int i = 0; i < pick(2, 10); ++i) {
      Twist stride;
      stride << 0.001 * pick(-50, 50), 0.001 * pick(-50, 50), 0.001 * pick(-50, 50), 0.001 * pick(-50, 50),
          0.001 * pick(-50, 50), 0.001 * pick(-50, 50);
      pose = pose * exp_twist(stride);
      path.points.push_back({0.5 * i, {}, pose});
    }
    if (path.points.size() < 2) return;
    Replay replay(*task.arm, path, 0.8);
    Move({*task.arm}, {}, replay);
    RC_ASSERT(task.state.desired_pose.isApprox(path.points.back().pose, 1e-9));
  });
}

TEST(Replay, TaughtPathIsReplayed) {
  FakeTask task;
  const auto arm = task.robot("arm", 4);
  MotionRecorder taught, replayed;
  TaughtPath path;
  Wait({*arm}, {}, ElapsedSteps{1});
  task.step_observer = &taught;
  Move({*arm}, {},
       Together{ToolVelocity{*arm, {0.1, 0.05, 0}, {0, 0, 0.2}}, TeachIn{*arm, path, 0.1}}.until(ElapsedSteps{60}));
  taught.states.push_back(arm->state());  // the last one, where it ended
  task.step_observer = nullptr;
  Move({*arm}, {}, JointLine{*arm, JointVector::Zero(4)});
  task.step_observer = &replayed;
  Move({*arm}, {}, Replay{*arm, path});
  double farthest = 0;
  for (const RobotState& state : replayed.states) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < taught.states.size(); ++i) {
      const JointVector a = taught.states[i - 1].desired_joints, leg = taught.states[i].desired_joints - a;
      const double u =
          leg.squaredNorm() > 0 ? std::clamp((state.desired_joints - a).dot(leg) / leg.squaredNorm(), 0.0, 1.0) : 0;
      nearest = std::min(nearest, (state.desired_joints - a - u * leg).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  std::printf("replayed within %.2g rad or m\n", farthest);
  EXPECT_LT(farthest, 2e-4);
}

TEST(Replay, ReturnsToItsPathAfterAPauseAndContinues) {
  check_property(40, [] {
    Cell cell(3);
    const Swing swing(3);
    const bool timed = pick(0, 1) == 1;
    TaughtPath path = swing.taught(0.1, 30);
    path.timed = timed;
    cell.task.requests.assign(static_cast<std::size_t>(pick(1, 300)), OperatorRequest::none);
    cell.task.requests.push_back(OperatorRequest::pause);
    Move({*cell.arm}, {}, Replay{*cell.arm, path, 0.9});
    RC_ASSERT(cell.arm->state().desired_joints == path.points.back().joints);
    cell.assert_within_limits();
  });
}

TEST(Replay, RefusesInvalidPaths) {
  FreeFlyer task(Pose::Identity());
  const TaughtPoint home{0, JointVector::Zero(6), Pose::Identity()}, later{1, JointVector::Zero(6), Pose::Identity()};
  const auto make = [&](const TaughtPath& path, double speed = 1) { Replay{*task.arm, path, speed}; };
  EXPECT_NO_THROW(make({TaughtPath::Space::joints, true, {home, later}}));
  EXPECT_NO_THROW(make({TaughtPath::Space::joints, true, {home, later}}, 3));
  EXPECT_NO_THROW(make({TaughtPath::Space::joints, false, {home}}));
  EXPECT_THROW(make({TaughtPath::Space::joints, false, {}}), NonFatalError);
  EXPECT_THROW(make({TaughtPath::Space::joints, false, {home}}, 1.1), NonFatalError);
  EXPECT_THROW(make({TaughtPath::Space::joints, true, {home}}), NonFatalError);
  EXPECT_THROW(make({TaughtPath::Space::joints, true, {later, home}}), NonFatalError);
  EXPECT_THROW(make({TaughtPath::Space::joints, true, {home, home}}), NonFatalError);
  for (const double bad : {0.0, -1.0, kNan})
    EXPECT_THROW(make({TaughtPath::Space::joints, true, {home, later}}, bad), NonFatalError);
  TaughtPoint bad = home;
  bad.joints = JointVector::Zero(5);
  EXPECT_THROW(make({TaughtPath::Space::joints, false, {bad}}), NonFatalError);
  bad.joints = JointVector::Constant(6, kNan);
  EXPECT_THROW(make({TaughtPath::Space::joints, false, {bad}}), NonFatalError);
  bad.joints = JointVector::Constant(6, 2.5);
  EXPECT_THROW(make({TaughtPath::Space::joints, false, {bad}}), NonFatalError);
  EXPECT_NO_THROW(make({TaughtPath::Space::poses, false, {bad}})) << "the joints do not matter";
  bad.pose.linear()(0, 1) = 0.1;
  EXPECT_THROW(make({TaughtPath::Space::poses, false, {bad}}), NonFatalError);
  // out of reach: detected at the start
  bad = home;
  bad.pose.translation().x() = 3;
  EXPECT_THROW(Move({*task.arm}, {}, Replay(*task.arm, {TaughtPath::Space::poses, false, {bad}})), NonFatalError);
}

}  // namespace
}  // namespace mrroc::replay_test
