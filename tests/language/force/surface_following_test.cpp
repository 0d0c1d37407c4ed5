#include "mrroc/generators/surface_following.hpp"

#include <limits>

#include "language/force/force_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/move.hpp"

namespace mrroc::surface_following_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::ForceFlyer;
using fakes::pick;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The tool with its z axis down, turned by `yaw` about it, with its tip at `place`.
Pose down(const Vector3d& place, double yaw = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  pose.linear() = exp_rotation({std::numbers::pi, 0, 0}) * exp_rotation({0, 0, yaw});
  return pose;
}

/// Angle of the tool's z axis from the inward normal of a surface, rad.
double lean(const Pose& tool, const Vector3d& outward) {
  return std::acos(std::clamp(-tool.linear().col(2).dot(outward), -1.0, 1.0));
}

TEST(SurfaceFollowing, PressesAnInclinedPlaneWhileMovingAlongIt) {
  check_property(60, [] {
    const Vector3d normal(0.1 * pick(-3, 3), 0.1 * pick(-3, 3), 1);
    const double force = pick(3, 20), speed = 0.005 * pick(1, 10), angle = 0.01 * pick(0, 628);
    ForceFlyer task(down({0, 0, 0.004}, 0.01 * pick(-300, 300)), fakes::plane({0, 0, 0}, normal));
    const Vector3d velocity(speed * std::cos(angle), speed * std::sin(angle), 0);
    const Outcome end =
        Move({*task.arm}, {},
             SurfaceFollowing{*task.arm, force, velocity}.until(Travelled{*task.arm, 0.06} || ElapsedSteps{3000}));
    RC_ASSERT(end.by<Travelled>());
    // a surface that recedes at u is pressed with u / b less, one that approaches with u / b more
    const Vector3d way = task.arm->state().pose.linear() * velocity;
    const double climb = -normal.head<2>().dot(way.head<2>()) / normal.z();  // of the surface under the tip
    const double pressed = -task.arm->state().wrench[2];
    RC_ASSERT(std::abs(pressed - (force + climb / 0.01)) < 0.05 * force + 0.1);
    RC_ASSERT(std::abs(task.twist.head<2>().norm() - speed) < 1e-6);
  });
}

TEST(SurfaceFollowing, TurnsTheToolToTheNormalOfAnInclinedPlane) {
  check_property(60, [] {
    const Vector3d normal = Vector3d(0.1 * pick(-4, 4), 0.1 * pick(-4, 4), 1).normalized();
    const double angle = 0.01 * pick(0, 628);
    ForceFlyer task(down({0, 0, 0.002}, 0.01 * pick(-300, 300)), fakes::plane({0, 0, 0}, normal));
    SurfaceContact contact;
    contact.turn_to_normal = true;
    const Vector3d velocity(0.02 * std::cos(angle), 0.02 * std::sin(angle), 0);
    Move({*task.arm}, {}, SurfaceFollowing{*task.arm, 8, velocity, contact}.until(ElapsedSteps{250}));
    RC_ASSERT(lean(task.pose, normal) < 0.01);
    RC_ASSERT(std::abs(task.arm->state().wrench[2] + 8) < 0.2);
  });
}

TEST(SurfaceFollowing, TurnsTheToolAlongACurvedSurface) {
  check_property(30, [] {
    const double radius = 0.1 * pick(2, 8), speed = 0.01 * pick(1, 4), angle = 0.01 * pick(0, 628);
    const Vector3d centre(0, 0, -radius);
    ForceFlyer task(down({0.02, -0.01, 0.002}), fakes::ball(centre, radius));
    SurfaceContact contact;
    contact.turn_to_normal = true;
    const Vector3d velocity(speed * std::cos(angle), speed * std::sin(angle), 0);
    Move({*task.arm}, {},
         SurfaceFollowing{*task.arm, 10, velocity, contact}.until(Travelled{*task.arm, 0.5 * radius} ||
                                                                  ElapsedSteps{3000}));
    // the bound in the header, and the addition of a step
    const double lag = speed / radius * (1 / contact.turning_gain + SurfaceFollowing::kSmoothing);
    RC_ASSERT(lean(task.pose, (task.pose.translation() - centre).normalized()) < 1.3 * lag + 0.01);
    RC_ASSERT(lean(task.pose, (task.pose.translation() - centre).normalized()) <
              0.25 * lean(down(Vector3d::Zero()), (task.pose.translation() - centre).normalized()));
    RC_ASSERT(std::abs(task.arm->state().wrench[2] + 10) < 1);
  });
}

TEST(SurfaceFollowing, FollowsAPathAndEndsAtItsEnd) {
  check_property(40, [] {
    const Vector3d normal(0.1 * pick(-2, 2), 0.1 * pick(-2, 2), 1);
    const auto on_plane = [&](double x, double y) {
      return Vector3d(x, y, -(normal.x() * x + normal.y() * y) / normal.z());
    };
    std::vector<Vector3d> path{{0, 0, 0}};
    for (int i = pick(1, 4); i > 0; --i) {
      const double angle = 0.01 * pick(0, 628), length = 0.005 * pick(2, 10);
      path.push_back({path.back().x() + length * std::cos(angle), path.back().y() + length * std::sin(angle), 0});
    }
    const double speed = 0.005 * pick(1, 8);
    // begins beside the first point
    ForceFlyer task(down({0.001 * pick(-3, 3), 0.001 * pick(-3, 3), 0.003}), fakes::plane({0, 0, 0}, normal));
    SurfaceFollowing follow(*task.arm, 10, path, speed);
    double farthest = 0, fastest = 0, force_off = 0;
    task.on_tick = [&](Tick, const Wrench& wrench) {
      fastest = std::max(fastest, task.twist.head<2>().norm());
      if (follow.way() < 0.01) return;  // it has reached the path
      double nearest = 1;
      for (std::size_t i = 1; i < path.size(); ++i) {
        const Eigen::Vector2d a = path[i - 1].head<2>(), leg = path[i].head<2>() - a,
                              p = task.pose.translation().head<2>();
        const double u = std::clamp((p - a).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - u * leg).norm());
      }
      farthest = std::max(farthest, nearest);
      force_off = std::max(force_off, std::abs(wrench[2] + 10));
    };
    const Outcome end = Move({*task.arm}, {}, follow.until(ElapsedSteps{10000}));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT((task.pose.translation() - on_plane(path.back().x(), path.back().y())).head<2>().norm() <
              2 * SurfaceFollowing::kTolerance);
    RC_ASSERT(follow.way() == follow.length());
    // reversing at a corner takes v^2 / 2 a and two steps; up to 3 mm of the offset at the start remain
    RC_ASSERT(farthest < speed * speed / (2 * SurfaceContact{}.acceleration) + 0.04 * speed + 0.003);
    RC_ASSERT(fastest <= 2.01 * speed);
    RC_ASSERT(force_off < 10);
  });
}

TEST(SurfaceFollowing, MovesAlongOnlyInContact) {
  // a plate that ends at y = 0.03: beyond it the tool descends slowly and moves no farther
  fakes::SpringSurface plate = fakes::plane({0, 0, 0}, {0, 0, 1});
  ForceFlyer task(down({0, 0, 0.01}, 0), [&](const Pose& tool, const Twist& twist) {
    return tool.translation().y() < 0.03 ? plate(tool, twist) : Wrench{Wrench::Zero()};
  });
  double fastest_down = 0, along_in_the_air = 0;
  task.on_tick = [&](Tick, const Wrench& wrench) {
    const Vector3d velocity = task.pose.linear() * task.twist.head<3>();
    fastest_down = std::max(fastest_down, -velocity.z());
    if (wrench.isZero(0) && task.pose.translation().y() < 0.001)
      along_in_the_air = std::max(along_in_the_air, velocity.y());
  };
  Move({*task.arm}, {}, SurfaceFollowing{*task.arm, 8, {0, -0.02, 0}}.until(ElapsedSteps{300}));
  EXPECT_EQ(along_in_the_air, 0) << "before it has descended";
  EXPECT_GT(task.pose.translation().y(), 0.03);
  EXPECT_LT(task.pose.translation().y(), 0.03 + 0.02 * 0.4);
  EXPECT_LT(task.pose.translation().z(), -0.005);
  EXPECT_NEAR(task.twist.head<2>().norm(), 0, 1e-9);
  EXPECT_NEAR(task.twist.z(), 0.01, 1e-6) << "the approach speed";
}

TEST(SurfaceFollowing, WeightOfTheLoadIsNoContact) {
  const Load load{2, {0, 0, 0.05}};
  const fakes::SpringSurface plate = fakes::plane({0, 0, 0}, {0, 0, 1});
  ForceFlyer task(down({0, 0, 0.003}), [&](const Pose& tool, const Twist& twist) {
    return Wrench{plate(tool, twist) + weight_of(load, tool.linear())};
  });
  SurfaceContact contact;
  contact.load = load;
  Move({*task.arm}, {}, SurfaceFollowing{*task.arm, 10, {0.02, 0, 0}, contact}.until(ElapsedSteps{200}));
  EXPECT_NEAR(2000 * -task.pose.translation().z(), 10, 0.1);
  EXPECT_GT(task.pose.translation().x(), 0.05);
}

TEST(SurfaceFollowing, RefusesInvalidArguments) {
  ForceFlyer task(down({0, 0, 0}), fakes::plane({0, 0, 0}, {0, 0, 1}));
  const auto with = [&](double force, const Vector3d& velocity, const SurfaceContact& contact = {}) {
    SurfaceFollowing{*task.arm, force, velocity, contact};
  };
  EXPECT_NO_THROW(with(5, {0.01, 0, 0}));
  EXPECT_NO_THROW(with(5, {0, 0, 0})) << "pressing only";
  EXPECT_THROW(with(5, {0, 0, 0.01}), NonFatalError);
  EXPECT_THROW(with(5, {0, kNan, 0}), NonFatalError);
  for (const double bad : {0.0, -1.0, kNan}) {
    EXPECT_THROW(with(bad, {0.01, 0, 0}), NonFatalError);
    EXPECT_THROW(with(5, {0.01, 0, 0}, {.admittance = bad}), NonFatalError);
    EXPECT_THROW(with(5, {0.01, 0, 0}, {.approach_speed = bad}), NonFatalError);
    EXPECT_THROW(with(5, {0.01, 0, 0}, {.acceleration = bad}), NonFatalError);
    EXPECT_THROW(with(5, {0.01, 0, 0}, {.angular_speed = bad}), NonFatalError);
    EXPECT_THROW((SurfaceFollowing{*task.arm, 5, {{0, 0, 0}, {1, 0, 0}}, bad}), NonFatalError);
  }
  EXPECT_THROW((SurfaceFollowing{*task.arm, 5, {Vector3d{0, 0, 0}}, 0.01}), NonFatalError);
  EXPECT_THROW((SurfaceFollowing{*task.arm, 5, {{0, 0, 0}, {0, 0, 0}}, 0.01}), NonFatalError);
  EXPECT_THROW((SurfaceFollowing{*task.arm, 5, {{0, 0, 0}, {0, kNan, 0}}, 0.01}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::surface_following_test
