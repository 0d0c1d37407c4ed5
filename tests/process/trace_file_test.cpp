#include "process/trace_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace mrroc::process {
namespace {

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("mrroc_" + name + std::to_string(getpid()));
}

TEST(TraceFile, ALosslessTraceKeepsEveryLineInOrder) {
  const std::filesystem::path path = scratch("trace");
  constexpr std::uint64_t kLines = 20000;
  {
    TraceFile trace(path, "arm", true);
    for (std::uint64_t i = 0; i < kLines; ++i) {
      TextLine* line = trace.begin();
      ASSERT_NE(line, nullptr);
      *line << i;
      trace.commit();
    }
  }
  std::ifstream file(path);
  std::uint64_t expected = 0;
  std::string text;
  for (; std::getline(file, text) && expected < kLines; ++expected) ASSERT_EQ(text, std::to_string(expected));
  EXPECT_EQ(expected, kLines);
  EXPECT_EQ(text, "# process=arm lines=" + std::to_string(kLines) + " dropped=0 cut=0");
  EXPECT_FALSE(std::getline(file, text));
  std::filesystem::remove(path);
}

TEST(TraceFile, ALossyTraceCountsWhatItDrops) {
  const std::filesystem::path path = scratch("lossy");
  std::uint64_t dropped = 0;
  constexpr std::uint64_t kLines = 200000;
  {
    TraceFile trace(path, "arm", false);
    for (std::uint64_t i = 0; i < kLines; ++i) {
      TextLine* line = trace.begin();
      if (line == nullptr) {
        ++dropped;
        continue;
      }
      *line << i;
      trace.commit();
    }
  }
  std::ifstream file(path);
  std::uint64_t kept = 0;
  std::string last;
  for (std::string text; std::getline(file, text); last = text) {
    if (!text.starts_with("#")) ++kept;
  }
  EXPECT_EQ(kept + dropped, kLines);
  EXPECT_GT(dropped, 0U);
  EXPECT_EQ(last, "# process=arm lines=" + std::to_string(kept) + " dropped=" + std::to_string(dropped) + " cut=0");
  std::filesystem::remove(path);
}

TEST(TraceFile, AFileThatCannotBeWrittenIsNamed) {
  try {
    const TraceFile trace("/proc/no/such/file", "arm", true);
    FAIL() << "opened";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("/proc/no/such/file"), std::string::npos);
  }
}

}  // namespace
}  // namespace mrroc::process
