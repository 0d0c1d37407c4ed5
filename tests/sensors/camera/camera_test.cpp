#include "mrroc/sensors/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/camera/camera_sensor.hpp"
#include "sensors/entry.hpp"
#include "sensors/played_task.hpp"

namespace mrroc::camera_test {
namespace {

/// A sensor whose raw values are its channels: the client's side alone.
class MadeCamera final : public vsp::VirtualSensor {
 public:
  MadeCamera() { set_up(vsp::entry_of("camera", "eye"), 0.002); }
  std::vector<vsp::Channel> raw_channels() const override { return channels(); }
  void configure(const config::SensorEntry& /*entry*/, double /*period*/) override {}
  void aggregate(const vsp::RawReading& r, SensorReading& v) noexcept override { v.values = r.values; }
};

const std::string kNothing = "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
const std::string kVague = "20 1 0.1 0.2 0.3 0.5 0.5 0.5 0.5 0.01 0.02 0.03 0.1 320 240 0.25 0.0036\n";
const std::string kSharp = "40 1 0.1 0.2 0.3 0.5 0.5 0.5 0.5 0.001 0.001 0.002 0.1 320 240 0.25 0.0036\n";

class CameraTest : public testing::Test {
 protected:
  static std::string header() {
    std::string text = "# mrroc readings";
    for (const vsp::Channel& channel : MadeCamera().channels()) text += " " + channel.name;
    return text + "\n";
  }
  MadeCamera made_;
  vsp::PlayedTask task_{made_, "camera", header() + kNothing + kVague + kSharp};
  Camera eye_{task_, "eye"};
};

TEST_F(CameraTest, DetectionHasItsPoseAndQuality) {
  EXPECT_FALSE(eye_.detected());
  const Outcome outcome = Wait({}, {eye_}, Seen{eye_});
  EXPECT_EQ(outcome.end_tick, 20U);
  EXPECT_TRUE(outcome.by("eye sees it"));
  EXPECT_EQ(eye_.position(), Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(eye_.pose().translation(), eye_.position());
  // a rotation by a third of a turn about (1, 1, 1): x -> y -> z
  EXPECT_LT((eye_.pose().linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_EQ(eye_.position_deviation(), Eigen::Vector3d(0.01, 0.02, 0.03));
  EXPECT_EQ(eye_.rotation_deviation(), 0.1);
  EXPECT_EQ(eye_.pixel(), Eigen::Vector2d(320, 240));
  EXPECT_EQ(eye_.reprojection_error(), 0.25);
  EXPECT_EQ(eye_.area(), 0.0036);
}

TEST_F(CameraTest, SeenWithinWaitsForTheSharpReading) { EXPECT_EQ(Wait({}, {eye_}, Seen(eye_, 0.005)).end_tick, 40U); }

TEST_F(CameraTest, InvisibleTargetIsNaN) {
  eye_.initiate_reading(0);
  eye_.collect_reading();
  EXPECT_FALSE(eye_.detected());
  EXPECT_TRUE(eye_.position().array().isNaN().all());
  EXPECT_TRUE(std::isnan(eye_.pose().linear()(0, 0)));
  EXPECT_TRUE(std::isnan(eye_.area()));
}

TEST_F(CameraTest, SeenRefusesInvalidDeviations) {
  for (const double metres : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Seen(eye_, metres), NonFatalError);
}

}  // namespace
}  // namespace mrroc::camera_test
