// The same sensor in the EDP of a robot.
#include "edp/force/wrist_sensor.hpp"

#include <gtest/gtest.h>

#include "geometry/rigid_motion.hpp"
#include "sensors/force_torque/made_sensor.hpp"

namespace mrroc::vsp::wrist_sensor_test {
namespace {

constexpr const char* kGauges = "# mrroc readings gauge_0 gauge_1 gauge_2 gauge_3 gauge_4 gauge_5\n";
/// 10 N/V and 1 N m/V, gauge i for component i.
constexpr const char* kCalibration = R"(calibration = [10.0, 0, 0, 0, 0, 0,  0, 10, 0, 0, 0, 0,  0, 0, 10, 0, 0, 0,
  0, 0, 0, 1, 0, 0,  0, 0, 0, 0, 1, 0,  0, 0, 0, 0, 0, 1]
)";

/// A wrist that replays `lines` of gauge voltages.
class Wrist {
 public:
  Wrist(const std::string& toml, const std::string& lines) : entry_(entry_of("force_torque", "wrist", toml)) {
    entry_.source = "replay";
    entry_.replay = scratch_.write("gauges.txt", kGauges + lines);
    entry_.wrench_library = MRROC_BINARY_DIR "/lib/mrroc/sensors/force_torque.so";
    sensor_.emplace(edp::load_wrench_source(entry_), SourceContext{deployment_, entry_, 0, nullptr, kServoPeriod});
  }
  void carry(const Load& load) { sensor_->carry(load); }
  edp::WrenchReading read(Tick tick, const Pose& flange) { return sensor_->read(tick, &flange); }

 private:
  task_test::ScratchFolder scratch_;
  config::Deployment deployment_;
  config::SensorEntry entry_;
  std::optional<edp::WristSensor> sensor_;
};

TEST(ForceTorqueInTheEdp, UsesTheCalibrationToo) {
  Wrist wrist{kCalibration, "0 1 2 3 4 5 6\n"};
  const edp::WrenchReading reading = wrist.read(0, Pose::Identity());
  EXPECT_EQ(reading.error, ErrorCode::none);
  EXPECT_EQ(reading.wrench, (Wrench{{10, 20, 30, 4, 5, 6}}));
}

TEST(ForceTorqueInTheEdp, LearnsTheLoadWithoutATool) {
  // the flange points down: 1 kg pulls along its +z
  Wrist wrist{kCalibration, "0 0 0 0.981 0 -0.981 0\n"};
  const Pose down = pose_from_rpy({0.5, 0, 0.5}, {3.14159265358979323846, 0, 0});
  EXPECT_NEAR(wrist.read(0, down).wrench[2], 9.81, 1e-9);
  wrist.carry({1.0, {0.1, 0, 0}});
  EXPECT_LT(wrist.read(0, down).wrench.norm(), 1e-9);
}

TEST(ForceTorqueInTheEdp, SaturatedGaugeMakesBothWrenchesErrors) {
  Wrist wrist{std::string(kCalibration) + "gauge_limit = 5.0", "0 0 0 5 0 0 0\n1 0 0 4 0 0 0\n"};
  const edp::WrenchReading saturated = wrist.read(0, Pose::Identity());
  EXPECT_EQ(saturated.error, ErrorCode::sensor_out_of_range);
  EXPECT_EQ(saturated.wrench, (Wrench{{0, 0, 50, 0, 0, 0}}));
  EXPECT_EQ(wrist.read(1, Pose::Identity()).error, ErrorCode::none);
}

TEST(ForceTorqueInTheEdp, RotatesTheWeightIntoTheAxesOfARotatedSensor) {
  // the flange points down, the sensor on it is turned by 90 degrees about z: 1 kg pulls along its +z
  Wrist wrist{std::string(kCalibration) +
                  "tool_mass = 1.0\ntool_centre = [0.1, 0.0, 0.0]\nrotation = [0.0, 0.0, "
                  "1.5707963267948966]",
              "0 0 0 0.981 0 -0.981 0\n"};
  const edp::WrenchReading reading = wrist.read(0, pose_from_rpy({0.5, 0, 0.5}, {3.14159265358979323846, 0, 0}));
  EXPECT_EQ(reading.error, ErrorCode::none);
  EXPECT_LT(reading.wrench.norm(), 1e-9);
  // on its side, with its x axis down: the flange is turned by 90 degrees about y, so the weight is along flange x,
  // sensor -y
  Wrist aside{std::string(kCalibration) + "tool_mass = 1.0\nrotation = [0.0, 0.0, 1.5707963267948966]",
              "0 0 -0.981 0 0 0 0\n"};
  EXPECT_LT(aside.read(0, pose_from_rpy({0, 0, 0}, {0, 1.5707963267948966, 0})).wrench.norm(), 1e-9);
}

/// A plug-in of another kind: a robot's driver.
TEST(ForceTorqueInTheEdp, AnotherLibraryIsRefused) {
  config::SensorEntry entry = entry_of("force_torque", "wrist", "");
  for (const char* const library : {"/lib/mrroc/drivers/loopback.so", "/lib/mrroc/sensors/none.so", "/bin/mrroc"}) {
    entry.wrench_library = std::string(MRROC_BINARY_DIR) + library;
    EXPECT_THROW(edp::load_wrench_source(entry), SystemError) << library;
  }
}

}  // namespace
}  // namespace mrroc::vsp::wrist_sensor_test
