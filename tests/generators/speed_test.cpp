// Motions at the operator's speed, checked by the IRb-6's own planner: within all limits at every tick, on the path of
// full speed, to the same end.
#include <rapidcheck.h>

#include <cmath>
#include <functional>

#include "generators/path_cell.hpp"
#include "language/property.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/generators/replay.hpp"

namespace mrroc::test::speed_test {
namespace {

using fakes::check_every_case;
using fakes::pick;

constexpr int kCases = 150;
constexpr Tick kLongestStop = 350;       // of the robot from full speed
constexpr double kOffPath = 2e-6;        // rad, m: between the points of two ticks the path is taken as straight
constexpr double kOffAfterPause = 2e-3;  // rad, m: the path is searched from where the robot rests

using Make = std::function<std::unique_ptr<Generator>(Irb6&)>;

/// A random motion, the same for every robot at home.
Make random_motion(const PathCell& cell) {
  const int kind = pick(0, 6);
  const Pose via = cell.random_pose(), end = cell.random_pose();
  const PathLimits limits{0.01 * pick(5, 40), 0.1 * pick(3, 10), 0.2 * pick(1, 10), 2};
  const double part = 0.1 * pick(2, 10);
  JointVector joints = cell.desired().position;
  for (Eigen::Index i = 0; i < joints.size(); ++i) joints[i] += 0.005 * pick(-60, 60);
  return [=, home = JointVector(cell.desired().position)](Irb6& arm) -> std::unique_ptr<Generator> {
    TaughtPath taught;
    taught.points = {{0, joints, Pose::Identity()}, {3, home, Pose::Identity()}};
    taught.timed = part < 0.5;
    switch (kind) {
      case 0:
        return std::make_unique<CartesianLine>(arm, end, limits);
      case 1:
        return std::make_unique<CartesianArc>(arm, via.translation(), end, limits);
      case 2:
        return std::make_unique<BlendedPath>(arm, std::vector<BlendPoint>{{via, 0.01}, {end, 0}}, limits);
      case 3:
        return std::make_unique<PoseSpline>(arm, std::vector<Pose>{via, end}, SplineKind::cubic, limits);
      case 4:
        return std::make_unique<JointLine>(arm, joints, part);
      case 5:
        return std::make_unique<JointPath>(arm, std::vector<JointVector>{joints, home}, part);
      default:
        return std::make_unique<Replay>(arm, taught, part);
    }
  };
}

/// The operator's speed over the time: full at first, then changed some times, at random ticks.
std::function<double(Tick)> random_speeds(Tick first, int changes) {
  std::map<Tick, double> speeds;
  Tick tick = first;
  for (int i = 0; i < changes; ++i) {
    tick += static_cast<Tick>(pick(0, 600));
    speeds[tick] = pick(0, 3) == 0 ? 1 : 0.01 * pick(5, 100);
  }
  return [speeds](Tick now) {
    const auto next = speeds.upper_bound(now);
    return next == speeds.begin() ? 1.0 : std::prev(next)->second;
  };
}

/// The joints at every tick of a motion.
struct Recorded : PathCell {
  Recorded() {
    points.push_back(desired().position);
    on_tick = [this, check = on_tick](const DesiredState& now, const DesiredState& before,
                                      const RobotCommand& command) {
      check(now, before, command);
      points.push_back(now.position);
      if (paused == 0 && is_pausing()) paused = tick();
      if (paused != 0 && rested == 0 && now.at_rest()) rested = tick();
    };
  }
  bool run(const Make& make) {
    try {
      const auto generator = make(arm);
      return move(*generator);
    } catch (const NonFatalError&) {  // a target that the robot cannot reach
      RC_ASSERT(ticks == 0);
      return false;
    }
  }
  std::vector<JointVector> points;
  Tick paused = 0, rested = 0;
};

double distance(const JointVector& point, const JointVector& from, const JointVector& to) {
  const JointVector way = to - from;
  const double square = way.squaredNorm();
  const double part = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0;
  return (point - from - part * way).lpNorm<Eigen::Infinity>();
}

/// The largest distance of the points from the path through `path`, which they follow forwards.
double off_path(const std::vector<JointVector>& points, const std::vector<JointVector>& path, std::size_t back = 60) {
  constexpr std::size_t kAhead = 60;  // ticks
  double largest = 0;
  std::size_t at = 0;
  for (const JointVector& point : points) {
    double least = distance(point, path[at], path[std::min(at + 1, path.size() - 1)]);
    std::size_t nearest = at;
    for (std::size_t k = at > back ? at - back : 0; k < std::min(at + kAhead, path.size() - 1); ++k) {
      const double off = distance(point, path[k], path[k + 1]);
      if (off >= least) continue;
      least = off;
      nearest = k;
    }
    at = nearest;
    largest = std::max(largest, least);
  }
  return largest;
}

TEST(Speed, MotionsStayWithinTheLimitsOnThePathOfFullSpeed) {
  int moved = 0;
  double off = 0;
  check_every_case(kCases, [&] {
    Recorded full, scaled;
    scaled.arm.set_macrostep(full.arm.motion_steps(), 2);
    const Make make = random_motion(full);
    scaled.speed_at = random_speeds(scaled.tick(), pick(1, 6));
    if (!full.run(make)) return;
    RC_ASSERT(scaled.run(make));
    ++moved;
    scaled.assert_limits();
    RC_ASSERT((scaled.desired().position - full.desired().position).isZero(1e-12));
    RC_ASSERT(scaled.desired().at_rest());
    const double here = off_path(scaled.points, full.points);
    off = std::max(off, here);
    RC_ASSERT(here <= kOffPath);
  });
  std::printf("%d moved, at most %.3g off the path\n", moved, off);
  EXPECT_GT(moved, kCases / 2);
}

TEST(Speed, ConstantSpeedStretchesTheTime) {
  double shorter = 0, longer = 0;
  check_every_case(kCases, [&] {
    Recorded full, scaled;
    scaled.arm.set_macrostep(full.arm.motion_steps(), 2);
    const Make make = random_motion(full);
    const double speed = 0.01 * pick(1, 99);
    scaled.speed_at = [speed](Tick) { return speed; };
    if (!full.run(make)) return;
    RC_ASSERT(scaled.run(make));
    scaled.assert_limits();
    RC_ASSERT(scaled.worst.velocity <= (1 + 1e-6) * speed);
    const double more = scaled.ticks - full.ticks / speed;  // each rest is at a whole tick
    shorter = std::min(shorter, more);
    longer = std::max(longer, more);
    RC_ASSERT(more > -2);
    RC_ASSERT(more < 40);
    RC_ASSERT(off_path(scaled.points, full.points) <= kOffPath);
  });
  std::printf("%g to %g ticks more than the law\n", shorter, longer);
}

TEST(Speed, PauseRestsOnThePathDuringAChange) {
  double off = 0;
  Tick longest = 0;
  check_every_case(kCases, [&] {
    Recorded full, scaled;
    scaled.arm.set_macrostep(full.arm.motion_steps(), 2);
    const Make make = random_motion(full);
    if (!full.run(make)) return;
    const double first = 0.01 * pick(2, 95), speed = 0.01 * pick(2, 99);
    const Tick change = scaled.tick() + static_cast<Tick>(pick(0, full.ticks));
    scaled.speed_at = [=](Tick now) { return now < change ? first : speed; };
    scaled.pause_at = pick(1, 400);
    RC_ASSERT(scaled.run(make));
    scaled.assert_limits();
    RC_ASSERT((scaled.desired().position - full.desired().position).isZero(1e-9));
    longest = std::max(longest, scaled.rested - scaled.paused);
    RC_ASSERT(scaled.rested - scaled.paused <= kLongestStop + 3 * scaled.arm.motion_steps());
    const std::string name = make(full.arm)->name();
    if (name == "JointLine" || name == "Replay") return;  // they plan a new path from where they rest
    const double here = off_path(scaled.points, full.points);
    off = std::max(off, here);
    RC_ASSERT(here <= kOffAfterPause);
  });
  std::printf("at most %.3g off the path; at rest after at most %d ticks\n", off, static_cast<int>(longest));
}

/// A motion is ended on its way by a condition, and the next one continues from there.
TEST(Speed, NextMoveContinuesFromTheMotion) {
  check_every_case(kCases, [&] {
    Recorded cell;
    const Make first = random_motion(cell), second = random_motion(cell);
    cell.speed_at = random_speeds(cell.tick(), pick(1, 5));
    try {
      const auto motion = first(cell.arm);
      Move({cell.arm}, {}, motion->until(ElapsedSteps{static_cast<std::uint64_t>(pick(1, 100))}));
      const auto next = second(cell.arm);
      Move({cell.arm}, {}, *next);
    } catch (const NonFatalError& error) {
      RC_LOG() << error.what() << "\n";
      RC_ASSERT(std::string(error.what()).find(", step ") == std::string::npos);  // only before a motion
    }
    cell.assert_limits();
  });
}

}  // namespace
}  // namespace mrroc::test::speed_test
