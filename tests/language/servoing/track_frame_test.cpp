#include "mrroc/generators/track_frame.hpp"

#include <limits>
#include <set>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::track_frame_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FreeFlyer;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 150;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Pose random_pose(double largest, double turn) {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(largest);
  pose.linear() = exp_rotation(random_vector(turn));
  return pose;
}

/// A frame that moves with a constant twist, and a tool that follows it.
struct Cell {
  explicit Cell(const Twist& twist)
      : task(random_pose(0.5, 0.5), static_cast<std::uint16_t>(pick(1, 20))),
        origin{random_pose(0.5, 0.5), twist, task.time.tick} {}
  MovingFrame at(Tick tick) const {
    const double seconds = (static_cast<double>(tick) - static_cast<double>(origin.tick)) * task.servo_period();
    MovingFrame frame = origin.after(seconds);
    frame.tick = tick;
    return frame;
  }
  TrackFrame::Frame frame() {
    return [this]() -> std::optional<MovingFrame> {
      if (lost.contains(looks++)) return std::nullopt;
      return at(task.time.tick);
    };
  }
  /// The end of the k-th commanded macrostep.
  Tick end_of(std::size_t k) const { return task.commands[0].start_tick + (k + 1) * task.arm->motion_steps(); }
  /// The commanded tool pose in the frame.
  Pose relative(std::size_t k) const { return at(end_of(k)).pose.inverse() * task.commands[k].pose; }

  FreeFlyer task;
  MovingFrame origin;
  std::set<int> lost;  ///< numbers of the queries at which the frame is unknown
  int looks = 0;
};

Twist random_twist() {
  Twist twist;
  twist << random_vector(0.15), random_vector(pick(0, 1) == 0 ? 0 : 0.2);
  return twist;
}

TEST(TrackFrame, CatchesUpAndThenMovesWithTheFrame) {
  check_property(kCases, [] {
    Cell cell(random_twist());
    const Pose target = random_pose(0.2, 0.5);
    TrackFrame track(*cell.task.arm, cell.frame(), {{target, 0.5}});
    RC_ASSERT(Move({*cell.task.arm}, {}, track.until(ElapsedSteps{20000})).ending == Ending::generator);
    const auto dwell = static_cast<std::size_t>(0.4 / cell.task.arm->step_duration());
    const std::size_t count = cell.task.commands.size();
    for (std::size_t k = count - dwell; k < count; ++k) {
      const Pose x = cell.relative(k);
      RC_ASSERT((x.translation() - target.translation()).norm() < 1e-4);
      RC_ASSERT(rotation_vector(x.linear().transpose() * target.linear()).norm() < 1e-4);
      const MovingFrame frame = cell.at(cell.end_of(k));
      const Vector3d arm = frame.pose.linear() * target.translation();
      const Twist& twist = cell.task.commands[k].twist;
      RC_ASSERT((twist.head<3>() - frame.twist.head<3>() - frame.twist.tail<3>().cross(arm)).norm() < 2e-3);
      RC_ASSERT((twist.tail<3>() - frame.twist.tail<3>()).norm() < 2e-3);
    }
  });
}

TEST(TrackFrame, KeepsItsLimitsRelativeToTheFrame) {
  check_property(kCases, [] {
    Twist belt = Twist::Zero();
    belt.head<3>() = random_vector(0.15);
    Cell cell(belt);
    const FrameLimits limits{.speed = 0.3, .acceleration = 0.01 * pick(10, 100)};
    TrackFrame track(*cell.task.arm, cell.frame(), {{random_pose(0.2, 0.5), 0.1}, {random_pose(0.2, 0.5), 0}}, limits);
    Move({*cell.task.arm}, {}, track.until(ElapsedSteps{20000}));
    Vector3d before = cell.origin.pose.linear().transpose() * -belt.head<3>();
    for (const RobotCommand& command : cell.task.commands) {
      const Vector3d now = cell.origin.pose.linear().transpose() * (command.twist.head<3>() - belt.head<3>());
      RC_ASSERT(now.cwiseAbs().maxCoeff() <= limits.speed + 1e-6);
      RC_ASSERT((now - before).cwiseAbs().maxCoeff() <= limits.acceleration * cell.task.arm->step_duration() + 1e-6);
      before = now;
    }
  });
}

TEST(TrackFrame, TwistIsThePosesDerivativeAndItsRateTheTwists) {
  check_property(50, [] {
    Cell cell(random_twist());
    cell.task.arm->set_macrostep(1, 1);
    TrackFrame track(*cell.task.arm, cell.frame(), random_pose(0.2, 0.5));
    Move({*cell.task.arm}, {}, track.until(ElapsedSteps{500}));
    const auto& commands = cell.task.commands;
    const double dt = cell.task.servo_period();
    for (std::size_t k = 1; k + 1 < commands.size(); ++k) {
      const Vector3d way = commands[k + 1].pose.translation() - commands[k - 1].pose.translation();
      const Vector3d turn = rotation_vector(commands[k + 1].pose.linear() * commands[k - 1].pose.linear().transpose());
      RC_ASSERT((way / (2 * dt) - commands[k].twist.head<3>()).norm() < 1e-4);
      RC_ASSERT((turn / (2 * dt) - commands[k].twist.tail<3>()).norm() < 1e-4);
    }
  });
}

// drives with a constant lag: the correction compensates it
TEST(TrackFrame, LagOfTheDrivesIsCompensated) {
  check_property(50, [] {
    Twist belt = Twist::Zero();
    belt.head<3>() = random_vector(0.15);
    Cell cell(belt);
    cell.task.arm->set_macrostep(10, 10);
    cell.task.delayed = true;  // by 20 ms: 5 mm at 0.26 m/s
    TrackFrame track(*cell.task.arm, cell.frame(), {{random_pose(0.2, 0.5), 2.0}});
    RC_ASSERT(Move({*cell.task.arm}, {}, track.until(ElapsedSteps{20000})).ending == Ending::generator);
    RC_ASSERT(track.error().norm() < 1e-4);
  });
}

TEST(TrackFrame, LostReadingIsBridgedAndTooManyThrow) {
  check_property(50, [] {
    Cell cell(random_twist());
    const int from = pick(5, 50), length = pick(1, 10);
    for (int i = 0; i < length; ++i) cell.lost.insert(from + i);
    const Pose target = random_pose(0.2, 0.5);
    TrackFrame track(*cell.task.arm, cell.frame(), {{target, 1.0}});
    RC_ASSERT(Move({*cell.task.arm}, {}, track.until(ElapsedSteps{20000})).ending == Ending::generator);
    RC_ASSERT((cell.relative(cell.task.commands.size() - 1).translation() - target.translation()).norm() < 2e-4);
  });
  check_property(20, [] {
    Cell cell(random_twist());
    const int from = pick(1, 20);
    for (int i = 0; i <= 10; ++i) cell.lost.insert(from + i);
    TrackFrame track(*cell.task.arm, cell.frame(), {{random_pose(0.2, 0.5), 1e9}});
    try {
      Move({*cell.task.arm}, {}, track);
      RC_FAIL("no error");
    } catch (const NonFatalError& error) {
      RC_ASSERT(error.code() == ErrorCode::sensor_not_ready);
    }
  });
}

// a second motion continues from the first one without a jump
TEST(TrackFrame, ContinuesFromAMotionWithTheFrame) {
  check_property(50, [] {
    Cell cell(random_twist());
    TrackFrame first(*cell.task.arm, cell.frame(), {{random_pose(0.2, 0.3), 0.5}});
    Move({*cell.task.arm}, {}, first.until(ElapsedSteps{20000}));
    const Twist before = cell.task.commands.back().twist;
    cell.task.commands.clear();
    TrackFrame second(*cell.task.arm, cell.frame(), random_pose(0.2, 0.3));
    Move({*cell.task.arm}, {}, second.until(ElapsedSteps{20000}));
    const double dt = cell.task.arm->step_duration();
    RC_ASSERT((cell.task.commands.front().twist - before).norm() < std::sqrt(3) * (0.3 + 1.0) * dt + 5e-3);
  });
}

TEST(TrackFrame, RefusesInvalidArguments) {
  FreeFlyer task(Pose::Identity());
  const auto frame = [] { return std::optional<MovingFrame>(MovingFrame{}); };
  Pose bad = Pose::Identity();
  bad.linear() *= 2;
  const auto make = [&](std::vector<FramePoint> path, const FrameLimits& limits, int patience) {
    TrackFrame{*task.arm, frame, std::move(path), limits, patience};
  };
  EXPECT_NO_THROW(make({{}}, {}, 0));
  EXPECT_THROW(make({}, {}, 0), NonFatalError);
  EXPECT_THROW(make({{bad, 0}}, {}, 0), NonFatalError);
  EXPECT_THROW(make({{Pose::Identity(), -1}}, {}, 0), NonFatalError);
  EXPECT_THROW(make({{Pose::Identity(), kNan}}, {}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {.speed = 0}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {.acceleration = kNan}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {.angular_speed = -1}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {.angular_acceleration = 0}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {.tolerance = 0}, 0), NonFatalError);
  EXPECT_THROW(make({{}}, {}, -1), NonFatalError);
  EXPECT_THROW((TrackFrame{*task.arm, nullptr, Pose::Identity()}), NonFatalError);
  TrackFrame unknown(
      *task.arm, [] { return std::optional<MovingFrame>(); }, Pose::Identity());
  EXPECT_THROW(Move({*task.arm}, {}, unknown), NonFatalError);
}

}  // namespace
}  // namespace mrroc::track_frame_test
