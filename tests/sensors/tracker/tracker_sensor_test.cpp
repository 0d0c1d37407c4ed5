#include "sensors/tracker/tracker_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "allocations.hpp"
#include "language/random_values.hpp"
#include "sensors/tracker/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d position_of(const SensorReading& v) { return {v.values[0], v.values[1], v.values[2]}; }
Quaterniond exp_rotation(const SensorReading& v) { return {v.values[3], v.values[4], v.values[5], v.values[6]}; }

TEST(TrackerSensor, ReportsTheTargetsPose) {
  EXPECT_TRUE(rc::check([] {
    TrackerSensor sensor = made_sensor();
    const Pose pose = fakes::random_pose(2, 3);
    Quaterniond q(pose.linear());
    if (fakes::pick(0, 1) == 0) q.coeffs() *= -1;  // the same rotation
    const SensorReading v = aggregated(sensor, raw(pose.translation(), q));
    RC_ASSERT((position_of(v) - pose.translation()).norm() == 0);
    RC_ASSERT((exp_rotation(v).toRotationMatrix() - pose.linear()).norm() < 1e-12);
    RC_ASSERT(v.values[3] >= 0);
  }));
}

TEST(TrackerSensor, NoiseHasItsStandardDeviationAndKeepsTheQuaternionNormalised) {
  TrackerSensor sensor = made_sensor("position_noise = 0.001\nrotation_noise = 0.01");
  constexpr int kCount = 20000;
  Vector3d way = Vector3d::Zero(), turn = Vector3d::Zero();
  for (int k = 0; k < kCount; ++k) {
    const SensorReading v = aggregated(sensor, raw({1, 2, 3}, Quaterniond::Identity(), static_cast<Tick>(k)));
    way += (position_of(v) - Vector3d(1, 2, 3)).cwiseAbs2();
    turn += rotation_vector(exp_rotation(v).toRotationMatrix()).cwiseAbs2();
    ASSERT_NEAR(exp_rotation(v).norm(), 1, 1e-12);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::sqrt(way[i] / kCount), 0.001, 0.00003);
    EXPECT_NEAR(std::sqrt(turn[i] / kCount), 0.01, 0.0003);
  }
}

TEST(TrackerSensor, InvisibleTargetIsNotReady) {
  TrackerSensor sensor = made_sensor();
  const SensorReading v = aggregated(sensor, raw({1, 2, 3}, Quaterniond(0, 0, 0, 0)));
  EXPECT_EQ(v.error.code, ErrorCode::sensor_not_ready);
  EXPECT_TRUE(std::isnan(v.values[0]));
}

TEST(TrackerSensor, RefusesNegativeNoise) {
  EXPECT_THROW(made_sensor("position_noise = -0.001"), config::ConfigurationError);
  EXPECT_THROW(made_sensor("rotation_noise = -0.001"), config::ConfigurationError);
}

TEST(TrackerSensor, DoesNotAllocateAfterItsConfiguration) {
  TrackerSensor sensor = made_sensor("position_noise = 0.001\nrotation_noise = 0.01");
  const RawReading r = raw({1, 2, 3}, Quaterniond::Identity());
  const std::size_t before = test::thread_allocations();
  const SensorReading v = aggregated(sensor, r);
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_NE(v.values[0], 1);
}

}  // namespace
}  // namespace mrroc::vsp
