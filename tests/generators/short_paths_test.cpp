// Paths with nearly repeated points, and very short ones, of an IRb-6, checked by its EDP's planner: a path that starts
// is completed within the limits, and in a time that corresponds to its length.
#include <rapidcheck.h>

#include <cmath>

#include "generators/path_cell.hpp"
#include "geometry/near_places.hpp"
#include "language/property.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/generators/replay.hpp"

namespace mrroc::test::short_paths_test {
namespace {

using fakes::check_every_case;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 40;
constexpr double kLonger = 1.2;  // at most, relative to the time without the point

double random_distance(int least, int most) { return std::pow(10, -0.25 * pick(4 * least, 4 * most)); }

/// `pose`, moved or turned or both by `distance`.
Pose beside(Pose pose, double distance) {
  const int what = pick(0, 2);
  if (what != 1) pose.translation() += distance * random_vector(1).normalized();
  if (what != 0)
    pose.linear() = exp_rotation(Eigen::Vector3d(distance * random_vector(1).normalized())) * pose.linear();
  return pose;
}

struct Points {
  std::vector<Pose> without, with;
};

/// Some poses, and the same with an additional one beside one of them, or beside the start.
Points random_points(PathCell& cell, double distance) {
  Points points;
  for (int i = pick(2, 3); i > 0; --i) {
    const Pose last = points.without.empty() ? cell.home : points.without.back();
    Pose next = cell.random_pose();
    while ((next.translation() - last.translation()).norm() < 0.05) next = cell.random_pose();
    points.without.push_back(next);
  }
  points.with = points.without;
  const int place = pick(0, static_cast<int>(points.with.size()) - 1);
  const Pose& near = place == 0 ? cell.home : points.without[static_cast<std::size_t>(place - 1)];
  points.with.insert(points.with.begin() + place, beside(near, distance));
  return points;
}

/// Runs the path that `make` builds from random points, without and with one of them nearly repeated. `longer`:
/// permitted ratio of the second duration to the first.
template <class Make>
void check(int least, int most, double longer, Make make) {
  int moved = 0, refused = 0;
  double worst = 0;
  check_every_case(kCases, [&] {
    PathCell cell, other;
    other.arm.set_macrostep(cell.arm.motion_steps(), 2);
    const double distance = random_distance(least, most);
    const Points points = random_points(cell, distance);
    const int choice = pick(0, 1000);
    const auto plain = make(cell, points.without, choice), repeated = make(other, points.with, choice);
    RC_LOG() << "distance " << distance << ", choice " << choice << "\n";
    if (!cell.move(*plain)) return;
    if (!other.move(*repeated)) {
      ++refused;
      return;
    }
    ++moved;
    other.assert_limits();
    RC_ASSERT((cell.desired().position - other.desired().position).isZero(1e-9));
    const double ratio = (other.ticks - 2.0 * cell.arm.motion_steps()) / cell.ticks;
    worst = std::max(worst, ratio);
    RC_ASSERT(ratio <= longer);
  });
  std::printf("%d moved, %d refused before; at most %.3f times as long\n", moved, refused, worst);
  EXPECT_GT(moved, kCases / 2);
}

const auto kSpline = [](PathCell& cell, const std::vector<Pose>& poses, int choice) {
  return std::make_unique<PoseSpline>(cell.arm, poses, static_cast<SplineKind>(choice % 3), PathLimits{});
};
const auto kBlended = [](PathCell& cell, const std::vector<Pose>& poses, int choice) {
  std::vector<BlendPoint> points;
  for (const Pose& pose : poses) points.push_back({pose, choice % 4 == 0 ? 0 : 0.005 * (choice % 4)});
  return std::make_unique<BlendedPath>(cell.arm, points);
};
const auto kJoints = [](PathCell& cell, const std::vector<Pose>& poses, int choice) {
  return std::make_unique<JointPath>(cell.arm, poses, 0.1 * (1 + choice % 10));
};
const auto kReplay = [](PathCell& cell, const std::vector<Pose>& poses, int choice) {
  TaughtPath path{TaughtPath::Space::poses, false, {}};
  for (const Pose& pose : poses) path.points.push_back({0, {}, pose});
  return std::make_unique<Replay>(cell.arm, path, 0.1 * (1 + choice % 10));
};

// nearer than the resolution of a position
TEST(NearRepeats, PoseSplineMergesThePoints) { check(5, 9, kLonger, kSpline); }
TEST(NearRepeats, BlendedPathMergesThePoints) { check(5, 9, kLonger, kBlended); }
TEST(NearRepeats, JointPathMergesThePoints) { check(5, 9, kLonger, kJoints); }
TEST(NearRepeats, ReplayRestsTwiceAtOnePosition) { check(5, 9, kLonger, kReplay); }
// two positions
TEST(NearRepeats, PoseSplinePassesBothPoints) { check(2, 5, kLonger, kSpline); }
TEST(NearRepeats, BlendedPathPassesBothPoints) { check(2, 5, kLonger, kBlended); }
TEST(NearRepeats, JointPathPassesBothPoints) { check(2, 5, kLonger, kJoints); }
TEST(NearRepeats, ReplayRestsAtBothPoints) { check(2, 5, kLonger, kReplay); }

TEST(NearRepeats, CloseTimesAreRefusedBeforeTheStart) {
  int moved = 0, refused = 0;
  check_every_case(kCases, [&] {
    PathCell cell;
    const Pose first = cell.random_pose(), last = cell.random_pose();
    std::vector<TimedPose> poses{{first, 5}, {beside(first, random_distance(2, 9)), 5 + random_distance(0, 9)}};
    poses.push_back({last, poses.back().time + 5});
    PoseSpline spline(cell.arm, poses, static_cast<SplineKind>(pick(0, 2)));
    if (!cell.move(spline)) return void(++refused);
    ++moved;
    cell.assert_limits();
  });
  std::printf("%d moved, %d refused before\n", moved, refused);
}

TEST(NearRepeats, TimedReplayMergesThePoints) {
  check_every_case(kCases, [] {
    PathCell cell, other;
    TaughtPath path{TaughtPath::Space::poses, true, {}};
    double time = 0;
    for (int i = 0; i < 3; ++i) path.points.push_back({time += 4, {}, cell.random_pose()});
    Replay plain(cell.arm, path, 1);
    const int place = pick(0, 1);
    TaughtPoint repeated = path.points[static_cast<std::size_t>(place)];
    repeated.pose = beside(repeated.pose, random_distance(5, 9));
    repeated.time += random_distance(2, 9);
    path.points.insert(path.points.begin() + place + 1, repeated);
    Replay with(other.arm, path, 1);
    if (!cell.move(plain) || !other.move(with)) return;
    RC_ASSERT(std::abs(with.rate() - plain.rate()) < 0.05 * plain.rate());
    other.assert_limits();
  });
}

TEST(ShortPaths, EndAtTheirTargetsWithinASecond) {
  int moved = 0;
  check_every_case(3 * kCases, [&] {
    PathCell cell;
    const double distance = random_distance(3, 9);
    const Pose target = beside(cell.home, distance);
    std::unique_ptr<Generator> generator;
    switch (pick(0, 3)) {
      case 0:
        generator = std::make_unique<CartesianLine>(cell.arm, target);
        break;
      case 1:
        generator = std::make_unique<PoseSpline>(cell.arm, std::vector<Pose>{target});
        break;
      case 2:
        generator = std::make_unique<JointPath>(cell.arm, std::vector<Pose>{target}, 1);
        break;
      default:
        generator = std::make_unique<JointLine>(cell.arm, target, 1);
    }
    RC_ASSERT(cell.move(*generator));
    RC_ASSERT((cell.end().translation() - target.translation()).norm() < 1.1e-9);
    RC_ASSERT(cell.ticks * PathCell::kPeriod < 1);
    cell.assert_limits();
    ++moved;
  });
  EXPECT_EQ(moved, 3 * kCases);
}

TEST(ShortPaths, BlendOfAnyRadiusIsCompleted) {
  check_every_case(kCases, [] {
    PathCell cell;
    std::vector<BlendPoint> points;
    for (int i = 0; i < 2; ++i) points.push_back({cell.random_pose(), random_distance(1, 9)});
    // nearly straight on, nearly straight back, or in any direction
    const Pose& from = points[0].pose;
    Pose last = points[1].pose;
    if (const int what = pick(0, 2); what < 2)
      last.translation() += (what == 0 ? 0.3 : -0.3) * (last.translation() - from.translation()) +
                            random_distance(2, 9) * random_vector(1);
    points.push_back({last, 0});
    BlendedPath path(cell.arm, points);
    if (!cell.move(path)) return;
    cell.assert_limits();
    RC_ASSERT((cell.end().translation() - last.translation()).norm() < 1e-9);
  });
}

TEST(SlowPaths, ArePlannedAtEverySpeed) {
  check_every_case(kCases, [] {
    PathCell cell, other;
    other.arm.set_macrostep(cell.arm.motion_steps(), 2);
    const Points points = random_points(cell, 0.01);
    const double speed = random_distance(0, 5), v = 0.1 * speed, turn = 0.3 * speed;
    const PathLimits limits{v, 0.5 * speed * speed, turn, speed * speed};
    const int kind = pick(0, 2);
    const auto make = [&](PathCell& in, const PathLimits& of) -> std::unique_ptr<PathGenerator> {
      if (kind == 0) return std::make_unique<CartesianLine>(in.arm, points.without[0], of);
      if (kind == 1) return std::make_unique<PoseSpline>(in.arm, points.without, SplineKind::cubic, of);
      return std::make_unique<JointPath>(in.arm, points.without, of.speed / 0.1);
    };
    const auto fast = make(cell, PathLimits{}), slow = make(other, limits);
    fast->until(ElapsedSteps{1});
    slow->until(ElapsedSteps{50});
    try {
      Move({cell.arm}, {}, *fast);
      Move({other.arm}, {}, *slow);
    } catch (const NonFatalError&) {
      RC_ASSERT(other.ticks == 0);
      return;
    }
    RC_ASSERT(slow->duration() * speed > 0.3 * fast->duration() - 0.2);
    RC_ASSERT(slow->duration() * speed < 3 * fast->duration());
    other.assert_limits();
  });
}

TEST(Arcs, RefuseAPlaneFromClosePoints) {
  int refused = 0;
  check_every_case(kCases, [&] {
    PathCell cell;
    const Pose target = cell.random_pose();
    const Eigen::Vector3d from = cell.home.translation(), to = target.translation();
    const Eigen::Vector3d off = random_distance(5, 12) * random_vector(1).normalized();
    Pose end = target;
    Eigen::Vector3d via = from + off;
    if (const int what = pick(0, 2); what == 1)
      via = to + off;
    else if (what == 2)
      end.translation() = from + off, via = to;
    if ((to - from).norm() < 0.02) return;
    CartesianArc arc(cell.arm, via, end);
    try {
      Move({cell.arm}, {}, arc);
      RC_FAIL("an arc through one of its ends");
    } catch (const NonFatalError& error) {
      RC_ASSERT(error.code() == ErrorCode::invalid_argument);
      RC_ASSERT(cell.ticks == 0);
      ++refused;
    }
  });
  EXPECT_GT(refused, kCases / 2);
}

}  // namespace
}  // namespace mrroc::test::short_paths_test
