#include "config/axis_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "config/message_of.hpp"
#include "config/robot_parameters_file.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::axis_file_test {
namespace {

using Interface = DriveParameters::Interface;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

class AxisFile : public testing::Test {
 protected:
  static std::string text(const std::string& drives, const std::string& more = "") {
    return "type = \"arm\"\nhome = [0.5]\n[drives]\n" + drives +
           "\n[[axes]]\nname = \"pan\"\nposition_min = -2\nposition_max = 3\nvelocity_max = 1\nacceleration_max = 5\n"
           "jerk_max = 50\n" +
           more;
  }
  RobotParameters read(const std::string& text) {
    return read_robot_parameters(Table::load(scratch_.write("r.toml", text)));
  }
  std::string message(const std::string& text) {
    return message_of(scratch_.path(), [&] { read(text); });
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(AxisFile, DrivesThatRegulateOnTheirOwnNeedLimitsOnly) {
  const RobotParameters robot = read(text("regulates = \"itself\""));
  EXPECT_TRUE(robot.drives.regulate_themselves());
  EXPECT_EQ(robot.drives.interface, Interface::position);
  EXPECT_EQ(robot.drives.bandwidth, kUsualBandwidth);
  const AxisParameters& axis = robot.axes.front();
  EXPECT_EQ(axis.motor_min, -2);
  EXPECT_EQ(axis.motor_max, 3);
  EXPECT_EQ(axis.motor_synchro, 0);
  EXPECT_EQ(axis.encoder_increments, kUsualIncrements);
  EXPECT_EQ(axis.torque_max, kUnlimited);
  EXPECT_EQ(axis.current_max, kUnlimited);
  EXPECT_EQ(axis.following_error_max, kUsualError);
  EXPECT_EQ(axis.stuck_current, kUnlimited);
  EXPECT_EQ(axis.regulator_b0, 0);
}

TEST_F(AxisFile, KeysThatAreThereCount) {
  const AxisParameters axis =
      read(text("regulates = \"itself\"",
                "torque_max = 28\nmotor_min = -100\nmotor_max = 90\nmotor_synchro = 4\nencoder_increments = 1000\n"
                "following_error_max = 0.3\nrotor_inertia = 0.01\nviscous_friction = 0.1\ntorque_constant = 2\n"))
          .axes.front();
  EXPECT_EQ(axis.torque_max, 28);
  EXPECT_EQ(axis.current_max, 28);
  EXPECT_EQ(axis.motor_min, -100);
  EXPECT_EQ(axis.motor_synchro, 4);
  EXPECT_EQ(axis.encoder_increments, 1000);
  EXPECT_EQ(axis.following_error_max, 0.3);
  EXPECT_EQ(axis.stuck_current, 0) << "its rotor is known";
  EXPECT_EQ(axis.torque_constant, 2);
}

TEST_F(AxisFile, InterfaceVelocityHasAPositionGain) {
  const DriveParameters usual = read(text("regulates = \"itself\"\ninterface = \"velocity\"\nbandwidth = 10")).drives;
  EXPECT_EQ(usual.interface, Interface::velocity);
  EXPECT_NEAR(usual.position_gain, 0.2 * 2 * std::numbers::pi * 10, 1e-12);
  EXPECT_EQ(read(text("regulates = \"itself\"\ninterface = \"velocity\"\nposition_gain = 7")).drives.position_gain, 7);
}

TEST_F(AxisFile, TheFrameworkRegulatesUnlessSaidOtherwise) {
  EXPECT_TRUE(message(text("regulates = \"framework\"")).starts_with("r.toml:5: axes[0].motor_min: missing"));
}

/// A motor of an arm whose regulators the framework designs.
constexpr const char* kMotor =
    "motor_min = -2\nmotor_max = 3\nmotor_synchro = 0\ncurrent_max = 28\nfollowing_error_max = 0.2\n"
    "torque_constant = 1\nrotor_inertia = 0.1\nviscous_friction = 0.1\n";

TEST_F(AxisFile, RegulatorsMayBeLeftToTheFramework) {
  const std::string drives = "regulates = \"framework\"\nbandwidth = 6", chain = "[chain]\n";
  const AxisParameters axis = read(text(drives, std::string{kMotor} + "inertia = [0.5, 2]\n" + chain)).axes.front();
  EXPECT_EQ(axis.regulator_bandwidth, 6);
  EXPECT_EQ(axis.inertia_min, 0.5);
  EXPECT_EQ(axis.inertia_max, 2);
  EXPECT_EQ(read(text(drives, std::string{kMotor} + "inertia = [0.5, 2]\nregulator_bandwidth = 3\n" + chain))
                .axes.front()
                .regulator_bandwidth,
            3);
  const AxisParameters given =
      read(text(drives, std::string{kMotor} +
                            "regulator_a = 0.4\nregulator_b0 = 1\nregulator_b1 = 0.9\nregulator_eps = 0.01\n"
                            "regulator_current_gain = 1\n" +
                            chain))
          .axes.front();
  EXPECT_EQ(given.regulator_bandwidth, 0);
  EXPECT_EQ(given.regulator_b0, 1);
  EXPECT_TRUE(message(text(drives, std::string{kMotor} + "inertia = [0.5, 2]\n" + chain +
                                       "[regulators.soft]\npan = { eps = 0.01 }\n"))
                  .starts_with("r.toml:24: regulators.soft.pan.a: missing"));
  EXPECT_TRUE(message(text(drives, kMotor + chain)).starts_with("r.toml:6: axes[0].inertia: missing"));
  EXPECT_TRUE(message(text(drives, std::string{kMotor} + "regulator_a = 0.4\n" + chain))
                  .starts_with("r.toml:6: axes[0].regulator_b0: missing"));
  EXPECT_TRUE(message(text(drives, kMotor)).starts_with("r.toml:5: drives.bandwidth: regulators are designed"));
  EXPECT_TRUE(message(text(drives, std::string{kMotor} + "inertia = [2, 1]\n" + chain))
                  .starts_with("r.toml:21: axes[0].inertia: 2 is above 1"));
}

TEST_F(AxisFile, RefusesInvalidKeys) {
  EXPECT_TRUE(message(text("regulates = \"itelf\"")).starts_with("r.toml:4: drives.regulates: unknown value 'itelf'"));
  EXPECT_TRUE(message(text("bandwidth = 20")).starts_with("r.toml:3: drives.regulates: missing"));
  EXPECT_TRUE(message(text("regulates = \"itself\"\nbandwidth = 0")).starts_with("r.toml:5: drives.bandwidth: 0"));
  EXPECT_TRUE(message(text("regulates = \"itself\"\ninterface = \"torque\""))
                  .starts_with("r.toml:5: drives.interface: unknown value 'torque'"));
  EXPECT_TRUE(message(text("regulates = \"itself\"\nposition_gain = 3"))
                  .starts_with("r.toml:5: drives.position_gain: unknown"));
  EXPECT_TRUE(message(text("regulates = \"itself\"", "torque_max = 0\n")).starts_with("r.toml:12: axes[0].torque_max"));
  EXPECT_TRUE(
      message(text("regulates = \"itself\"", "motor_min = 4\n")).starts_with("r.toml:5: axes[0].motor_max: missing"));
}

}  // namespace
}  // namespace mrroc::config::axis_file_test
