#include "cli/output/output.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>

#include "clock/wall/monotonic.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::output_test {
namespace {

class OutputTest : public testing::Test {
 protected:
  void SetUp() override {
    signal(SIGPIPE, SIG_IGN);
    ASSERT_EQ(pipe2(ends_, O_CLOEXEC), 0);
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  void TearDown() override {
    for (const int fd : ends_) close(fd);
  }

  /// All available data of `fd`, which does not block.
  static std::string read_all(int fd) {
    std::string text;
    char buffer[65536];
    for (ssize_t size = 0; (size = read(fd, buffer, sizeof buffer)) > 0;)
      text.append(buffer, static_cast<std::size_t>(size));
    return text;
  }

  int ends_[2] = {-1, -1};
};

TEST_F(OutputTest, WritesAtOnceWhenPossible) {
  Output output(ends_[1]);
  output.write("one\n");
  output.write("two\n");
  EXPECT_TRUE(output.empty());
  EXPECT_EQ(read_all(ends_[0]), "one\ntwo\n");
}

TEST_F(OutputTest, UnreadPipeDoesNotBlock) {
  constexpr int kLines = 5000;
  Output output(ends_[1]);
  for (int i = 0; i < kLines; ++i) output.write("line " + std::to_string(i) + std::string(500, '.') + "\n");
  EXPECT_FALSE(output.empty());
  std::string text;
  while (!output.empty()) {
    text += read_all(ends_[0]);
    output.flush();
  }
  text += read_all(ends_[0]);
  EXPECT_EQ(text.find("line 0."), 0U) << "the lines accepted before";
  const std::size_t reported = text.find(" lines are lost");
  ASSERT_NE(reported, std::string::npos);
  EXPECT_EQ(reported, text.rfind(" lines are lost")) << "printed once";
  const auto shown = std::count(text.begin(), text.end(), '\n') - 1;
  EXPECT_LT(shown, 2000);
  EXPECT_EQ(text.substr(text.rfind('(', reported) + 1, reported - text.rfind('(', reported) - 1),
            std::to_string(kLines - shown));
  // the newest thousand, in order
  std::size_t at = 0;
  for (int i = kLines - 999; i < kLines; ++i) {
    at = text.find("line " + std::to_string(i) + ".", at);
    ASSERT_NE(at, std::string::npos) << i;
  }
}

TEST_F(OutputTest, WritesALongTextInPieces) {
  const std::string text(200'000, 'x');
  Output output(ends_[1]);
  output.write(text);
  EXPECT_FALSE(output.empty());
  std::string taken;
  while (!output.empty()) {
    taken += read_all(ends_[0]);
    output.flush();
  }
  taken += read_all(ends_[0]);
  EXPECT_EQ(taken, text);
}

TEST_F(OutputTest, IsSilentWithoutAReader) {
  Output output(ends_[1]);
  close(ends_[0]);
  output.write("one\n");
  EXPECT_TRUE(output.empty());
  output.write("two\n");
  EXPECT_TRUE(output.empty());
  output.drain(clock::kForever);
}

TEST_F(OutputTest, IsSilentWhenTheDiskIsFull) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  {
    Output output(full);
    output.write("one\n");
    EXPECT_TRUE(output.empty());
  }
  close(full);
}

TEST_F(OutputTest, StoppedTerminalDoesNotBlock) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  const int terminal = ::open(ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(tcflow(terminal, TCOOFF), 0);  // as Ctrl-S does
  {
    Output output(terminal);
    for (int i = 0; i < 100; ++i) output.write(std::string(1000, 'x').append("\n"));
    EXPECT_FALSE(output.empty());
    EXPECT_EQ(fcntl(terminal, F_GETFL) & O_NONBLOCK, 0) << "others share the descriptor";
    ASSERT_EQ(tcflow(terminal, TCOON), 0);
    std::size_t taken = 0;
    while (!output.empty()) {
      taken += read_all(master).size();
      output.flush();
    }
    EXPECT_GT(taken, 0U);
  }
  close(terminal);
  close(master);
}

TEST_F(OutputTest, AppendsToAFileBehindOtherWriters) {
  const task_test::ScratchFolder folder;
  const int file = ::open((folder / "output").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  ASSERT_EQ(write(file, "before\n", 7), 7);
  Output output(file);
  output.write("after\n");
  ASSERT_EQ(lseek(file, 0, SEEK_SET), 0);
  EXPECT_EQ(read_all(file), "before\nafter\n");
}

}  // namespace
}  // namespace mrroc::cli::output_test
