#include "cli/run/progress.hpp"

#include <gtest/gtest.h>

namespace mrroc::cli::progress_test {
namespace {

// the first status of a process may already contain its first instruction
TEST(Progress, ShowsStateAndInstructionOfOneStatus) {
  testing::internal::CaptureStdout();
  {
    Progress progress({"arm"}, 0.002, false);
    links::ProcessStatus status;
    status.process.assign("arm");
    status.state = links::ProcessState::ready;
    progress.update(status);
    status.state = links::ProcessState::running;
    status.instruction = 1;
    status.tick = 5;
    status.activity.assign("never");
    progress.update(status);
    progress.update(status);
  }
  const std::string shown = testing::internal::GetCapturedStdout();
  EXPECT_NE(shown.find("running"), std::string::npos) << shown;
  const std::size_t at = shown.find("never");
  ASSERT_NE(at, std::string::npos) << shown;
  EXPECT_EQ(shown.find("never", at + 1), std::string::npos) << "once";
}

TEST(Progress, PrintedTextCannotControlTheTerminal) {
  testing::internal::CaptureStdout();
  {
    Progress progress({"arm"}, 0.002, false);
    progress.message("arm | \x1b[2J50%\r60%");
    links::ProcessStatus status;
    status.process.assign("arm");
    status.instruction = 1;
    status.activity.assign("\x1b]0;title\x07");
    progress.update(status);
  }
  const std::string shown = testing::internal::GetCapturedStdout();
  for (const char control : {'\x1b', '\r', '\x07'}) EXPECT_EQ(shown.find(control), std::string::npos) << shown;
  EXPECT_NE(shown.find("arm | \\x1b[2J50%\\x0d60%\n"), std::string::npos) << shown;
}

}  // namespace
}  // namespace mrroc::cli::progress_test
