#include "cli/child.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>

namespace mrroc::cli {
namespace {

std::vector<std::string> run_to_end(Child& child) {
  std::vector<std::string> lines;
  for (;;) {
    const bool ended = child.ended();
    for (std::string& line : child.read_lines()) lines.push_back(std::move(line));
    if (ended) return lines;
    pollfd descriptor{child.output_fd(), POLLIN, 0};
    poll(&descriptor, 1, 20);
  }
}

TEST(Child, GivesItsOutputByLinesAndItsExitCode) {
  Child child("talker", "/bin/sh", {"-c", "echo one; echo two >&2; printf three; exit 7"});
  EXPECT_EQ(run_to_end(child), (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(child.how_it_ended(), "exit code 7");
  EXPECT_EQ(child.exit_code(), 7);
  EXPECT_EQ(child.last_line(), "three");
}

TEST(Child, ALineWithoutEndComesInPieces) {
  constexpr std::size_t kBytes = 1'000'000;
  Child child("talker", "/bin/sh", {"-c", "head -c 1000000 /dev/zero | tr '\\0' x"});
  std::size_t total = 0;
  for (bool ended = false; !ended;) {
    ended = child.ended();
    for (const std::string& line : child.read_lines()) {
      EXPECT_LE(line.size(), 2U * 65536U);
      total += line.size();
    }
    pollfd descriptor{child.output_fd(), POLLIN, 0};
    poll(&descriptor, 1, 20);
  }
  // what its pipe holds at its end
  for (std::vector<std::string> lines; !(lines = child.read_lines()).empty();)
    for (const std::string& line : lines) total += line.size();
  EXPECT_EQ(total, kBytes);
}

TEST(Child, TellsTheSignalThatEndedIt) {
  Child child("sleeper", "/bin/sleep", {"60"});
  child.signal(SIGKILL);
  run_to_end(child);
  EXPECT_EQ(child.how_it_ended(), "signal 9 (Killed)");
  EXPECT_EQ(child.exit_code(), std::nullopt);
}

TEST(Child, AMissingProgramEndsWith127) {
  Child child("ghost", "/no/such/program", {});
  run_to_end(child);
  EXPECT_EQ(child.how_it_ended(), "exit code 127");
}

TEST(Child, IsKilledWithItsObject) {
  pid_t pid = 0;
  {
    const Child child("sleeper", "/bin/sleep", {"60"});
    pid = child.pid();
  }
  EXPECT_EQ(kill(pid, 0), -1);
}

}  // namespace
}  // namespace mrroc::cli
