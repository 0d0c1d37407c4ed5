#include "cli/processes/child.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mrroc::cli::child_test {
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

TEST(Child, LineWithoutEndComesInPieces) {
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
  // the rest in its pipe at its end
  for (std::vector<std::string> lines; !(lines = child.read_lines()).empty();)
    for (const std::string& line : lines) total += line.size();
  EXPECT_EQ(total, kBytes);
}

TEST(Child, ReportsTheSignalThatEndedIt) {
  Child child("sleeper", "/bin/sleep", {"60"});
  child.signal(SIGKILL);
  run_to_end(child);
  EXPECT_EQ(child.how_it_ended(), "signal 9 (Killed)");
  EXPECT_EQ(child.exit_code(), std::nullopt);
}

/// On a busy machine the kernel takes seconds from the signal to the end: the child is dying from the first moment.
TEST(Child, DiesFromTheSignalUntilItsEndIsRead) {
  Child child("sleeper", "/bin/sleep", {"60"});
  EXPECT_FALSE(child.is_dying());
  child.signal(SIGSTOP);
  while (!child.lost()) usleep(1000);
  EXPECT_FALSE(child.is_dying());
  child.signal(SIGKILL);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(child.is_dying());
  siginfo_t info{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child.pid()), &info, WEXITED | WNOWAIT), 0);
  EXPECT_TRUE(child.is_dying());
  run_to_end(child);
  EXPECT_FALSE(child.is_dying());
}

TEST(Child, MissingProgramEndsWith127) {
  Child child("ghost", "/no/such/program", {});
  run_to_end(child);
  EXPECT_EQ(child.how_it_ended(), "exit code 127");
}

void wait_while_at_work(const Child& child) {
  while (child.is_at_work()) usleep(200);
}

TEST(Child, IsNotRunningOnceItIsLost) {
  for (const int number : {SIGKILL, SIGSTOP}) {
    Child child("sleeper", "/bin/sleep", {"60"});
    EXPECT_TRUE(child.is_at_work());
    EXPECT_FALSE(child.lost());
    child.signal(number);
    wait_while_at_work(child);
    EXPECT_TRUE(child.lost()) << "signal " << number;
    EXPECT_FALSE(child.is_at_work()) << "the main thread has received signal" << number;
    EXPECT_EQ(child.lives(), number == SIGSTOP);
    child.signal(SIGCONT);
    EXPECT_EQ(child.lost(), number == SIGKILL) << "a stopped process continues";
  }
}

TEST(Child, IsRunningWhileAThreadOutlivesTheFirst) {
  // its first thread is a zombie in /proc, and cannot be waited for yet
  Child child("threads", "/usr/bin/env",
              {"python3", "-c",
               "import ctypes, threading, time\n"
               "def outlive():\n"
               "  while 'State:\\tZ' not in open('/proc/self/status').read(): time.sleep(0.001)\n"
               "  print('alone', flush=True)\n"
               "  time.sleep(60)\n"
               "threading.Thread(target=outlive).start()\n"
               "ctypes.CDLL(None).pthread_exit(None)\n"});
  std::vector<std::string> lines;
  while ((lines = child.read_lines()).empty() && !child.ended()) usleep(200);
  EXPECT_EQ(lines, std::vector<std::string>{"alone"});
  EXPECT_TRUE(child.is_at_work());
  EXPECT_FALSE(child.lost());
  child.signal(SIGKILL);
  wait_while_at_work(child);
  EXPECT_TRUE(child.lost());
}

TEST(Child, GetsTheDescriptorsThatAreHandedToItAndNoOthers) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const std::vector<std::string> test{"-c", "for fd do test -e /proc/self/fd/$fd && echo open || echo closed; done",
                                      "sh", std::to_string(ends[0]), std::to_string(ends[1])};
  EXPECT_EQ(Child("heir", "/bin/sh", test, -1, {ends[1]}).wait_for_output(), "closed\nopen\n");
  EXPECT_EQ(fcntl(ends[1], F_GETFD), FD_CLOEXEC) << "closes further descriptors here";
  close(ends[0]);
  close(ends[1]);
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
}  // namespace mrroc::cli::child_test
