#include "config/resources.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "config/scratch.hpp"

namespace mrroc::config {
namespace {

namespace fs = std::filesystem;

TEST(Resources, LieAroundTheRunningExecutable) {
  unsetenv("MRROC_SHARE");
  unsetenv("MRROC_PROGRAMS");
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  EXPECT_EQ(program_directory(), here);
  EXPECT_EQ(share_directory(), here.parent_path() / "share" / "mrroc");
}

TEST(Resources, TheEnvironmentComesFirst) {
  setenv("MRROC_SHARE", "some/share", 1);
  setenv("MRROC_PROGRAMS", "/some/bin", 1);
  EXPECT_EQ(share_directory(), fs::current_path() / "some/share");
  EXPECT_EQ(program_directory(), "/some/bin");
  unsetenv("MRROC_SHARE");
  unsetenv("MRROC_PROGRAMS");
}

TEST(Resources, ATypeIsAFolderWithItsParameterFile) {
  const Scratch scratch;
  scratch.write("robots/irb6/irb6.toml", "");
  scratch.write("robots/belt/belt.toml", "");
  scratch.write("robots/no_parameters/readme.md", "");
  scratch.write("sensors/force/force.toml", "");
  setenv("MRROC_SHARE", scratch.folder().c_str(), 1);
  EXPECT_EQ(robot_types(), (std::vector<std::string>{"belt", "irb6"}));
  EXPECT_EQ(sensor_types(), (std::vector<std::string>{"force"}));
  setenv("MRROC_SHARE", (scratch.folder() / "missing").c_str(), 1);
  EXPECT_TRUE(robot_types().empty());
  unsetenv("MRROC_SHARE");
}

}  // namespace
}  // namespace mrroc::config
