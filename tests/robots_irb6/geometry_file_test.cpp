#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "irb6_fixture.hpp"

namespace mrroc {
namespace {

/// Loads irb6.toml with `from` replaced by `to`.
std::shared_ptr<const RobotModel> load_with(const std::string& from, const std::string& to) {
  std::stringstream text;
  text << std::ifstream(irb6_source("irb6.toml")).rdbuf();
  std::string changed = text.str();
  const auto at = changed.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in irb6.toml");
  changed.replace(at, from.size(), to);
  const auto file = std::filesystem::temp_directory_path() / ("irb6_" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << changed;
  return load_irb6(file).front();
}

std::string error_with(const std::string& from, const std::string& to) {
  try {
    load_with(from, to);
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(Irb6GeometryFile, MistakesNameTheirKey) {
  EXPECT_EQ(error_with("lower_arm = 0.455", "lower_arm = 0.456"), "");
  EXPECT_NE(error_with("lower_arm = 0.455", "lower_arm = -1.0").find("geometry.lower_arm"), std::string::npos);
  EXPECT_NE(error_with("column_gear = -158.0", "column_gear = 0.0").find("geometry.column_gear"), std::string::npos);
  EXPECT_NE(error_with("squares = 0.07789525", "squares = 0.05").find("geometry.lower_arm_screw.squares"),
            std::string::npos);
  EXPECT_NE(error_with("wrist = 0.19", "wrest = 0.19").find("geometry.wrist"), std::string::npos);
  EXPECT_NE(error_with("synchro_length = 0.1838348", "").find("upper_arm_screw.synchro_length"), std::string::npos);
  EXPECT_NE(error_with("[geometry]", "[geometry]\nlenght = 1").find("lenght"), std::string::npos);
  EXPECT_NE(error_with("type = \"irb6\"", "type = \"irb6\"\ncolour = 1").find("colour"), std::string::npos);
}

TEST(Irb6GeometryFile, TheInstalledFileLoads) {
  const auto model = load_irb6().front();
  EXPECT_EQ(model->parameters().type, "irb6");
  EXPECT_EQ(model->joint_count(), 6);
  EXPECT_EQ(model->parameters().axes[3].name, "wrist_pitch");
}

TEST(Irb6GeometryFile, ToolRotationIsAboutFixedAxes) {
  const auto turned = load_with("tool_rotation = [0.0, 0.0, 0.0]", "tool_rotation = [1.5707963267948966, 0.0, 0.3]");
  const JointVector home = irb6_model().parameters().home;
  const Pose change = irb6_kinematics().direct(home).inverse() * ToolKinematics(*turned).direct(home);
  EXPECT_LT(change.translation().norm(), 1e-12);
  EXPECT_LT((change.linear() * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((change.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d(std::cos(0.3), std::sin(0.3), 0)).norm(),
            1e-12);
}

}  // namespace
}  // namespace mrroc
