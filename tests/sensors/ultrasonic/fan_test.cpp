#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "mrroc/errors.hpp"
#include "sensors/ultrasonic/made_sensor.hpp"
#include "sim/sensors.hpp"
#include "sim/world.hpp"
#include "sim/worlds.hpp"

namespace mrroc::vsp {
namespace {

constexpr const char* kFan = "rays = 7\nbeam_angle = 0.26";

SensorReading aggregated(UltrasonicSensor& sensor, const std::vector<double>& ranges) {
  RawReading r;
  r.count = static_cast<std::uint32_t>(ranges.size());
  std::copy(ranges.begin(), ranges.end(), r.values.begin());
  SensorReading v;
  v.channel_count = 2;
  sensor.aggregate(r, v);
  return v;
}

std::string refusal(const std::string& toml) {
  try {
    made_sensor(toml);
  } catch (const SystemError& error) {
    return error.what();
  }
  return "none";
}

TEST(UltrasonicFan, HasARawChannelPerRay) {
  EXPECT_EQ(made_sensor().raw_channels().size(), 1U);
  EXPECT_EQ(made_sensor().raw_channels()[0].name, "range");
  const auto channels = made_sensor(kFan).raw_channels();
  ASSERT_EQ(channels.size(), 7U);
  EXPECT_EQ(channels[0].name, "range_0");
  EXPECT_EQ(channels[6].name, "range_6");
}

TEST(UltrasonicFan, ReturnsTheNearestOfItsRays) {
  UltrasonicSensor sensor = made_sensor(kFan);
  EXPECT_EQ(aggregated(sensor, {-1, 2, 1.5, 0.7, 3, -1, 0.9}).values[0], 0.7);
  EXPECT_EQ(aggregated(sensor, {-1, -1, -1, -1, -1, -1, -1}).values[1], 0);
  EXPECT_EQ(aggregated(sensor, {-1, -1, 5, 5, 4.1, -1, -1}).values[1], 0);
}

TEST(UltrasonicFan, InvalidRangeOrARayInTheDeadZoneIsAnError) {
  UltrasonicSensor sensor = made_sensor(kFan);
  EXPECT_EQ(aggregated(sensor, {1, 1, 1, 1, 1, 1, 0.01}).error.code, ErrorCode::sensor_out_of_range);
  EXPECT_EQ(aggregated(sensor, {1, 1, 1, 1, -0.5, 1, 1}).error.code, ErrorCode::sensor_hardware);
  EXPECT_EQ(aggregated(sensor, {1, 1, 1, 1, 1, 1, 1}).error.code, ErrorCode::none);
}

TEST(UltrasonicFan, RefusesAnInconsistentBeam) {
  EXPECT_NE(refusal("rays = 7").find("sensors.gate.beam_angle: 0 rad of 7 rays"), std::string::npos);
  EXPECT_NE(refusal("beam_angle = 0.2").find("rad of one ray, expected the key 'rays'"), std::string::npos);
  EXPECT_NE(refusal("rays = 2.5\nbeam_angle = 0.2").find("expected a whole number"), std::string::npos);
  EXPECT_NE(refusal("rays = 2\nbeam_angle = 0.2\nmax_incidence = 0.1").find("at least 3 rays"), std::string::npos);
  EXPECT_EQ(refusal("rays = 3\nbeam_angle = 0.2\nmax_incidence = 0.1"), "none");
  EXPECT_THROW(made_sensor("rays = 17\nbeam_angle = 0.2"), config::ConfigurationError);
  EXPECT_THROW(made_sensor("rays = 0"), config::ConfigurationError);
}

/// A post of radius 0.025 m that stands 1 m before the sensor `gate`, `offset` m beside the axis of its fan.
sim::World post_beside_the_axis(double offset) {
  std::ostringstream scene;
  scene << "<mujoco><compiler angle='radian'/><worldbody><body name='post' pos='1 " << offset
        << " 0'><geom type='cylinder' size='0.025 0.4'/></body><body name='gate'>";
  for (int i = 0; i < 7; ++i) {
    const double angle = 0.26 * (i / 6.0 - 0.5);
    scene << "<site name='" << i << "' zaxis='" << std::cos(angle) << " " << std::sin(angle) << " 0'/>";
  }
  scene << "</body></worldbody><sensor>";
  for (int i = 0; i < 7; ++i) scene << "<rangefinder name='gate/" << i << "' site='" << i << "'/>";
  scene << "</sensor></mujoco>";
  const task_test::ScratchFolder scratch;
  return {sim::compose_texts(scratch, scene.str()), 0.002, 0.001};
}

TEST(UltrasonicFan, DetectsATargetInItsConeThatASingleRayMisses) {
  for (const double offset : {-0.20, -0.14, -0.05, 0.0, 0.1, 0.14, 0.20}) {
    sim::World world = post_beside_the_axis(offset);
    world.start();
    RawReading slot;
    sim::SensorSource{world.model(), "gate", "ultrasonic", ""}.read(world.data(), slot);
    ASSERT_EQ(slot.count, 7U);
    UltrasonicSensor sensor = made_sensor(kFan);
    const SensorReading v = aggregated(sensor, {slot.values.begin(), slot.values.begin() + 7});
    // the post's centre is at the angle atan(offset): within half the cone and its own half width?
    const bool inside = std::atan(std::abs(offset)) < 0.13 + std::asin(0.025 / std::hypot(1, offset));
    EXPECT_EQ(v.values[1], inside ? 1 : 0) << offset;
    if (inside) {
      EXPECT_NEAR(v.values[0], std::hypot(1, offset) - 0.025, 0.012) << offset;
    }
    EXPECT_EQ(slot.values[3] >= 0, std::abs(offset) < 0.025) << "the ray on the axis";
  }
}

}  // namespace
}  // namespace mrroc::vsp
