// What the source must not contain: rules that no run can show.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = MRROC_SOURCE_DIR;
// headers of src/links that show DDS; only src/links and its tests may include them
const std::set<std::string> kInternal = {"codec.hpp", "entity.hpp"};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Every C++ file of the project's layers.
std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* layer : {"include", "src", "robots", "sensors", "sim", "edp", "vsp", "ecp", "mp", "tasks", "cli"}) {
    if (!fs::exists(kRoot / layer)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / layer)) {
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") files.push_back(entry.path());
    }
  }
  return files;
}

bool in_links(const fs::path& file) { return file.parent_path() == kRoot / "src" / "links"; }

TEST(Structure, DdsIsIncludedInLinksOnlyAndShownByNoPublicHeader) {
  const std::regex shows_dds("#include [<\"](dds/|messages\\.h|links/(codec|entity)\\.hpp)");
  int users = 0;
  for (const fs::path& file : sources()) {
    if (!std::regex_search(text_of(file), shows_dds)) continue;
    ++users;
    EXPECT_TRUE(in_links(file)) << file;
    EXPECT_TRUE(file.extension() == ".cpp" || kInternal.contains(file.filename())) << file;
  }
  EXPECT_GT(users, 5) << "the search finds nothing";
}

TEST(Structure, NothingWaitsOrTimesByTheWallClockOfDds) {
  const std::regex forbidden("dds_waitset|dds_qset_latency_budget|dds_set_listener|dds_time\\(|dds_sleepfor");
  for (const fs::path& file : sources()) {
    EXPECT_FALSE(std::regex_search(text_of(file), forbidden)) << file;
  }
}

}  // namespace
