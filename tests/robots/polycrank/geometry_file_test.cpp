#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"
#include "text_of.hpp"

namespace mrroc::geometry_file_test {
namespace {

std::string file_text() { return test::text_of(polycrank_source("polycrank.toml")); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in polycrank.toml");
  return text.replace(at, from.size(), to);
}

RobotModels load_text(const std::string& text) {
  const task_test::ScratchFolder folder;
  return load_polycrank(folder.write("polycrank.toml", text));
}

/// The error in polycrank.toml when `from` is replaced by `to`; nothing when it loads.
std::string error_with(const std::string& from, const std::string& to) {
  try {
    load_text(replaced(file_text(), from, to));
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(PolycrankGeometryFile, ErrorsNameTheirKey) {
  const auto names = [](const std::string& message, const std::string& key) {
    return message.find(key) != std::string::npos;
  };
  EXPECT_EQ(error_with("elbow_cranks = [0.151, 0.151]", "elbow_cranks = [0.151, 0.152]"), "");
  EXPECT_PRED2(names, error_with("elbow_cranks = [0.151,", "elbow_cranks = [0.0,"), "geometry.elbow_cranks");
  EXPECT_PRED2(names, error_with("shoulder_cranks = [-0.299,", "shoulder_cranks = [-299.0,"),
               "geometry.shoulder_cranks[0]: -299 is out of range");
  EXPECT_PRED2(names, error_with("gears = [100.0, 100.0", "gears = [100.0, 0.0"),
               "geometry.gears: 0 is not a gear ratio");
  EXPECT_PRED2(names, error_with("offsets = [0.22, ", "offsets = ["), "geometry.offsets: has 6 values");
  EXPECT_PRED2(names, error_with("gears =", "gaers ="), "unknown key, did you mean 'gears'?");
  EXPECT_PRED2(names, error_with("tool_translation", "tool_length"), "geometry.tool_");
  EXPECT_PRED2(names, error_with("[geometry]", "[geometry]\nlenght = 1"), "lenght");
  EXPECT_PRED2(names, error_with("type = \"polycrank\"", "type = \"polycrank\"\ncolour = 1"), "colour");
  EXPECT_PRED2(names, error_with("velocity_max = 0.6", "velocity_max = inf"), "velocity_max: inf is not finite");
}

TEST(PolycrankGeometryFile, RefusesAnotherNumberOfAxes) {
  const std::string text = replaced(file_text(), ", 0.0]\n", "]\n");  // home
  const auto last_axis = text.rfind("[[axes]]");
  try {
    load_text(text.substr(0, last_axis) + text.substr(text.find("[geometry]")));
    FAIL();
  } catch (const config::ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("axes: 6 axes, expected 7 axes"), std::string::npos) << error.what();
  }
}

TEST(PolycrankGeometryFile, InstalledFileHasOneModel) {
  const RobotModels models = load_polycrank();
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models[0]->name(), "nominal");
  EXPECT_EQ(models[0]->parameters().type, "polycrank");
  EXPECT_EQ(models[0]->joint_count(), 7);
  EXPECT_EQ(models[0]->parameters().axes[6].name, "tool_roll");
}

TEST(PolycrankGeometryFile, CranksOfUnequalLengthsAreSolvedToo) {
  const RobotModels models = load_text(replaced(file_text(), "[0.151, 0.151]", "[0.2, -0.12]"));
  std::mt19937_64 random(20110116);
  for (int i = 0; i < 1000; ++i) {
    const JointVector joints = random_joints(random), near = random_joints(random);
    const Pose pose = models[0]->flange(joints);
    JointVector found;
    ASSERT_EQ(models[0]->inverse(pose, near, found), ErrorCode::none);
    ASSERT_LT(pose_difference(models[0]->flange(found), pose), 1e-9);
  }
}

}  // namespace
}  // namespace mrroc::geometry_file_test
