#include "process/record/trace_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::process::trace_file_test {
namespace {

TEST(TraceFile, LosslessTraceKeepsEveryLineInOrder) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path path = folder / "trace";
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

TEST(TraceFile, LossyTraceCountsDroppedLines) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path path = folder / "lossy";
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

TEST(TraceFile, UnwritableFileIsNamed) {
  try {
    const TraceFile trace("/proc/no/such/file", "arm", true);
    FAIL() << "opened";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("/proc/no/such/file"), std::string::npos);
  }
}

TEST(TraceFile, FullDiskIsReportedAtTheEndWithItsReason) {
  TraceFile trace("/dev/full", "arm", true);
  for (int i = 0; i < 1000; ++i) {
    *trace.begin() << "line";
    trace.commit();
  }
  EXPECT_EQ(trace.close(), "cannot write the trace /dev/full: No space left on device");
}

TEST(TraceFile, FileSizeLimitIsReportedAtTheEndWithItsReason) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path path = folder / "limited";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1024, before.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);  // like every process of a deployment
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  TraceFile trace(path, "arm", true);
  for (int i = 0; i < 1000; ++i) {
    *trace.begin() << "line";
    trace.commit();
  }
  const std::string problem = trace.close();
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(problem, "cannot write the trace " + path.string() + ": File too large");
  std::filesystem::remove(path);
}

TEST(TraceFile, OpenFileStaysItsOwners) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path path = folder / "open";
  const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  EXPECT_EQ(TraceFile(fd, "name", "arm", true).close(), "");
  EXPECT_EQ(write(fd, "more\n", 5), 5);
  close(fd);
  std::ifstream file(path);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(text, "# process=arm lines=0 dropped=0 cut=0\nmore\n");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace mrroc::process::trace_file_test
