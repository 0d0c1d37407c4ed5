#include <gtest/gtest.h>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/common/changed_file.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"
#include "text_of.hpp"

namespace mrroc {
namespace {

std::string error_with(const std::string& from, const std::string& to) {
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("c.toml", changed_file(conveyor_file("toml"), from, to));
  return config::message_of(scratch.path(), [&] { load_conveyor(file); });
}

TEST(ConveyorFile, ErrorsNameTheirKey) {
  EXPECT_EQ(error_with("gear = 2250.0", "gear = -2250.5"), "");
  EXPECT_EQ(error_with("gear = 2250.0", "gear = 0.0"),
            "c.toml:36: geometry.gear: 0 is not a gear ratio, expected rad of the motor per m, its sign included");
  EXPECT_EQ(error_with("gear = 2250.0", "gear = inf"),
            "c.toml:36: geometry.gear: inf is not finite, expected a number");
  EXPECT_EQ(error_with("gear = 2250.0", "geer = 2250.0"), "c.toml:35: geometry.gear: missing, expected a number");
  EXPECT_EQ(error_with("[geometry]", "[geometry]\nlength = 1"),
            "c.toml:36: geometry.length: unknown key, expected 'gear'");
  EXPECT_EQ(error_with("velocity_max = 0.05", "velocity_max = -0.05"),
            "c.toml:15: axes[0].velocity_max: -0.05 is not positive, expected a number above 0");
}

TEST(ConveyorFile, ExactlyOneAxisIsExpected) {
  std::string text = test::text_of(conveyor_file("toml"));
  const auto begin = text.find("[[axes]]"), end = text.find("[geometry]");
  std::string second = text.substr(begin, end - begin);
  second.replace(second.find("\"belt\""), 6, "\"second\"");
  text.insert(end, second);
  text.replace(text.find("home = [0.0]"), 12, "home = [0.0, 0.0]");
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("c.toml", text);
  EXPECT_EQ(config::message_of(scratch.path(), [&] { load_conveyor(file); }),
            "c.toml:11: axes: 2 axes, expected one axis, the belt");
}

TEST(ConveyorFile, GearIsTheOriginals2250RadiansPerMetre) {
  JointVector motors;
  ASSERT_EQ(conveyor_model()->joints_to_motors(one(2), motors), ErrorCode::none);
  EXPECT_EQ(motors[0], 4500);
  EXPECT_EQ(conveyor_model()->transmission(one(2))(0, 0), 2250);
}

TEST(ConveyorFile, InstalledFileLoads) {
  const RobotModels models = load_conveyor();
  ASSERT_EQ(models.size(), 1U);
  EXPECT_EQ(models.front()->name(), "nominal");
  EXPECT_EQ(models.front()->parameters().type, "conveyor");
  EXPECT_EQ(models.front()->parameters().axes.front().name, "belt");
}

}  // namespace
}  // namespace mrroc
