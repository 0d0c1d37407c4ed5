#include "cli/operator/terminal/console_input.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <functional>

#include "process/answer_text.hpp"

namespace mrroc::cli::console_input_test {
namespace {

using process::read_answer;

links::OperatorQuestion parts() {
  links::OperatorQuestion question;
  question.minimum = -5;
  question.maximum = 10;
  return question;
}

std::function<bool(std::string_view)> is(std::vector<std::string> words) {
  return [words](std::string_view line) { return std::find(words.begin(), words.end(), line) != words.end(); };
}

class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }
  ~Pipe() {
    end();
    close(ends_[0]);
  }
  int fd() const { return ends_[0]; }
  void write(const std::string& text) { ASSERT_EQ(::write(ends_[1], text.data(), text.size()), std::ssize(text)); }
  void end() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{};
};

/// Runs `typist` with both ends of a new terminal and expects 0: in another process, in the foreground of the terminal.
void expect_zero_in_foreground(const std::function<int(int terminal, int slave)>& typist) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_EQ(grantpt(terminal), 0);
  ASSERT_EQ(unlockpt(terminal), 0);
  const int slave = open(ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(slave, 0);
  const pid_t process = fork();
  if (process == 0) {
    setsid();
    ioctl(slave, TIOCSCTTY, 0);
    tcsetpgrp(slave, getpgrp());
    _exit(typist(terminal, slave));
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_EQ(status, 0);
  close(slave);
  close(terminal);
}

TEST(ConsoleInput, ComeWholeAndInOrder) {
  Pipe pipe;
  ConsoleInput lines(pipe.fd());
  EXPECT_TRUE(lines.attended());
  EXPECT_FALSE(lines.next());
  pipe.write("thr");
  EXPECT_FALSE(lines.next());
  pipe.write("ee\n\nfour\nfi");
  EXPECT_EQ(lines.next(), "three");
  EXPECT_EQ(lines.next(), "");
  EXPECT_EQ(lines.next(), "four");
  EXPECT_FALSE(lines.next());
  pipe.end();
  EXPECT_EQ(lines.next(), "fi");
  EXPECT_FALSE(lines.next());
  EXPECT_FALSE(lines.attended());
}

TEST(ConsoleInput, WordIsTakenFromTheWaitingLines) {
  Pipe pipe;
  ConsoleInput lines(pipe.fd());
  EXPECT_FALSE(lines.next_if(is({"stop", "go"})));
  pipe.write("one\n  go\t\r\ntwo\nstop\nstopped\nsto");
  EXPECT_EQ(lines.next_if(is({"stop", "go"})), "go");
  EXPECT_EQ(lines.next_if(is({"stop", "go"})), "stop");
  EXPECT_FALSE(lines.next_if(is({"stop", "go"})));
  pipe.write("p\n");
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.next_if(is({"stop"})), "stop");
  EXPECT_EQ(lines.next(), "two");
  EXPECT_EQ(lines.next(), "stopped");
  EXPECT_FALSE(lines.next());
}

TEST(ConsoleInput, WordIsFoundBehindUnreadLines) {
  Pipe pipe;
  ConsoleInput lines(pipe.fd());
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 400; ++j) pipe.write("a line that no question has asked for\n");
    EXPECT_FALSE(lines.next_if(is({"estop"})));
  }
  pipe.write("estop\n");
  EXPECT_EQ(lines.next_if(is({"estop"})), "estop");
  EXPECT_EQ(lines.next(), "a line that no question has asked for") << "whole lines are kept";
}

TEST(ConsoleInput, EndOfALineAtATerminalIsNotTheEndOfInput) {
  expect_zero_in_foreground([](int terminal, int slave) {
    ConsoleInput lines(slave);
    constexpr char kControlD[] = "\x04";
    if (write(terminal, kControlD, 1) != 1) return 2;
    for (int i = 0; i < 50; ++i) {
      if (lines.next() || !lines.attended()) return 3;
      usleep(1000);
    }
    if (write(terminal, "estop\n", 6) != 6) return 4;
    for (int i = 0; i < 5000; ++i, usleep(1000))
      if (lines.next_if(is({"estop"}))) return 0;
    return 5;
  });
}

TEST(ConsoleInput, KeysOfATerminalAreTakenAtOnce) {
  expect_zero_in_foreground([](int terminal, int slave) {
    termios before{}, after{};
    tcgetattr(slave, &before);
    {
      ConsoleInput lines(slave, true);
      if (!lines.takes_keys()) return 2;
      if (write(terminal, " pau", 4) != 4) return 3;
      std::optional<std::string> line;
      for (int i = 0; i < 5000 && !(line = lines.next()); ++i) usleep(1000);
      if (line != " ") return 4;
      for (int i = 0; i < 5000 && lines.typed() != "pau"; ++i, usleep(1000))
        if (lines.next()) return 5;
      if (lines.typed() != "pau") return 6;
    }
    tcgetattr(slave, &after);
    return before.c_lflag == after.c_lflag ? 0 : 7;
  });
}

TEST(ConsoleInput, NullDeviceAndClosedDescriptorHaveNoInput) {
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  EXPECT_FALSE(ConsoleInput(null).attended());
  close(null);
  EXPECT_FALSE(ConsoleInput(-1).attended());
}

TEST(TypedAnswer, EveryNumberInRangeIsTaken) {
  EXPECT_TRUE(rc::check([] {
    const double value = *rc::gen::inRange(-500'000, 1'000'001) * 1e-5;
    std::array<char, 40> text{};
    *std::to_chars(text.data(), text.data() + text.size(), value).ptr = '\0';
    std::string refusal;
    const auto answer = read_answer(parts(), std::string{" \t"} + text.data() + " \r", refusal);
    RC_ASSERT(answer == value);
    RC_ASSERT(refusal.empty());
  }));
}

TEST(TypedAnswer, RefusesInvalidAnswersWithTheReason) {
  for (const char* line : {"", "  ", "three", "3 4", "3,5", "0x10", "nan", "inf", "1e999", "--1", "3;"}) {
    std::string refusal;
    EXPECT_FALSE(read_answer(parts(), line, refusal)) << line;
    EXPECT_NE(refusal.find(", expected a number from -5 to 10"), std::string::npos) << refusal;
  }
  for (const char* line : {"-5.001", "10.5", "1e9"}) {
    std::string refusal;
    EXPECT_FALSE(read_answer(parts(), line, refusal)) << line;
    EXPECT_NE(refusal.find(" is out of range, expected a number from -5 to 10"), std::string::npos) << refusal;
  }
}

TEST(TypedAnswer, YesAndNo) {
  links::OperatorQuestion question;
  question.kind = links::QuestionKind::yes_no;
  std::string refusal;
  for (const char* line : {"yes", " y ", "yes\r"}) EXPECT_EQ(read_answer(question, line, refusal), 1.0) << line;
  for (const char* line : {"no", "n\t"}) EXPECT_EQ(read_answer(question, line, refusal), 0.0) << line;
  for (const char* line : {"", "1", "maybe", "yes no"}) EXPECT_FALSE(read_answer(question, line, refusal)) << line;
  EXPECT_EQ(refusal, "'yes no' is not an answer, expected yes or no");
}

TEST(TypedAnswer, AChoiceIsItsNameOrItsNumber) {
  links::OperatorQuestion question;
  question.kind = links::QuestionKind::choice;
  question.choice_count = 3;
  question.choices[0].assign("left");
  question.choices[1].assign("right");
  question.choices[2].assign("neither of them");
  std::string refusal;
  EXPECT_EQ(read_answer(question, "left", refusal), 0.0);
  EXPECT_EQ(read_answer(question, " 2", refusal), 1.0);
  EXPECT_EQ(read_answer(question, "neither of them ", refusal), 2.0);
  for (const char* line : {"", "0", "4", "1.5", "lef"}) EXPECT_FALSE(read_answer(question, line, refusal)) << line;
  EXPECT_EQ(refusal, "'lef' is not an answer, expected 'left', 'right' or 'neither of them'");
}

}  // namespace
}  // namespace mrroc::cli::console_input_test
