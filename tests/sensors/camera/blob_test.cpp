#include <cmath>
#include <numbers>

#include "sensors/camera/seen_world.hpp"

namespace mrroc::vsp::blob_test {
namespace {

constexpr int kPlacements = 50;

struct Errors {
  double worst = 0;        ///< m
  double worst_angle = 0;  ///< rad
  double normalised = 0;   ///< mean square of error / deviation, per component
};

/// The part, rotated about the vertical, anywhere in a field of 0.4 m x 0.3 m.
Errors errors_over_placements(SeenWorld& world, unsigned seed, double height = 0.004) {
  Draw draw(seed);
  Errors errors;
  for (int i = 0; i < kPlacements; ++i) {
    const double angle = draw(-std::numbers::pi, std::numbers::pi);
    const Pose pose = pose_from_rpy({draw(-0.2, 0.2), draw(-0.15, 0.15), height}, {0, 0, angle});
    world.place("part", pose);
    const SensorReading v = world.measure(static_cast<Tick>(i) + 1);
    EXPECT_TRUE(detected(v)) << pose.translation().transpose();
    const Eigen::Vector3d error = position_of(v) - pose.translation();
    EXPECT_NEAR(error.z(), 0, 1e-9) << "off the plane";
    errors.worst = std::max(errors.worst, error.norm());
    const Eigen::Vector3d x = orientation_of(v) * Eigen::Vector3d::UnitX();
    errors.worst_angle = std::max(errors.worst_angle, std::acos(std::min(1.0, std::abs(x.dot(pose.linear().col(0))))));
    errors.normalised += error.head<2>().cwiseQuotient(deviation_of(v).head<2>()).squaredNorm() / (2 * kPlacements);
    EXPECT_GE(x.x(), 0) << "the one of two directions that is nearer to the frame's x axis";
    EXPECT_NEAR(v.values[15], 0.06 * 0.04, 0.0002) << "area";
  }
  std::printf("worst %.2f mm, %.2f deg, normalised square %.2f\n", 1e3 * errors.worst,
              errors.worst_angle * 180 / std::numbers::pi, errors.normalised);
  return errors;
}

const std::string kBlobKeys = "plane = [0.0, 0.0, 0.004]\n";

TEST(Blob, CentroidIsWithinTwoMillimetresAtFiftyPlacementsFromAbove) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys);
  world.open();
  const Errors errors = errors_over_placements(world, 1);
  EXPECT_LT(errors.worst, 0.002);
  EXPECT_LT(errors.worst_angle, 0.05);
}

TEST(Blob, CentroidIsWithinTwoMillimetresAtFiftyPlacementsFromTheSide) {
  SeenWorld world(scene_of(std::string(kOblique) + kLabel), "plane = [0.0, 0.0, 0.0002]\n");
  world.open();
  const Errors errors = errors_over_placements(world, 2, 0.0002);
  EXPECT_LT(errors.worst, 0.002);
  EXPECT_LT(errors.worst_angle, 0.05);
  EXPECT_LT(errors.normalised, 3) << "the stated deviations are smaller than the errors";
  EXPECT_GT(errors.normalised, 0.3) << "the stated deviations are much larger than the errors";
}

TEST(Blob, CentroidIsWithinTwoMillimetresInASmallNoisyPicture) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys + "width = 320\nheight = 240\nnoise = 6.0\n");
  world.open();
  EXPECT_LT(errors_over_placements(world, 3).worst, 0.002);
}

TEST(Blob, PictureWithoutItsColourIsNoErrorAndReadsZero) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys + "hue = [90.0, 150.0]\n");
  world.open();
  const SensorReading v = world.measure();
  EXPECT_FALSE(detected(v));
  for (const double value : v.values) EXPECT_EQ(value, 0);
}

TEST(Blob, PartHalfInThePictureIsNotMeasured) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys);
  world.open();
  const double edge = 0.896 * std::tan(std::numbers::pi / 8);  // of the picture, on the part's upper side
  world.place("part", pose_from_rpy({0, edge, 0.004}, {0, 0, 0}));
  EXPECT_FALSE(detected(world.measure(1)));
  world.place("part", pose_from_rpy({0, edge - 0.025, 0.004}, {0, 0, 0}));
  EXPECT_TRUE(detected(world.measure(2)));
}

TEST(Blob, SpotsBelowTheMinimumAreaAreNoise) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys + "min_area = 5000\n");
  world.open();
  EXPECT_FALSE(detected(world.measure()));
}

TEST(Blob, ReadingIsInTheFrameThatTheKeyNames) {
  const Pose part = pose_from_rpy({0.11, -0.07, 0.004}, {0, 0, 0.4});
  config::RobotEntry arm;
  arm.name = "arm";
  arm.base = pose_from_rpy({1, 2, 0.5}, {0, 0, 1.2});
  const auto seen_in = [&](const std::string& keys) {
    SeenWorld world(scene_of(std::string(kOverhead) + kPart), keys, "", {arm});
    world.open();
    world.place("part", part);
    const SensorReading v = world.measure();
    EXPECT_TRUE(detected(v));
    return position_of(v);
  };
  const Eigen::Vector3d in_camera = seen_in("frame = 'camera'\nplane = [0.0, 0.0, 0.896]\n");
  EXPECT_LT((in_camera - Eigen::Vector3d(0.11, 0.07, 0.896)).norm(), 0.002) << "z along the view, y down";
  const Eigen::Vector3d plane = arm.base.inverse() * Eigen::Vector3d(0, 0, 0.004);
  const Eigen::Vector3d in_base = seen_in("frame = 'arm'\nplane = [" + std::to_string(plane.x()) + ", " +
                                          std::to_string(plane.y()) + ", " + std::to_string(plane.z()) + "]\n");
  EXPECT_LT((arm.base * in_base - part.translation()).norm(), 0.002);
  arm.measured_base = std::exchange(arm.base, Pose::Identity());
  const Eigen::Vector3d measured = seen_in("frame = 'arm'\nplane = [" + std::to_string(plane.x()) + ", " +
                                           std::to_string(plane.y()) + ", " + std::to_string(plane.z()) + "]\n");
  EXPECT_TRUE(measured.isApprox(in_base, 1e-9)) << "where a robot is as measured";
}

TEST(Blob, PoseOfACameraIsSetByKeys) {
  SeenWorld world(scene_of(kPart), kBlobKeys +
                                       "position = [0.0, 0.0, 0.9]\nrotation = [3.14159265358979, 0.0, 0.0]\n"
                                       "field_of_view = 0.7853981633974483\n");
  world.open();
  world.place("part", pose_from_rpy({0.1, 0.05, 0.004}, {0, 0, 0}));
  const SensorReading v = world.measure();
  EXPECT_TRUE(detected(v));
  EXPECT_LT((position_of(v) - Eigen::Vector3d(0.1, 0.05, 0.004)).norm(), 0.002);
  EXPECT_GT(v.values[12], 320) << "x to the right";
  EXPECT_LT(v.values[13], 240) << "y up in the world is up in the picture";
}

TEST(Blob, SameTicksGiveTheSameReadingsBitForBit) {
  const auto run = [] {
    SeenWorld world(scene_of(std::string(kOblique) + kPart), kBlobKeys + "noise = 5.0\nwidth = 320\nheight = 240\n");
    world.open();
    Draw draw(7);
    std::vector<double> values;
    for (Tick tick = 1; tick <= 10; ++tick) {
      world.place("part", pose_from_rpy({draw(-0.1, 0.1), draw(-0.1, 0.1), 0.004}, {0, 0, draw(-3, 3)}));
      const SensorReading v = world.measure(tick);
      values.insert(values.end(), v.values.begin(), v.values.end());
    }
    return values;
  };
  EXPECT_EQ(run(), run());
}

TEST(Blob, NoiseDependsOnTheTick) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys + "noise = 8.0\n");
  world.open();
  world.place("part", pose_from_rpy({0.1, 0.05, 0.004}, {0, 0, 0.3}));
  const SensorReading first = world.measure(1), second = world.measure(2);
  EXPECT_NE(first.values, second.values);
  EXPECT_LT((position_of(first) - position_of(second)).norm(), 0.001);
}

TEST(Blob, NewestStateIsMeasuredWithItsTick) {
  SeenWorld world(scene_of(std::string(kOverhead) + kPart), kBlobKeys);
  world.open();
  world.read(0);
  EXPECT_EQ(world.state(), SourceState::not_ready);
  world.store(90);
  EXPECT_EQ(world.read(100).tick, 90U);
  EXPECT_EQ(world.read(90 + 1501).tick, 0U) << "3 s at 2 ms";
  EXPECT_EQ(world.state(), SourceState::silent);
}

}  // namespace
}  // namespace mrroc::vsp::blob_test
