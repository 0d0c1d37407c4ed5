// Paths of an IRb-6, checked by its EDP's planner: the planner refuses no part of them, and the limits hold at every
// servo tick.
#include <rapidcheck.h>

#include "generators/path_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/move.hpp"
#include "mrroc/robots/irb6.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::test::path_limits_test {
namespace {

using Eigen::Vector3d;
using Cell = PathCell;
using fakes::check_every_case;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 60;

PathLimits random_limits() {
  return {.speed = 0.01 * pick(2, 40),
          .acceleration = 0.1 * pick(2, 20),
          .angular_speed = 0.05 * pick(2, 20),
          .angular_acceleration = 0.1 * pick(5, 40)};
}

/// Random motions of one kind, half of them with a pause: `make` returns the generator and its end pose.
template <class Make>
void check(Make make) {
  int moved = 0, refused = 0;
  Worst worst;
  check_every_case(kCases, [&] {
    Cell cell;
    const PathLimits limits = random_limits();
    Pose end = Pose::Identity();
    const auto generator = make(cell, limits, end);
    if (pick(0, 1) == 1) cell.pause_at = pick(1, 200);
    if (!cell.move(*generator)) {
      ++refused;
      return;
    }
    ++moved;
    cell.assert_limits();
    // the joints' polynomials overshoot slightly between the ends of macrosteps
    RC_ASSERT(cell.worst.speed <= 1.02 * limits.speed + 1e-6);
    RC_ASSERT(cell.worst.angular_speed <= 1.02 * limits.angular_speed + 1e-6);
    RC_ASSERT((cell.end().translation() - end.translation()).norm() < 1e-9);
    RC_ASSERT(rotation_vector(cell.end().linear() * end.linear().transpose()).norm() < 1e-7);
    worst.velocity = std::max(worst.velocity, cell.worst.velocity);
    worst.acceleration = std::max(worst.acceleration, cell.worst.acceleration);
    worst.jerk = std::max(worst.jerk, cell.worst.jerk);
  });
  std::printf("%d moved, %d refused before; of the joints' limits: velocity %.3f, acceleration %.3f, jerk %.3f\n",
              moved, refused, worst.velocity, worst.acceleration, worst.jerk);
  EXPECT_GT(moved, 2 * refused);
  EXPECT_GT(worst.velocity, 0.9) << "some reach the speed limits of the joints";
}

std::vector<Pose> random_poses(const Cell& cell) {
  std::vector<Pose> poses;
  for (int i = pick(1, 5); i > 0; --i) poses.push_back(cell.random_pose());
  return poses;
}

TEST(PathLimits, CartesianLine) {
  check([](Cell& cell, const PathLimits& limits, Pose& end) {
    end = cell.random_pose();
    return std::make_unique<CartesianLine>(cell.arm, end, limits);
  });
}

TEST(PathLimits, CartesianArc) {
  check([](Cell& cell, const PathLimits& limits, Pose& end) {
    end = cell.random_pose();
    return std::make_unique<CartesianArc>(cell.arm, cell.home.translation() + random_vector(0.05), end, limits);
  });
}

TEST(PathLimits, PoseSpline) {
  check([](Cell& cell, const PathLimits& limits, Pose& end) {
    const std::vector<Pose> poses = random_poses(cell);
    end = poses.back();
    return std::make_unique<PoseSpline>(cell.arm, poses, static_cast<SplineKind>(pick(0, 2)), limits);
  });
}

TEST(PathLimits, BlendedPath) {
  check([](Cell& cell, const PathLimits& limits, Pose& end) {
    std::vector<BlendPoint> points;
    for (const Pose& pose : random_poses(cell)) points.push_back({pose, 0.01 * pick(0, 6)});
    end = points.back().pose;
    return std::make_unique<BlendedPath>(cell.arm, points, limits);
  });
}

TEST(PathLimits, PoseSplineByTimes) {
  int moved = 0;
  check_every_case(kCases, [&moved] {
    Cell cell;
    std::vector<TimedPose> poses;
    double time = 0;
    for (const Pose& pose : random_poses(cell)) poses.push_back({pose, time += 0.1 * pick(20, 80)});
    PoseSpline spline(cell.arm, poses, static_cast<SplineKind>(pick(0, 2)));
    if (pick(0, 1) == 1) cell.pause_at = pick(1, 200);
    if (!cell.move(spline)) return;
    ++moved;
    cell.assert_limits();
    RC_ASSERT((cell.end().translation() - poses.back().pose.translation()).norm() < 1e-9);
  });
  EXPECT_GT(moved, kCases / 4) << "other paths have times that are too short";
}

TEST(PathLimits, JointPath) {
  int moved = 0;
  check_every_case(kCases, [&moved] {
    Cell cell;
    std::vector<JointVector> waypoints;
    for (int i = pick(1, 6); i > 0; --i) {
      JointVector joints(6);
      for (int k = 0; k < 6; ++k) {
        const AxisParameters& axis = cell.axes()[static_cast<std::size_t>(k)];
        // less for the upper arm and the wrist: the motors limit their sums
        const double part = k == 2 || k == 3 ? 0.1 : k == 4 ? 0.3 : 1;
        joints[k] =
            std::clamp(cell.axes_home()[k] + 0.01 * part * pick(-110, 110), axis.position_min, axis.position_max);
      }
      joints[1] = std::min(joints[1], cell.axes_home()[1] + 0.3);  // the upper arm's motor turns with it
      waypoints.push_back(joints);
    }
    JointPath path(cell.arm, waypoints, 0.01 * pick(20, 100));
    if (pick(0, 1) == 1) cell.pause_at = pick(1, 200);
    if (!cell.move(path)) return;
    ++moved;
    cell.assert_limits();
    RC_ASSERT((cell.desired().position - waypoints.back()).isZero(0));
  });
  EXPECT_GT(moved, kCases / 2) << "other paths are beyond a motor's range";
}

TEST(PathLimits, JointPathBeyondAMotorsRangeIsRefusedBeforeItsStart) {
  check_every_case(1, [] {
    Cell cell;
    JointVector joints = cell.axes_home();
    joints[1] = cell.axes()[1].position_max;
    joints[2] = cell.axes()[2].position_max;
    JointPath path(cell.arm, {cell.axes_home(), joints}, 0.5);
    RC_ASSERT(!cell.move(path));
  });
}

}  // namespace
}  // namespace mrroc::test::path_limits_test
