// Imports into a folder that exists.
#include <gtest/gtest.h>

#include <fstream>

#include "cli/robot/adding.hpp"
#include "text_of.hpp"

namespace mrroc::cli::replace_robot_test {
namespace {

using test::text_of;

using ReplaceRobot = AddRobot;

TEST_F(ReplaceRobot, KeepsAFolderThatExists) {
  AddRequest add = request(kSpoilt / "parallel.urdf");
  add.accept_guesses = true;
  const fs::path own = folder_.write("robots/parallel/own.txt", "mine");
  EXPECT_NE(result_of(add).find("parallel: exists, expected another --name, or --replace"), std::string::npos);
  EXPECT_EQ(names_in(add.into / "parallel"), std::vector<std::string>{"own.txt"});
  add.replace = true;
  EXPECT_NE(result_of(add).find("holds 'own.txt', which no import makes"), std::string::npos);
  EXPECT_EQ(text_of(own), "mine");
  EXPECT_EQ(names_in(add.into), std::vector<std::string>{"parallel"});
}

// a folder is replaced as a whole
TEST_F(ReplaceRobot, ReplacesNoFolderWithOtherFilesNorItsOwnInput) {
  AddRequest add = request(MRROC_SOURCE_DIR "/docs/examples/reacher/reacher.urdf");
  add.accept_guesses = true;
  add_robot(add);
  add.replace = true;
  EXPECT_NO_THROW(add_robot(add));
  const fs::path folder = add.into / "reacher";
  const std::vector<std::string> made = names_in(folder);
  for (const char* name : {"thesis.txt", "reacher_drives.toml", "limits.toml"}) {
    std::ofstream(folder / name) << "mine";
    EXPECT_THROW(add_robot(add), config::ConfigurationError) << name;
    EXPECT_EQ(text_of(folder / name), "mine");
    fs::remove(folder / name);
  }
  AddRequest from_inside = add;
  from_inside.urdf = folder / "reacher.urdf";
  EXPECT_THROW(add_robot(from_inside), config::ConfigurationError);
  EXPECT_EQ(names_in(folder), made);
  // a folder that no import has made
  fs::create_directories(add.into / "other");
  std::ofstream(add.into / "other" / "thesis.txt") << "mine";
  add.name = "other";
  EXPECT_THROW(add_robot(add), config::ConfigurationError);
  EXPECT_EQ(text_of(add.into / "other" / "thesis.txt"), "mine");
}

TEST_F(ReplaceRobot, ReplacesNoFile) {
  AddRequest add = request(MRROC_SOURCE_DIR "/docs/examples/reacher/reacher.urdf");
  add.accept_guesses = add.replace = true;
  const fs::path file = folder_.write("robots/reacher", "mine");
  EXPECT_NE(result_of(add).find("is no folder"), std::string::npos);
  EXPECT_EQ(text_of(file), "mine");
}

}  // namespace
}  // namespace mrroc::cli::replace_robot_test
