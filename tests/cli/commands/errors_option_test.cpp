#include "cli/commands/errors_option.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::errors_option_test {
namespace {

class ErrorsOption : public testing::Test {
 protected:
  ErrorsOption() {
    setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1);
    deployment_.sim.emplace();
  }
  std::string refusal(const std::string& name) const {
    try {
      errors_table("cell.toml", deployment_, name, 1);
      return "";
    } catch (const config::ConfigurationError& error) {
      return error.what();
    }
  }
  config::Deployment deployment_;
  task_test::ScratchFolder folder_;
};

TEST_F(ErrorsOption, IsATableWithTheSetAndTheSeed) {
  for (const std::string& name : {std::string("modest"), folder_.write("mine.toml", "blur = 1.0\n").string(),
                                  folder_.write("my lab/mine.toml", "blur = 1.0\n").string()}) {
    const auto file = folder_.write("table.toml", errors_table("cell.toml", deployment_, name, 7));
    const config::Table table = config::Table::load(file).table("sim").table("errors");
    EXPECT_TRUE(table.text("set").ends_with(name == "modest" ? "/sim/errors/modest.toml" : name));
    EXPECT_EQ(table.integer_or("seed", 0, 0, 9), 7);
  }
}

TEST_F(ErrorsOption, UnknownSetsAreRefusedByTheNameOfTheOption) {
  for (const std::string& name : {std::string("modets"), std::string(), std::string("/none/mine.toml"),
                                  std::string("modest'\nblur = 1 #"), std::string("a'b"), std::string("../modest"),
                                  folder_.path().string() + "/", folder_.write("it's.toml", "blur = 1.0\n").string()}) {
    EXPECT_NE(refusal(name).find("cell.toml: --errors: no set of errors"), std::string::npos) << refusal(name);
  }
}

TEST_F(ErrorsOption, DeploymentsThatCannotHaveItAreRefused) {
  deployment_.sim->errors.emplace();
  EXPECT_NE(refusal("modest").find("--errors: the deployment has a table [sim.errors]"), std::string::npos);
  deployment_.sim.reset();
  EXPECT_NE(refusal("modest").find("--errors: the deployment simulates no world"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::cli::errors_option_test
