#include "config/robot_files.hpp"

#include "config/deployment_fixture.hpp"
#include "text_of.hpp"

namespace mrroc::config::robot_files_test {
namespace {

namespace fs = std::filesystem;

/// A folder of types with two parameter files of the belt, and further ones beside a deployment.
class RobotFilesTest : public DeploymentFixture {
 protected:
  RobotFilesTest() : DeploymentFixture("valid") {
    for (const auto* name : {"conveyor.toml", "conveyor.xml", "conveyor_drives.toml", "fast.toml", "fast.xml"})
      share_.write(std::string("robots/conveyor/") + name, kParameters);
    setenv("MRROC_SHARE", share_.path().c_str(), 1);
  }

  fs::path own(const std::string& name) const { return share_.path() / "robots/conveyor" / name; }
  fs::path here(const std::string& name) const { return task_.path() / name; }

  /// The robot of a deployment with this line in its table.
  RobotEntry belt(const std::string& line) {
    const auto file = task_.write("task.toml",
                                  "[deployment]\nname = \"one\"\n[robots.belt]\ntype = \"conveyor\"\nhardware = "
                                  "\"loopback\"\n" +
                                      line);
    return load_deployment(file).robot("belt");
  }

  const std::string kParameters = test::text_of(MRROC_SOURCE_DIR "/tests/config/share/robots/conveyor/conveyor.toml");
  task_test::ScratchFolder share_, task_;
};

TEST_F(RobotFilesTest, DefaultFilesAreThoseOfTheType) {
  const RobotFiles files = belt("").files();
  EXPECT_EQ(files.parameters, own("conveyor.toml"));
  EXPECT_EQ(files.mjcf, own("conveyor.xml"));
  EXPECT_EQ(files.urdf, own("conveyor.urdf")) << "need not exist";
  EXPECT_EQ(files.drives, own("conveyor_drives.toml"));
}

TEST_F(RobotFilesTest, FileInTheTypesFolderSelectsTheFilesWithItsStem) {
  const RobotFiles files = belt("parameters = \"fast.toml\"\n").files();
  EXPECT_EQ(files.parameters, own("fast.toml"));
  EXPECT_EQ(files.mjcf, own("fast.xml"));
  EXPECT_EQ(files.urdf, own("fast.urdf")) << "the file of the type has its own limits";
  EXPECT_EQ(files.drives, own("conveyor_drives.toml"));
}

TEST_F(RobotFilesTest, FileBesideTheDeploymentPrecedesThatOfTheType) {
  task_.write("fast.toml", kParameters);
  task_.write("fast_drives.toml", "");
  const RobotFiles files = belt("parameters = \"fast.toml\"\n").files();
  EXPECT_EQ(files.parameters, here("fast.toml"));
  EXPECT_EQ(files.mjcf, own("conveyor.xml"));
  EXPECT_EQ(files.drives, here("fast_drives.toml"));
}

TEST_F(RobotFilesTest, PathIsRelativeToTheDeploymentOrAbsolute) {
  const auto file = task_.write("cell/belt_2.toml", kParameters);
  EXPECT_EQ(belt("parameters = \"cell/belt_2.toml\"\n").parameters, file);
  EXPECT_EQ(belt("parameters = \"" + file.string() + "\"\n").parameters, file);
}

TEST_F(RobotFilesTest, MissingFileIsNamedWithBothFolders) {
  try {
    belt("parameters = \"slow.toml\"\n");
    FAIL();
  } catch (const ConfigurationError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("task.toml:6: robots.belt.parameters: 'slow.toml' does not exist"), std::string::npos)
        << message;
    EXPECT_NE(message.find(here("slow.toml").string() + " or " + own("slow.toml").string()), std::string::npos)
        << message;
  }
}

TEST_F(RobotFilesTest, ErrorInTheFileIsReportedBeforeTheStart) {
  task_.write("fast.toml", replaced(kParameters, "velocity_max", "velocity_maximum"));
  try {
    belt("parameters = \"fast.toml\"\n");
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find(here("fast.toml").string() + ":"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("velocity_max"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mrroc::config::robot_files_test
