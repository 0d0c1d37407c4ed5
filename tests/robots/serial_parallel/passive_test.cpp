#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cases.hpp"
#include "legs.hpp"

namespace mrroc::serial_parallel::passive_test {
namespace {

using Eigen::Vector3d;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// the joint angles, from the directions of the legs
TEST(PassiveJoints, AnglesTurnUprightLegsToTheirHeads) {
  EXPECT_TRUE(rc::check([] {
    const Placement placement = any_placement();
    const auto legs = legs_at(placement);
    const PassiveAngles angles = tripod().passive_angles(placement);
    const auto leg = [](double pitch, double lean) -> Vector3d {
      return Eigen::AngleAxisd(pitch, Vector3d::UnitY()) * Eigen::AngleAxisd(lean, Vector3d::UnitX()) *
             Vector3d::UnitZ();
    };
    RC_ASSERT((leg(placement.swing, angles.lean_a) - legs[0].along().normalized()).norm() < 1e-12);
    RC_ASSERT((leg(angles.pitch_b, angles.lean_b) - legs[1].along().normalized()).norm() < 1e-12);
    RC_ASSERT((leg(placement.swing, angles.lean_c) - legs[2].along().normalized()).norm() < 1e-12);
  }));
}

TEST(PassiveJoints, EveryLimitIsChecked) {
  int refused_for_a = 0, refused_for_c = 0, refused_for_lean = 0, refused_for_pitch = 0, refused_for_both = 0;
  std::mt19937_64 random(20060106);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 100000; ++i) {
    const Placement placement{between(-1.2, 1.2), between(-1.2, 1.2), between(0.1, 0.5)};
    const PassiveAngles angles = tripod().passive_angles(placement);
    const double lean_b = std::abs(angles.lean_b) / kRadiansPerDegree, pitch_b = angles.pitch_b / kRadiansPerDegree;
    const bool a = std::abs(angles.lean_a) > 30 * kRadiansPerDegree,
               c = std::abs(angles.lean_c) > 30 * kRadiansPerDegree;
    const bool lean = lean_b > 30, pitch = pitch_b<-37, both = lean_b> 20 && pitch_b < -29;
    ASSERT_EQ(tripod().within_limits(placement, 0), !(a || c || lean || pitch || both));
    refused_for_a += a && !c && !lean && !pitch && !both;
    refused_for_c += c && !a && !lean && !pitch && !both;
    refused_for_lean += lean && !a && !c && !pitch && !both;
    refused_for_pitch += pitch && !a && !c && !lean && !both;
    refused_for_both += both && !a && !c && !lean && !pitch;
  }
  for (const int each : {refused_for_a, refused_for_c, refused_for_lean, refused_for_pitch, refused_for_both}) {
    EXPECT_GT(each, 10) << "for some posture only this limit decides";
  }
}

TEST(PassiveJoints, RequiresAnUprightPlatform) {
  EXPECT_TRUE(tripod().within_limits({.height = 0.28}, 0));
  EXPECT_FALSE(tripod().within_limits({.height = -0.28}, 0));
  EXPECT_FALSE(tripod().within_limits({.swing = std::numbers::pi, .height = 0.28}, 0));
  EXPECT_FALSE(tripod().within_limits({.swing = std::numeric_limits<double>::quiet_NaN(), .height = 0.28}, 0));
}

}  // namespace
}  // namespace mrroc::serial_parallel::passive_test
