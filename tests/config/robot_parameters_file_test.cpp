#include "config/robot_parameters_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::robot_parameters_file_test {
namespace {

/// The keys of a valid axis, one per line; line 4 of `robot_text` is the first.
constexpr std::string_view kAxis = R"(name = "column"
position_min = -2.5
position_max = 2.75
velocity_max = 1.5
acceleration_max = 5
jerk_max = 50
motor_min = -470
motor_max = 450
motor_synchro = -15.9
encoder_increments = 2000
current_max = 15
following_error_max = 1.5
regulator_a = 0.41
regulator_b0 = 1.55
regulator_b1 = 1.50
regulator_eps = 0.01
regulator_output_max = 180
regulator_current_gain = 0.2
torque_constant = 0.105
rotor_inertia = 1.5e-4
viscous_friction = 0.02
)";

class RobotParametersFileTest : public testing::Test {
 protected:
  static std::string robot_text(const std::string& axis = std::string(kAxis), const std::string& home = "[0.5]") {
    return "type = \"irb6\"\nhome = " + home + "\n[[axes]]\n" + axis;
  }

  /// `axis` with the line that starts with `key` replaced.
  static std::string with(const std::string& key, const std::string& line, std::string axis = std::string(kAxis)) {
    const auto begin = axis.find(key + " = ");
    return axis.replace(begin, axis.find('\n', begin) - begin, line);
  }

  RobotParameters read(const std::string& text) {
    return read_robot_parameters(Table::load(scratch_.write("r.toml", text)));
  }

  std::string message(const std::string& text) {
    return message_of(scratch_.path(), [&] { read(text); });
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(RobotParametersFileTest, ReadsEveryNumber) {
  const RobotParameters robot = read(robot_text());
  EXPECT_EQ(robot.type, "irb6");
  ASSERT_EQ(robot.home.size(), 1);
  EXPECT_EQ(robot.home[0], 0.5);
  ASSERT_EQ(robot.axes.size(), 1u);
  const AxisParameters& axis = robot.axes[0];
  EXPECT_EQ(axis.name, "column");
  EXPECT_EQ(axis.position_min, -2.5);
  EXPECT_EQ(axis.position_max, 2.75);
  EXPECT_EQ(axis.velocity_max, 1.5);
  EXPECT_EQ(axis.acceleration_max, 5);
  EXPECT_EQ(axis.jerk_max, 50);
  EXPECT_EQ(axis.motor_min, -470);
  EXPECT_EQ(axis.motor_max, 450);
  EXPECT_EQ(axis.motor_synchro, -15.9);
  EXPECT_EQ(axis.encoder_increments, 2000);
  EXPECT_EQ(axis.current_max, 15);
  EXPECT_EQ(axis.following_error_max, 1.5);
  EXPECT_EQ(axis.regulator_a, 0.41);
  EXPECT_EQ(axis.regulator_b0, 1.55);
  EXPECT_EQ(axis.regulator_b1, 1.50);
  EXPECT_EQ(axis.regulator_eps, 0.01);
  EXPECT_EQ(axis.regulator_output_max, 180);
  EXPECT_EQ(axis.regulator_current_gain, 0.2);
  EXPECT_EQ(axis.torque_constant, 0.105);
  EXPECT_EQ(axis.rotor_inertia, 1.5e-4);
  EXPECT_EQ(axis.viscous_friction, 0.02);
}

TEST_F(RobotParametersFileTest, SomeKeysAreOptional) {
  EXPECT_EQ(read(robot_text(with("encoder_increments", ""))).axes[0].encoder_increments, 4000);
  EXPECT_EQ(read(robot_text(with("regulator_output_max", ""))).axes[0].regulator_output_max, 190);
  EXPECT_EQ(read(robot_text()).axes[0].stuck_current, 0);
  EXPECT_EQ(read(robot_text(with("current_max", "current_max = 15\nstuck_current = 2"))).axes[0].stuck_current, 2);
  EXPECT_EQ(read(robot_text()).axes[0].current_max_time, std::numeric_limits<double>::infinity());
  EXPECT_EQ(read(robot_text(with("current_max", "current_max = 15\ncurrent_max_time = 0.5"))).axes[0].current_max_time,
            0.5);
}

TEST_F(RobotParametersFileTest, OtherKeysAreRequiredAndNamed) {
  for (const std::string key : {"name", "position_min", "position_max", "velocity_max", "acceleration_max", "jerk_max",
                                "motor_min", "motor_max", "motor_synchro", "current_max", "following_error_max",
                                "regulator_a", "regulator_b0", "regulator_b1", "regulator_eps",
                                "regulator_current_gain", "torque_constant", "rotor_inertia", "viscous_friction"}) {
    EXPECT_TRUE(message(robot_text(with(key, ""))).starts_with("r.toml:3: axes[0]." + key + ": missing, expected a "))
        << message(robot_text(with(key, "")));
  }
  EXPECT_EQ(message(robot_text(with("jerk_max", "jerk_mx = 50"))),
            "r.toml:9: axes[0].jerk_mx: unknown key, did you mean 'jerk_max'?");
}

TEST_F(RobotParametersFileTest, PositionAndMotorLimitsMayBeInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::string axis = with("position_min", "position_min = -inf");
  for (const std::string key : {"position_max", "motor_max"}) axis = with(key, key + " = inf", axis);
  const AxisParameters endless = read(robot_text(with("motor_min", "motor_min = -inf", axis))).axes[0];
  EXPECT_EQ(endless.position_min, -kInfinity);
  EXPECT_EQ(endless.position_max, kInfinity);
  EXPECT_EQ(endless.motor_min, -kInfinity);
  EXPECT_EQ(endless.motor_max, kInfinity);
  EXPECT_EQ(endless.motor_synchro, -15.9);
}

TEST_F(RobotParametersFileTest, OtherNumbersMustBeFiniteAndNoLimitMayBeNan) {
  EXPECT_EQ(message(robot_text(with("velocity_max", "velocity_max = inf"))),
            "r.toml:7: axes[0].velocity_max: inf is not finite, expected a number");
  EXPECT_EQ(message(robot_text(with("position_max", "position_max = nan"))),
            "r.toml:6: axes[0].position_max: nan is not finite, expected a number");
  EXPECT_EQ(message(robot_text(with("position_min", "position_min = inf"))),
            "r.toml:6: axes[0].position_max: 2.75 is not above position_min, expected a number above inf");
}

TEST_F(RobotParametersFileTest, RefusesInvalidNumbers) {
  EXPECT_EQ(message(robot_text(with("position_max", "position_max = -2.5"))),
            "r.toml:6: axes[0].position_max: -2.5 is not above position_min, expected a number above -2.5");
  EXPECT_EQ(message(robot_text(with("current_max", "current_max = 15\ncurrent_max_time = 0"))),
            "r.toml:15: axes[0].current_max_time: 0 is not positive, expected a number above 0");
  EXPECT_EQ(message(robot_text(with("current_max", "current_max = 15\nstuck_current = -1"))),
            "r.toml:15: axes[0].stuck_current: -1 is negative, expected 0 or a number above 0");
  EXPECT_EQ(message(robot_text(with("velocity_max", "velocity_max = 0"))),
            "r.toml:7: axes[0].velocity_max: 0 is not positive, expected a number above 0");
  EXPECT_EQ(message(robot_text(with("motor_synchro", "motor_synchro = 500"))),
            "r.toml:12: axes[0].motor_synchro: 500 is out of range, expected a number from -470 to 450");
  EXPECT_EQ(message(robot_text(with("viscous_friction", "viscous_friction = -1"))),
            "r.toml:24: axes[0].viscous_friction: -1 is not positive, expected a number above 0");
  EXPECT_EQ(message(robot_text(with("name", "name = ''"))),
            "r.toml:4: axes[0].name: '' is not a valid name, expected 1 to 31 characters");
}

TEST_F(RobotParametersFileTest, FineSynchronisationReversesTheCoarseOne) {
  const auto with_speeds = [](const std::string& speeds) { return robot_text(std::string(kAxis) + speeds); };
  const RobotParameters none = read(robot_text());
  EXPECT_EQ(none.axes[0].synchro_coarse, 0);
  EXPECT_EQ(none.axes[0].synchro_fine, 0);
  const RobotParameters both = read(with_speeds("synchro_coarse = -15\nsynchro_fine = 3.5\n"));
  EXPECT_EQ(both.axes[0].synchro_coarse, -15);
  EXPECT_EQ(both.axes[0].synchro_fine, 3.5);
  EXPECT_EQ(
      message(with_speeds("synchro_coarse = -15\nsynchro_fine = -3.5\n")),
      "r.toml:26: axes[0].synchro_fine: -3.5 does not have the opposite sign of synchro_coarse, expected a number "
      "above 0");
  EXPECT_EQ(message(with_speeds("synchro_coarse = 15\nsynchro_fine = 3.5\n")),
            "r.toml:26: axes[0].synchro_fine: 3.5 does not have the opposite sign of synchro_coarse, expected a number "
            "below 0");
  EXPECT_EQ(message(with_speeds("synchro_fine = 3.5\n")),
            "r.toml:25: axes[0].synchro_fine: 3.5 does not have the opposite sign of synchro_coarse, expected 0");
}

TEST_F(RobotParametersFileTest, ChecksTheAxesTogether) {
  const std::string axis{kAxis};
  EXPECT_EQ(message(robot_text(axis + "[[axes]]\n" + axis, "[0, 0]")),
            "r.toml:26: axes[1].name: 'column' is the name of an earlier axis, expected a unique name");
  EXPECT_EQ(message(robot_text(axis, "[0, 0]")), "r.toml:2: home: has 2 values, expected an array of 1 numbers");
  EXPECT_EQ(message(robot_text(axis, "[3]")),
            "r.toml:2: home: 3 is outside the limits of axis 'column', expected a number from -2.5 to 2.75");
  EXPECT_EQ(message("type = 'a'\nhome = []\n"), "r.toml:1: axes: 0 axes, expected 1 to 8 axes");
  std::string nine = "type = 'a'\nhome = [0]\n";
  for (int i = 0; i < 9; ++i) nine += "[[axes]]\n";
  EXPECT_EQ(message(nine), "r.toml:3: axes: 9 axes, expected 1 to 8 axes");
}

TEST_F(RobotParametersFileTest, PosturesAreWithinTheLimitsAndHomeIsOne) {
  const RobotParameters robot = read(robot_text() + "[postures]\nfront = [1.5]\n");
  ASSERT_EQ(robot.postures.size(), 2u);
  EXPECT_EQ(robot.postures.at("front")[0], 1.5);
  EXPECT_EQ(robot.postures.at("home"), robot.home);
  EXPECT_EQ(message(robot_text() + "[postures]\nfront = [3]\n"),
            "r.toml:26: postures.front: 3 is outside the limits of axis 'column', expected a number from -2.5 to 2.75");
  EXPECT_EQ(message(robot_text() + "[postures]\nfront = [1, 1]\n"),
            "r.toml:26: postures.front: has 2 values, expected an array of 1 numbers");
  EXPECT_EQ(message(robot_text() + "[postures]\nhome = [1]\n"),
            "r.toml:26: postures.home: is the name of the key 'home', expected another name");
}

TEST_F(RobotParametersFileTest, ToolsHaveNames) {
  const RobotParameters robot = read(robot_text() + "[tools]\ngripper = [0.1, 0, 0.2, 0, 0, 1.5]\n");
  ASSERT_EQ(robot.tools.size(), 2u);
  EXPECT_TRUE(robot.tools.at("flange").isApprox(Pose::Identity()));
  EXPECT_TRUE(robot.tools.at("gripper").translation().isApprox(Eigen::Vector3d(0.1, 0, 0.2)));
  EXPECT_TRUE(
      robot.tools.at("gripper").linear().isApprox(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitZ()).toRotationMatrix()));
  for (const auto& [text, error] :
       {std::pair{"gripper = [0, 0]", "has 2 values, expected an array of 6 numbers"},
        {"gripper = [11, 0, 0, 0, 0, 0]", "11 is out of range, expected a number from -10 to 10 (m)"},
        {"gripper = [0, 0, 0, 7, 0, 0]",
         "7 is out of range, expected a number from -6.283185307179586 to 6.283185307179586 (rad)"},
        {"flange = [0, 0, 0, 0, 0, 0]", "is the name of the flange frame itself, expected another name"}}) {
    const std::string name = std::string{text}.substr(0, std::string{text}.find(' '));
    EXPECT_EQ(message(robot_text() + "[tools]\n" + text + "\n"), "r.toml:26: tools." + name + ": " + error);
  }
}

TEST_F(RobotParametersFileTest, DoesNotReadTheGeometry) {
  const Table file = Table::load(scratch_.write("r.toml", robot_text() + "[geometry]\na2 = 0.455\n"));
  read_robot_parameters(file);
  EXPECT_EQ(message_of(scratch_.path(), [&] { file.finish(); }),
            "r.toml:25: geometry: unknown key, expected 'axes', 'drives', 'edp', 'home', 'load_max', 'postures', "
            "'regulators', "
            "'synchro_order', "
            "'tools' or 'type'");
  file.table("geometry");
  EXPECT_NO_THROW(file.finish());
}

TEST_F(RobotParametersFileTest, RegulatorSetsChangeWhatTheyName) {
  const RobotParameters plain = read(robot_text());
  ASSERT_EQ(plain.regulators.size(), 1u);
  EXPECT_EQ(plain.regulators[0].name, "standard");
  EXPECT_EQ(plain.regulators[0].axes[0].regulator_current_gain, 0.2);

  const RobotParameters robot = read(robot_text() + "[regulators.soft.column]\ncurrent_gain = 0.1\neps = 0\n");
  ASSERT_EQ(robot.regulators.size(), 2u);
  EXPECT_EQ(robot.regulators[1].name, "soft");
  EXPECT_EQ(robot.regulators[1].axes[0].regulator_current_gain, 0.1);
  EXPECT_EQ(robot.regulators[1].axes[0].regulator_eps, 0);
  EXPECT_EQ(robot.regulators[1].axes[0].regulator_b0, 1.55);
  EXPECT_EQ(robot.axes[0].regulator_current_gain, 0.2);

  const std::string set = "[regulators.soft.column]\n";
  EXPECT_EQ(message(robot_text() + "[regulators.soft.elbow]\na = 1\n"),
            "r.toml:25: regulators.soft.elbow: 'elbow' is not an axis, expected the name of one");
  EXPECT_EQ(message(robot_text() + set + "current_gain = 0\n"),
            "r.toml:26: regulators.soft.column.current_gain: 0 is not positive, expected a number above 0");
  EXPECT_EQ(message(robot_text() + set + "gain = 1\n"),
            "r.toml:26: regulators.soft.column.gain: unknown key, expected 'a', 'b0', 'b1', 'current_gain', "
            "'eps' or 'output_max'");
  EXPECT_EQ(message(robot_text() + "[regulators.standard.column]\na = 1\n"),
            "r.toml:25: regulators.standard: the name of the axes' own numbers, expected another name");
}

}  // namespace
}  // namespace mrroc::config::robot_parameters_file_test
