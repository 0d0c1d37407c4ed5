#include "config/entries/named_file.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::named_file_test {
namespace {

namespace fs = std::filesystem;

/// Two folders of programs, one after the other in the environment.
class NamedFile : public testing::Test {
 protected:
  NamedFile() { setenv("MRROC_PROGRAMS", (own_.path().string() + ":" + framework_.path().string()).c_str(), 1); }
  ~NamedFile() override { unsetenv("MRROC_PROGRAMS"); }

  static std::string add_program(const task_test::ScratchFolder& folder, const std::string& name) {
    const fs::path file = folder.write(name, "");
    fs::permissions(file, fs::perms::owner_all);
    return file.string();
  }
  std::string find(const std::string& name) const { return require_program(deployment_, "program", name); }

  task_test::ScratchFolder own_, framework_;
  Table deployment_ = Table::load(own_.write("deployment.toml", "program = 'any'\n"));
};

TEST_F(NamedFile, FirstFolderWithTheProgramIsUsed) {
  const std::string common = add_program(own_, "common");
  add_program(framework_, "common");
  const std::string stock = add_program(framework_, "stock");
  EXPECT_EQ(find("common"), common);
  EXPECT_EQ(find("stock"), stock);
}

TEST_F(NamedFile, NamesEverySearchedFolderForAMissingProgram) {
  EXPECT_EQ(message_of(own_.path(), [this] { find("missing"); }),
            "deployment.toml:1: program: no program 'missing', expected the executable " +
                (own_.path() / "missing").string() + " or " + (framework_.path() / "missing").string());
}

}  // namespace
}  // namespace mrroc::config::named_file_test
