#include "sim/errors/true_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mrroc::sim::true_errors_test {
namespace {

config::ErrorsEntry some_errors(std::uint32_t seed) {
  config::ErrorsEntry errors;
  errors.seed = seed;
  errors.base_position = 0.002;
  errors.joint_offset = 0.003;
  errors.gear_ratio = 0.01;
  errors.eccentricity = 0.004;
  errors.backlash = 0.001;
  errors.friction = 0.2;
  errors.force_bias = 2;
  return errors;
}

TEST(TrueErrors, AreWithinTheirSizesAndFillThem) {
  double largest = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const config::ErrorsEntry errors = some_errors(seed);
    const Pose base = error_of_base(errors, "arm");
    EXPECT_LE(base.translation().cwiseAbs().maxCoeff(), 0.002);
    EXPECT_EQ(base.linear(), Eigen::Matrix3d::Identity()) << "base_rotation is 0";
    const TrueJoint joint = errors_of_joint(errors, "arm", "elbow");
    EXPECT_LE(std::abs(joint.offset), 0.003);
    EXPECT_LE(std::abs(joint.gear), 0.01);
    for (const double share : {joint.amplitude / 0.004, joint.backlash / 0.001, joint.friction / 0.2}) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
    }
    largest = std::max(largest, base.translation().cwiseAbs().maxCoeff());
  }
  EXPECT_GT(largest, 0.0019);
}

TEST(TrueErrors, ChangeWithSeedAndDeviceOnly) {
  config::ErrorsEntry errors = some_errors(1);
  const Pose base = error_of_base(errors, "arm");
  const TrueJoint joint = errors_of_joint(errors, "arm", "elbow");
  errors.base_rotation = 0.1;
  errors.link_position = 0.1;
  errors.friction = 0;
  EXPECT_EQ(error_of_base(errors, "arm").translation(), base.translation());
  EXPECT_EQ(errors_of_joint(errors, "arm", "elbow").offset, joint.offset);
  EXPECT_NE(errors_of_joint(errors, "arm", "wrist").offset, joint.offset);
  EXPECT_NE(error_of_base(errors, "other").translation(), base.translation());
  errors.seed = 2;
  EXPECT_NE(error_of_base(errors, "arm").translation(), base.translation());
}

TEST(TrueErrors, JointInvertsWhatIsReported) {
  const TrueJoint joint = errors_of_joint(some_errors(5), "arm", "elbow");
  for (double q = -6; q <= 6; q += 0.37) {
    EXPECT_NEAR(joint.joint(joint.reported(q)), q, 1e-12);
    EXPECT_NEAR(joint.slope(q), (joint.reported(q + 1e-6) - joint.reported(q - 1e-6)) / 2e-6, 1e-8);
  }
}

}  // namespace
}  // namespace mrroc::sim::true_errors_test
