#include "cli/ros2/sensor_frames.hpp"

#include <gtest/gtest.h>

namespace mrroc::cli::sensor_frames_test {
namespace {

std::optional<messages::geometry_msgs::TransformStamped> frame_of(const config::SensorEntry& sensor) {
  return sensor_frame(
      sensor, [](const std::string& robot) { return robot + "_flange"; }, "world");
}

TEST(SensorFrames, SensorOnARobotIsBelowItsFlange) {
  config::SensorEntry sensor;
  sensor.name = "wrist";
  sensor.robot = "arm";
  sensor.numbers = {{"position", {0, 0, 0.09}}, {"rotation", {0, 0, M_PI / 2}}};
  const auto frame = frame_of(sensor);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->header.frame_id, "arm_flange");
  EXPECT_EQ(frame->child_frame_id, "wrist");
  EXPECT_EQ(frame->transform.translation.z, 0.09);
  EXPECT_NEAR(frame->transform.rotation.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(frame->transform.rotation.w, std::sqrt(0.5), 1e-12);
}

TEST(SensorFrames, SensorWithoutARobotIsInTheWorld) {
  config::SensorEntry sensor;
  sensor.name = "eye";
  sensor.numbers = {{"position", {1, 2, 3}}, {"rotation", {}}};
  EXPECT_EQ(frame_of(sensor)->header.frame_id, "world");
  EXPECT_EQ(frame_of(sensor)->transform.translation.y, 2);
}

TEST(SensorFrames, CalibratedMountComesFirst) {
  config::SensorEntry sensor;
  sensor.name = "eye";
  sensor.robot = "arm";
  sensor.numbers = {
      {"position", {1, 2, 3}}, {"rotation", {0, 0, 0}}, {"mount_position", {4, 5, 6}}, {"mount_rotation", {}}};
  EXPECT_EQ(frame_of(sensor)->transform.translation.x, 4);
}

TEST(SensorFrames, SensorWithoutAPlaceHasNone) {
  config::SensorEntry sensor;
  sensor.name = "clock";
  EXPECT_FALSE(frame_of(sensor));
  sensor.numbers = {{"position", {}}, {"rotation", {}}, {"rate", {500}}};
  EXPECT_FALSE(frame_of(sensor)) << "not given";
}

}  // namespace
}  // namespace mrroc::cli::sensor_frames_test
