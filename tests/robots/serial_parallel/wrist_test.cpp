#include "robots/serial_parallel/wrist.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "cases.hpp"

namespace mrroc::serial_parallel::wrist_test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

Vector3d any_angles() { return {any_between(-3, 3), any_between(-2, 2), any_between(-3, 3)}; }

TEST(Wrist, AnglesOfARotationReturnToThoseNear) {
  EXPECT_TRUE(rc::check([] {
    const Vector3d angles = any_angles();
    RC_PRE(std::abs(std::sin(angles[1])) > 1e-4);
    Vector3d found;
    RC_ASSERT(wrist_angles(wrist_rotation(angles), angles, found) == ErrorCode::none);
    RC_ASSERT((found - angles).cwiseAbs().maxCoeff() < 1e-10);
  }));
}

TEST(Wrist, SelectsTheNearerBranch) {
  EXPECT_TRUE(rc::check([] {
    const Vector3d angles = any_angles(), near = any_angles();
    RC_PRE(std::abs(std::sin(angles[1])) > 1e-4);
    Vector3d found;
    RC_ASSERT(wrist_angles(wrist_rotation(angles), near, found) == ErrorCode::none);
    RC_ASSERT((wrist_rotation(found) - wrist_rotation(angles)).norm() < 1e-10);
    RC_ASSERT((found - near).lpNorm<1>() <= (angles - near).lpNorm<1>() + 1e-9);
  }));
}

TEST(Wrist, StraightOrFoldedWristIsSingularAndKeepsItsRotation) {
  for (const double bend : {0.0, pi, -pi}) {
    const Vector3d angles(0.4, bend, 0.9), near(0.7, bend, 0.2);
    Vector3d found;
    ASSERT_EQ(wrist_angles(wrist_rotation(angles), near, found), ErrorCode::singular) << bend;
    EXPECT_LT((wrist_rotation(found) - wrist_rotation(angles)).norm(), 1e-12);
    EXPECT_EQ(found[0], 0.7);
    EXPECT_NEAR(found[1], bend, 1e-12);
    ASSERT_EQ(wrist_angles(wrist_rotation(angles), angles, found), ErrorCode::singular);
    EXPECT_LT((found - angles).norm(), 1e-12) << "the fixed point";
  }
}

TEST(Wrist, PathThroughTheStraightWristContinues) {
  Vector3d angles(0.3, 0.05, -0.2);
  for (double bend = 0.05; bend > -0.05; bend -= 0.0007) {
    const Vector3d wanted(0.3, bend, -0.2);
    wrist_angles(wrist_rotation(wanted), angles, angles);
    ASSERT_LT((angles - wanted).cwiseAbs().maxCoeff(), 1e-6) << bend;
  }
}

}  // namespace
}  // namespace mrroc::serial_parallel::wrist_test
