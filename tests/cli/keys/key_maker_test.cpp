#include "cli/keys/key_maker.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "links/transport/security.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::key_maker_test {
namespace {

namespace fs = std::filesystem;

class KeyMaker : public testing::Test {
 protected:
  static std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path());
      files[entry.path().filename()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return files;
  }

  static std::string refusal(const fs::path& folder) {
    try {
      make_keys(folder, "cell");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(KeyMaker, OnlyTheOwnerMayReadThemWithAnyUmask) {
  const mode_t mask = ::umask(0);
  make_keys(scratch_ / "keys", "cell");
  ::umask(mask);
  EXPECT_EQ(fs::status(scratch_ / "keys").permissions(), fs::perms::owner_all);
  for (const auto& entry : fs::directory_iterator(scratch_ / "keys")) {
    EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << entry.path();
  }
  EXPECT_NO_THROW(links::check_keys(scratch_ / "keys"));
}

TEST_F(KeyMaker, DiscardsTheSigningKey) {
  make_keys(scratch_ / "keys", "cell");
  int private_keys = 0;
  const auto files = contents(scratch_ / "keys");
  EXPECT_EQ(files.size(), 5U);
  for (const auto& [name, text] : files) {
    if (text.find("PRIVATE KEY") == std::string::npos) continue;
    ++private_keys;
    EXPECT_EQ(name, links::KeyFiles::identity_key);
  }
  EXPECT_EQ(private_keys, 1);
}

TEST_F(KeyMaker, TwoSetsHaveNoFileInCommon) {
  make_keys(scratch_ / "one", "cell");
  make_keys(scratch_ / "two", "cell");
  const auto one = contents(scratch_ / "one");
  for (const auto& [name, text] : contents(scratch_ / "two")) EXPECT_NE(text, one.at(name)) << name;
}

TEST_F(KeyMaker, NeverOverwrites) {
  const fs::path folder = scratch_ / "keys";
  make_keys(folder, "cell");
  const auto made = contents(folder);
  const std::string expected = "keys: " + folder.string() +
                               " is there already and keys are never overwritten: remove it, or name another folder";
  EXPECT_EQ(refusal(folder), expected);
  EXPECT_EQ(contents(folder), made);
  std::ofstream(scratch_ / "file") << "precious";
  EXPECT_NE(refusal(scratch_ / "file"), "");
  EXPECT_EQ(contents(scratch_.path()).at("file"), "precious");
}

TEST_F(KeyMaker, ReportsWhyAFolderCannotBeMade) {
  EXPECT_EQ(refusal(scratch_ / "no" / "keys"),
            "keys: " + (scratch_ / "no" / "keys").string() + " cannot be made: No such file or directory");
}

}  // namespace
}  // namespace mrroc::cli::key_maker_test
