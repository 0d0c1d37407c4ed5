// Paths of an IRb-6 with its EDP core in the simulated world: distance of the measured tool from the path.
#include <algorithm>

#include "generators/simulated_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::path_test {
namespace {

constexpr const char* kEmptyScene = R"(<mujoco><compiler angle="radian"/><worldbody/></mujoco>)";

/// A tool pose in front of the arm, turned by `turn` about the tool's x axis.
Pose at(double y, double z, double turn = 0) {
  return Irb6::tool_down(0.75, y, z) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX());
}

/// Distance of `place` from a chain of positions, m, and the index of the nearest one.
double beside(const std::vector<Pose>& chain, const Eigen::Vector3d& place, std::size_t& nearest) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Eigen::Vector3d from = chain[i].translation(), way = chain[i + 1].translation() - from;
    const double u = way.norm() > 0 ? std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    const double off = (place - from - u * way).norm();
    if (off >= least) continue;
    least = off;
    nearest = u < 0.5 ? i : i + 1;
  }
  return least;
}

struct Path : testing::Test {
  Path() {
    Move({arm}, {}, JointLine{arm, at(-0.1, 0)});
    Move({arm}, {}, Hold{arm, 0.5});
  }

  /// Follows the path and prints the deviations; the bounds are those of the measured tool, mm.
  void follow(const char* name, PathGenerator& generator, const Pose& end, double bound) {
    std::vector<Pose> chain{arm.state().desired_pose}, measured;
    cell.on_tick = [&] { measured.push_back(cell.tool()); };
    const Outcome outcome = Move({arm}, {}, generator.until(When{"", [&] {
                                                                   chain.push_back(arm.state().desired_pose);
                                                                   return false;
                                                                 }}));
    EXPECT_EQ(outcome.ending, Ending::generator);
    Move({arm}, {}, Hold{arm, 0.5});  // until the drives have caught up
    cell.on_tick = nullptr;
    double worst = 0, squares = 0, turned = 0, speed = 0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      std::size_t nearest = 0;
      const double off = beside(chain, measured[i].translation(), nearest);
      worst = std::max(worst, off);
      squares += off * off;
      turned = std::max(turned, rotation_vector(chain[nearest].linear().transpose() * measured[i].linear()).norm());
      if (i >= 10) speed = std::max(speed, (measured[i].translation() - measured[i - 10].translation()).norm() / 0.02);
    }
    const double rms = std::sqrt(squares / static_cast<double>(measured.size()));
    const double missed = (cell.tool().translation() - end.translation()).norm();
    std::printf(
        "%-28s %5.2f s, up to %5.1f mm/s: %.3f mm RMS, %.3f mm at most beside it, turned by %.2f mrad, ends %.3f mm "
        "off\n",
        name, outcome.duration, 1000 * speed, 1000 * rms, 1000 * worst, 1000 * turned, 1000 * missed);
    EXPECT_LT(1000 * worst, bound);
    EXPECT_LT(1000 * missed, 0.2);
    EXPECT_LT((arm.state().desired_pose.translation() - end.translation()).norm(), 1e-9);
  }

  SimulatedCell cell{kEmptyScene};
  Irb6 arm{cell};
  const std::vector<Pose> poses{at(-0.05, 0.08, 0.1), at(0.02, -0.02, -0.1), at(0.08, 0.06, 0.1), at(0.12, 0.0)};
  const PathLimits limits{.speed = 0.08, .acceleration = 0.4};
};

TEST_F(Path, Line) {
  CartesianLine line(arm, at(0.12, 0.06, 0.2), limits);
  follow("line", line, at(0.12, 0.06, 0.2), 1);
}

TEST_F(Path, Arc) {
  CartesianArc arc(arm, at(0, 0.08).translation(), at(0.1, 0, 0.2), limits);
  follow("arc", arc, at(0.1, 0, 0.2), 1);
}

TEST_F(Path, Circle) {
  const Circle round{.centre = at(-0.04, 0).translation(), .axis = {1, 0, 0}};
  CartesianArc arc(arm, round, limits);
  follow("circle of 60 mm", arc, at(-0.1, 0), 1);
}

TEST_F(Path, LinearSpline) {
  PoseSpline spline(arm, poses, SplineKind::linear, limits);
  follow("linear spline", spline, poses.back(), 1);
}

TEST_F(Path, CubicSpline) {
  PoseSpline spline(arm, poses, SplineKind::cubic, limits);
  follow("cubic spline", spline, poses.back(), 1);
}

TEST_F(Path, QuinticSpline) {
  PoseSpline spline(arm, poses, SplineKind::quintic, limits);
  follow("quintic spline", spline, poses.back(), 1);
}

TEST_F(Path, SplineByTimes) {
  std::vector<TimedPose> timed;
  for (const Pose& pose : poses) timed.push_back({pose, 2.5 * static_cast<double>(timed.size() + 1)});
  PoseSpline spline(arm, timed, SplineKind::quintic);
  follow("quintic spline, 4 x 2.5 s", spline, poses.back(), 1);
}

TEST_F(Path, Blended) {
  std::vector<BlendPoint> points;
  for (const Pose& pose : poses) points.push_back({pose, 0.03});
  BlendedPath path(arm, points, limits);
  follow("blended, radius 30 mm", path, poses.back(), 1);
}

TEST_F(Path, JointPath) {
  class JointPath path(arm, poses, 1.0);
  follow("joint path at full speed", path, poses.back(), 2);
}

}  // namespace
}  // namespace mrroc::test::path_test
