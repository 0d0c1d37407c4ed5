#include "command/replaceable.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

namespace mrroc::command {
namespace {

TEST(Replaceable, OnlyWhatBeginsInTheSameWayOrIsEmpty) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mrroc_replaceable";
  std::filesystem::create_directories(folder);
  const auto with = [&folder](const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  };
  EXPECT_TRUE(is_replaceable(folder / "missing", "head"));
  EXPECT_TRUE(is_replaceable(with("empty", ""), "head"));
  EXPECT_TRUE(is_replaceable(with("same", "head and more"), "head"));
  EXPECT_TRUE(is_replaceable(with("alone", "head"), "head"));
  EXPECT_TRUE(is_replaceable("/dev/null", "head"));
  EXPECT_TRUE(is_replaceable(folder, "head")) << "whoever opens it reports that it is a folder";
  for (const std::string text : {"h", "hea", "Head", " head", "[deployment]", std::string("\0head", 5).c_str()}) {
    const auto file = with("other", text);
    if (text.empty()) continue;
    EXPECT_FALSE(is_replaceable(file, "head")) << text;
    EXPECT_THROW(check_replaceable(file, "head", "--out", "a head"), std::runtime_error);
  }
  std::filesystem::create_symlink(with("other", "mine"), folder / "link");
  EXPECT_FALSE(is_replaceable(folder / "link", "head"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace mrroc::command
