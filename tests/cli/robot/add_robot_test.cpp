#include "cli/robot/import/add_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "cli/robot/adding.hpp"
#include "cli/robot/import/demo_command.hpp"
#include "cli/robot/type/check_type.hpp"
#include "cli/robot/urdf_arm.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/arm/arm_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/irb60/irb60_model.hpp"
#include "text_of.hpp"

namespace mrroc::cli::add_robot_test {
namespace {

namespace fs = std::filesystem;
using test::text_of;

/// Line 1 of every file in spoilt/ has options, line 2 the text that the report or the error contains, or a file that
/// is written.
class SpoiltUrdf : public AddRobot, public testing::WithParamInterface<std::string> {
 protected:
  static std::string comment(const std::string& text, const std::string& key) {
    const std::size_t begin = text.find("<!-- " + key + ": ") + key.size() + 7;
    return text.substr(begin, text.find(" -->", begin) - begin);
  }
};

TEST_P(SpoiltUrdf, IsRefusedOrWarnedOf) {
  const fs::path urdf = kSpoilt / (GetParam() + ".urdf");
  const std::string text = text_of(urdf), expected = comment(text, "expect");
  AddRequest add = request(urdf);
  std::istringstream options(comment(text, "options"));
  for (std::string word; options >> word;) {
    if (word == "guesses") add.accept_guesses = true;
    if (word.starts_with("reach=")) add.reach = std::stod(word.substr(6));
    if (word.starts_with("tip=")) add.tip = word.substr(4);
  }
  const std::string result = result_of(add);
  const bool added = fs::exists(add.into / GetParam());
  EXPECT_EQ(added,
            expected.starts_with("warning: ") || expected.starts_with("guessed: ") || expected.starts_with("file: "));
  if (expected.starts_with("file: ")) {
    EXPECT_TRUE(fs::exists(add.into / GetParam() / expected.substr(6)));
  } else {
    EXPECT_NE(result.find(expected), std::string::npos) << result;
  }
  // complete, or nothing at all
  if (fs::exists(add.into)) {
    EXPECT_EQ(names_in(add.into).size(), added ? 1U : 0U);
  }
}

std::vector<std::string> spoilt_files() {
  std::vector<std::string> names;
  for (const std::string& name : names_in(kSpoilt))
    if (name.ends_with(".urdf")) names.push_back(fs::path(name).stem().string());
  return names;
}
INSTANTIATE_TEST_SUITE_P(Files, SpoiltUrdf, testing::ValuesIn(spoilt_files()),
                         [](const auto& each) { return each.param; });

TEST_F(AddRobot, WritesACompleteType) {
  AddRequest add = request(kSpoilt / "dae_collision.urdf");
  add.accept_guesses = true;
  const std::string report = add_robot(add);
  const fs::path type = add.into / "dae_collision";
  EXPECT_EQ(names_in(type), (std::vector<std::string>{"dae_collision.toml", "dae_collision.urdf", "dae_collision.xml",
                                                      "demo.toml", "demo.xml", "external.toml", "meshes"}));
  EXPECT_NE(report.find("next: " + demo_command(type) + "\n"), std::string::npos);
  EXPECT_NE(text_of(type / "dae_collision.urdf").find("filename=\"meshes/cube.stl\""), std::string::npos);
  EXPECT_NE(text_of(type / "dae_collision.toml").find("velocity_max = 2.0  # URDF line "), std::string::npos);
}

TEST_F(AddRobot, NamesTheCommandThatFindsTheType) {
  const auto run = [](const fs::path& type) { return "mrroc run " + (type / "demo.toml").string(); };
  const fs::path user = config::user_share() / "robots/ur5e";
  EXPECT_EQ(demo_command(user), run(user));
  for (const fs::path& share : config::share_directories())
    EXPECT_EQ(demo_command(share / "robots/ur5e"), run(share / "robots/ur5e"));
  const fs::path elsewhere = folder_.path() / "robots/ur5e";
  const std::string command = demo_command(elsewhere);
  EXPECT_TRUE(command.starts_with("MRROC_SHARE=" + fs::weakly_canonical(folder_.path()).string() + ":")) << command;
  EXPECT_TRUE(command.ends_with(" " + run(elsewhere))) << command;
  EXPECT_TRUE(demo_command(folder_.path() / "arms/ur5e").starts_with("move ")) << "no run looks for types there";
}

/// irb6 and irb60 have models that were written by hand, for coupled motors.
TEST_F(AddRobot, HasTheKinematicsOfTheModelThatWasWrittenByHand) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  for (const std::string name : {"irb6", "irb60"}) {
    const RobotModels written = name == "irb6" ? load_irb6() : load_irb60();
    AddRequest add = request(fs::path(MRROC_SOURCE_DIR "/robots") / name / (name + ".urdf"));
    add.name = name + "_again";
    add.tip = "flange";
    add.accept_guesses = true;
    add_robot(add);
    const RobotModels models = load_arm(add.into / add.name / (add.name + ".toml"));
    for (int round = 0; round < 10000; ++round) {
      JointVector joints(models.front()->joint_count());
      for (double& joint : joints) joint = std::uniform_real_distribution(-3.0, 3.0)(random);
      const Pose pose = models.front()->flange(joints), expected = written.front()->flange(joints);
      ASSERT_LT((pose.matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 1e-9);
      const Eigen::Vector3d tool(0.1, -0.2, 0.3);
      ASSERT_LT(
          (models.front()->jacobian(joints, tool) - written.front()->jacobian(joints, tool)).cwiseAbs().maxCoeff(),
          1e-9);
    }
  }
}

/// An arm whose torques the framework regulates; a range of inertia beyond what one regulator bears is refused.
TEST_F(AddRobot, DesignsRegulatorsForTorques) {
  AddRequest add = request(fs::path(MRROC_SOURCE_DIR "/docs/examples/reacher/reacher.urdf"));
  add.name = "torque_arm";
  add.limits = folder_.write("limits.toml", "[all]\nacceleration_max = 4.0\njerk_max = 40.0\ntorque_max = 60.0\n");
  add.drives = "torque";
  const std::string report = result_of(add);
  const fs::path file = add.into / "torque_arm/torque_arm.toml";
  ASSERT_TRUE(fs::exists(file)) << report;
  const RobotModels models = load_arm(file);
  for (const AxisParameters& axis : models.front()->parameters().axes) {
    EXPECT_EQ(axis.regulator_bandwidth, 5);
    EXPECT_GT(axis.regulator_b0, axis.regulator_b1);
    EXPECT_GT(axis.regulator_b1, 0);
    EXPECT_GE(axis.inertia_max, axis.inertia_min);
  }
  EXPECT_EQ(models.front()->parameters().regulators.front().axes.front().regulator_b0,
            models.front()->parameters().axes.front().regulator_b0);
  const std::string text = text_of(file), line = text.substr(text.find("inertia = ["));
  const std::string wide = std::string{text}.replace(text.find(line), line.find(']') + 1, "inertia = [0.001, 1000.0]");
  const fs::path refused = folder_.write("wide.toml", wide);
  try {
    load_arm(refused);
    ADD_FAILURE() << "a loop that is not stable was taken";
  } catch (const config::ConfigurationError& error) {
    EXPECT_NE(std::string{error.what()}.find("wide.toml:18: axes[0].inertia: with a bandwidth of 5 Hz"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(AddRobot, RefusesTorquesThatAreInNoFile) {
  const std::string text = text_of(kSpoilt / "parallel.urdf");
  AddRequest add =
      request(folder_.write("parallel.urdf", std::regex_replace(text, std::regex(R"(effort="[^"]*")"), "")));
  add.accept_guesses = true;
  add.drives = "torque";
  EXPECT_NE(result_of(add).find("--drives torque: axis "), std::string::npos);
  EXPECT_FALSE(fs::exists(add.into / "parallel"));
}

TEST_F(AddRobot, TakesLimitsFromAFile) {
  AddRequest add = request(kSpoilt / "acceleration.urdf");
  add.limits = folder_.write("limits.toml",
                             "[all]\nacceleration_max = 4.0\njerk_max = 40.0\n[axes.lift]\njerk_max = 30.0\n"
                             "position_min = -1.0\n");
  add_robot(add);
  const std::string text = text_of(add.into / "acceleration/acceleration.toml");
  EXPECT_NE(text.find("acceleration_max = 4.0  # given: limits.toml line 2"), std::string::npos) << text;
  EXPECT_NE(text.find("jerk_max = 30.0  # given: limits.toml line 5"), std::string::npos);
  EXPECT_NE(text.find("position_min = -1.0  # given: limits.toml line 6"), std::string::npos);
}

TEST_F(AddRobot, TakesAnAccelerationThatTheUrdfHas) {
  const std::string text = text_of(kSpoilt / "acceleration.urdf");
  AddRequest add = request(folder_.write(
      "acceleration.urdf", std::regex_replace(text, std::regex("velocity=\"2\""), "$& drake:acceleration=\"3\"")));
  add.accept_guesses = true;
  const std::string report = add_robot(add), file = text_of(add.into / "acceleration/acceleration.toml");
  EXPECT_NE(file.find("acceleration_max = 3.0  # URDF line 19"), std::string::npos) << file;
  EXPECT_NE(file.find("jerk_max = 30.0  # guessed"), std::string::npos) << file;
  EXPECT_EQ(report.find("drake"), std::string::npos) << report;
}

TEST_F(AddRobot, RefusesInvalidLimits) {
  AddRequest add = request(kSpoilt / "acceleration.urdf");
  for (const auto& [text, expected] :
       {std::pair{"[axes.lft]\njerk_max = 1.0\n", "limits.toml:1: axes.lft: no axis 'lft', expected perhaps 'lift'"},
        {"[all]\njerk = 1.0\n", "limits.toml:2: all.jerk: "},
        {"[all]\njerk_max = 0.0\n", "limits.toml:2: all.jerk_max: 0 is not positive"},
        {"[all]\nposition_min = 1.0\nposition_max = 0.5\n", "limits.toml:3: all.position_max: 0.5 is not above"}}) {
    add.limits = folder_.write("limits.toml", text);
    const std::string result = result_of(add);
    EXPECT_NE(result.find(expected), std::string::npos) << result;
  }
}

TEST_F(AddRobot, NameOfATypeMayBeLong) {
  AddRequest add = request(MRROC_SOURCE_DIR "/docs/examples/reacher/reacher.urdf");
  add.accept_guesses = true;
  for (const std::size_t length : {22, 23, 26, 27, 31, 60}) {
    add.name = "r" + std::string(length - 1, 'x');
    add_robot(add);
    for (const char* file : {"demo.toml", "external.toml"}) {
      const std::string text = text_of(add.into / add.name / file);
      const std::size_t begin = text.find("name = \"") + 8;
      EXPECT_LE(text.find('"', begin) - begin, 31U) << text;
      EXPECT_NE(text.find("type = \"" + add.name + "\""), std::string::npos) << text;
    }
  }
}

// its specification: a limit that is not there is 0
TEST_F(AddRobot, LimitThatIsNotInTheFileIsZero) {
  std::string text = text_of(MRROC_SOURCE_DIR "/docs/examples/reacher/reacher.urdf");
  const std::string lower = "lower=\"-2.9\" ";
  ASSERT_NE(text.find(lower), std::string::npos);
  text.replace(text.find(lower), lower.size(), "");
  AddRequest add = request(folder_.write("half.urdf", text));
  add.accept_guesses = true;
  add.name = "half";
  add_robot(add);
  const RobotParameters half = config::read_robot_parameters(config::Table::load(add.into / "half/half.toml"));
  const auto turn =
      std::find_if(half.axes.begin(), half.axes.end(), [](const auto& axis) { return axis.name == "turn"; });
  ASSERT_NE(turn, half.axes.end());
  EXPECT_EQ(turn->position_min, 0);
  EXPECT_EQ(turn->position_max, 2.9);
}

TEST_F(AddRobot, RefusesANameThatIsNotOne) {
  AddRequest add = request(kSpoilt / "parallel.urdf");
  add.accept_guesses = true;
  add.name = "../arm";
  EXPECT_NE(result_of(add).find("--name: '../arm' is not the name of a type"), std::string::npos);
}

TEST_F(AddRobot, AgreesWithKdlAndMujoco) {
  AddRequest add = request(kSpoilt / "mimic.urdf");
  add.accept_guesses = true;
  add.tip = "tool";
  add_robot(add);
  setenv("MRROC_SHARE", folder_.path().c_str(), 1);
  const TypeCheck check = check_type(load_chain_type("mimic"), 200);
  unsetenv("MRROC_SHARE");
  EXPECT_TRUE(check.passed()) << check_report(check);
  EXPECT_NE(
      text_of(add.into / "mimic/mimic.xml").find("<joint joint1=\"right\" joint2=\"left\" polycoef=\"0 1 0 0 0\"/>"),
      std::string::npos);
}

}  // namespace
}  // namespace mrroc::cli::add_robot_test
