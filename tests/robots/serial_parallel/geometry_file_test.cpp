#include <gtest/gtest.h>

#include "fixture.hpp"
#include "robots/common/changed_file.hpp"

namespace mrroc::geometry_file_test {
namespace {

std::string error_with(const std::string& from, const std::string& to) {
  return error_of_changed(load_serial_parallel, serial_parallel_source("serial_parallel.toml"), from, to);
}

TEST(SerialParallelGeometryFile, ErrorsNameTheirKey) {
  EXPECT_EQ(error_with("platform_to_wrist = 0.0905", "platform_to_wrist = 0.0906"), "");
  EXPECT_TRUE(names(error_with("platform_to_wrist = 0.0905", "platform_to_wrist = 90.5"), "platform_to_wrist"));
  EXPECT_TRUE(names(error_with("100.0, 100.0, 100.0]", "100.0, 0.0, 100.0]"), "geometry.gears"));
  EXPECT_TRUE(names(error_with("0.2435, 0.242, 0.0", "0.2435, 0.242"), "geometry.synchro"));
  EXPECT_TRUE(names(error_with("b = 0.18", "b = -0.18"), "geometry.base.b"));
  EXPECT_TRUE(names(error_with("c = 0.05", "c = -0.05"), "geometry.base.c"));
  EXPECT_TRUE(names(error_with("ac_lean_max = 0.52", "ac_lean_max = 3.52"), "passive_limits.ac_lean_max"));
  EXPECT_TRUE(names(error_with("b_lean_inner = 0.34", "b_lean_inner = 0.94"), "passive_limits.b_lean_inner"));
  EXPECT_TRUE(names(error_with("b_pitch_min_when_lean = -0.5", "b_pitch_min_when_lean = -0.9"), "when_lean"));
  EXPECT_TRUE(names(error_with("wrist_to_flange", "wrist_to_flenge"), "geometry.wrist_to_fl"));
  EXPECT_TRUE(names(error_with("type = \"serial_parallel\"", "type = \"serial_parallel\"\ncolour = 1"), "colour"));
}

TEST(SerialParallelGeometryFile, RefusesAHomeThatTheTripodCannotReach) {
  EXPECT_TRUE(names(error_with("home = [0.28, 0.295357410606201, 0.28", "home = [0.245, 0.3, 0.375"), "home"));
}

TEST(SerialParallelGeometryFile, InstalledFileLoads) {
  const auto models = load_serial_parallel();
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models.front()->name(), "nominal");
  EXPECT_EQ(models.front()->parameters().type, "serial_parallel");
  EXPECT_EQ(models.front()->parameters().axes[4].name, "wrist_bend");
}

}  // namespace
}  // namespace mrroc::geometry_file_test
