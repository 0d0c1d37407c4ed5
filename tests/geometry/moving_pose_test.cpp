#include "geometry/moving_pose.hpp"

#include "geometry/rigid_motion.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc {
namespace {

using fakes::check_property;
using fakes::random_pose;
using fakes::random_vector;

constexpr int kCases = 1000;
constexpr double kStep = 1e-4;  // s

MovingPose random_motion() {
  MovingPose moving;
  moving.pose = random_pose(1, 3);
  moving.twist << random_vector(1), random_vector(1);
  moving.rate << random_vector(2), random_vector(2);
  return moving;
}

TEST(MovingPose, FollowsItsTwistAndRate) {
  check_property(kCases, [] {
    const MovingPose moving = random_motion();
    const Pose before = moving.after(-kStep), after = moving.after(kStep);
    RC_ASSERT(moving.after(0).isApprox(moving.pose, 1e-12));
    const Eigen::Vector3d velocity = (after.translation() - before.translation()) / (2 * kStep);
    const Eigen::Vector3d turning = rotation_vector(after.linear() * before.linear().transpose()) / (2 * kStep);
    RC_ASSERT((velocity - moving.twist.head<3>()).norm() < 1e-6);
    RC_ASSERT((turning - moving.twist.tail<3>()).norm() < 1e-6);
    const Eigen::Vector3d acceleration =
        (after.translation() - 2 * moving.pose.translation() + before.translation()) / (kStep * kStep);
    RC_ASSERT((acceleration - moving.rate.head<3>()).norm() < 1e-5);
  });
}

TEST(MovingPose, RateInItsOwnAxesIsThatOfTheComponents) {
  check_property(kCases, [] {
    const MovingPose moving = random_motion();
    const auto components = [&](double t) {
      return rotate_twist(moving.after(t).linear().transpose(), moving.twist + t * moving.rate);
    };
    const OwnMotion own = in_own_axes(moving);
    RC_ASSERT((own.twist - components(0)).norm() < 1e-12);
    RC_ASSERT((own.rate - (components(kStep) - components(-kStep)) / (2 * kStep)).norm() < 1e-6);
  });
}

TEST(MovingPose, OwnAxesAndBaseAxesAreInverse) {
  check_property(kCases, [] {
    const MovingPose moving = random_motion(), back = in_base_axes(moving.pose, in_own_axes(moving));
    RC_ASSERT((back.twist - moving.twist).norm() < 1e-12);
    RC_ASSERT((back.rate - moving.rate).norm() < 1e-12);
  });
}

}  // namespace
}  // namespace mrroc
