#include "config/resources.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::resources_test {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<fs::path>;

TEST(Resources, AreBesideTheRunningExecutable) {
  unsetenv("MRROC_SHARE");
  unsetenv("MRROC_PROGRAMS");
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  EXPECT_EQ(program_directories(), Folders{here});
  EXPECT_EQ(share_directories(), Folders{here.parent_path() / "share" / "mrroc"});
}

TEST(Resources, TheEnvironmentListsFoldersInstead) {
  setenv("MRROC_SHARE", "some/share::/other/share:", 1);
  setenv("MRROC_PROGRAMS", "/some/bin", 1);
  EXPECT_EQ(share_directories(), (Folders{fs::current_path() / "some/share", "/other/share"}));
  EXPECT_EQ(program_directories(), Folders{"/some/bin"});
  hand_down_directories();
  EXPECT_EQ(getenv("MRROC_SHARE"), (fs::current_path() / "some/share").string() + ":/other/share");
  EXPECT_STREQ(getenv("MRROC_PROGRAMS"), "/some/bin");
  unsetenv("MRROC_SHARE");
  unsetenv("MRROC_PROGRAMS");
}

TEST(Resources, TypeIsAFolderWithItsParameterFile) {
  const task_test::ScratchFolder scratch;
  scratch.write("robots/irb6/irb6.toml", "");
  scratch.write("robots/belt/belt.toml", "");
  scratch.write("robots/no_parameters/readme.md", "");
  scratch.write("sensors/force/force.toml", "");
  setenv("MRROC_SHARE", scratch.path().c_str(), 1);
  EXPECT_EQ(robot_types(), (std::vector<std::string>{"belt", "irb6"}));
  EXPECT_EQ(sensor_types(), (std::vector<std::string>{"force"}));
  setenv("MRROC_SHARE", (scratch.path() / "missing").c_str(), 1);
  EXPECT_TRUE(robot_types().empty());
  unsetenv("MRROC_SHARE");
}

TEST(Resources, FirstFolderWithTheTypeIsUsed) {
  const task_test::ScratchFolder own;
  const task_test::ScratchFolder framework;
  own.write("robots/belt/belt.toml", "");
  own.write("robots/irb6/readme.md", "");
  framework.write("robots/belt/belt.toml", "");
  framework.write("robots/irb6/irb6.toml", "");
  setenv("MRROC_SHARE", (own.path().string() + ":" + framework.path().string()).c_str(), 1);
  EXPECT_EQ(robot_types(), (std::vector<std::string>{"belt", "irb6"}));
  EXPECT_EQ(type_file("robots", "belt", "belt.xml"), own.path() / "robots/belt/belt.xml");
  EXPECT_EQ(type_file("robots", "irb6", "irb6.xml"), framework.path() / "robots/irb6/irb6.xml");
  EXPECT_EQ(type_file("robots", "crane", "crane.xml"), own.path() / "robots/crane/crane.xml");
  unsetenv("MRROC_SHARE");
}

}  // namespace
}  // namespace mrroc::config::resources_test
