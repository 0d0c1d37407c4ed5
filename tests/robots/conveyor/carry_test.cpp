// The conveyor of the demo in its scene, with its EDP core: motion of the parts on the belt.
#include <gtest/gtest.h>

#include "robots/conveyor/conveyor_carries.hpp"

namespace mrroc {
namespace {

TEST_F(ConveyorCarries, PartsMoveAsFarAsThePositionedBelt) {
  const Eigen::Vector3d before = parts();
  edp_.go(0.2, 4000);
  run(4500);
  EXPECT_NEAR(travel(), 0.2, 1e-6);
  EXPECT_LT(slip(before, travel()), 1e-3);
  edp_.go(-0.05, 5000);
  run(5500);
  EXPECT_NEAR(travel(), -0.05, 1e-6);
  EXPECT_LT(slip(before, travel()), 1e-3) << "and back";
}

TEST_F(ConveyorCarries, PartsMoveAsFastAsTheVelocityControlledBelt) {
  constexpr double kSpeed = 0.04;
  edp_.go(kSpeed / 2, 500, kSpeed);
  run(250);
  for (int second = 1; second <= 4; ++second) {
    edp_.go(kSpeed * (second + 0.5), 500, kSpeed);
    run(500);
  }
  const Eigen::Vector3d before = parts();
  const double start = travel();
  EXPECT_NEAR(encoder().values[1], kSpeed, 1e-3);
  run(100);
  EXPECT_NEAR(travel() - start, kSpeed * 0.2, 1e-4);
  EXPECT_LT(slip(before, travel() - start), 1e-4);
}

TEST_F(ConveyorCarries, EncoderMatchesTheDriveWhileTheBeltsGeometryStays) {
  edp_.go(0.1, 2500);
  for (int i = 0; i < 30; ++i) {
    run(100);
    const RawReading reading = encoder();
    ASSERT_EQ(reading.count, 2U);
    EXPECT_EQ(reading.tick, now_);
    EXPECT_NEAR(reading.values[0], travel(), 2 * M_PI / 4000 / 2250) << "the drive rounds to increments";
    const sim::World& world = simulation_.world();
    EXPECT_EQ(world.data().xpos[3 * mj_name2id(&world.model(), mjOBJ_BODY, "belt/belt")], 0);
  }
  EXPECT_NEAR(travel(), 0.1, 1e-6);
}

TEST_F(ConveyorCarries, BeltFollowsItsPathWithinTheServosErrorAndCurrent) {
  edp_.go(0.25, 4900);  // 0.048 m/s at most
  double worst = 0, peak = 0;
  for (int i = 0; i < 5500; ++i) {
    run(1);
    worst = std::max(worst, std::abs(edp_.snapshot().desired.position[0] - travel()));
    peak = std::max(peak, std::abs(edp_.snapshot().current[0]));
  }
  std::printf("worst error %.2f mm, peak %.1f A\n", 1000 * worst, peak);
  EXPECT_LT(worst, 2.5e-4);
  EXPECT_LT(peak, belt().current_max);
  EXPECT_EQ(edp_.snapshot().fault.code, ErrorCode::none);
}

TEST_F(ConveyorCarries, BeltStandsUnderItsPartsWithTheDriveOff) {
  edp_.enable(false);
  run(500);
  const Eigen::Vector3d before = parts();
  const double start = travel();
  run(500);
  EXPECT_EQ(travel(), start);
  EXPECT_LT((parts() - before).norm(), 1e-6);
}

}  // namespace
}  // namespace mrroc
