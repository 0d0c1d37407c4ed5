#include "process/record/shared_black_box.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "mrroc/black_box.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::process::shared_black_box_test {
namespace {

/// A line with the number at both ends, so that a torn line is detected.
TextLine line_of(std::uint64_t number) {
  TextLine line;
  line << number << std::string_view{" a step "} << number;
  return line;
}

std::uint64_t number_of(const TextLine& line) {
  const std::uint64_t number = std::stoull(std::string{line.view()});
  EXPECT_EQ(line.view(), line_of(number).view());
  return number;
}

TEST(SharedBlackBox, HasTheLastLinesInOrder) {
  EXPECT_TRUE(rc::check([] {
    const auto count = *rc::gen::inRange<std::uint64_t>(0, 4 * BlackBox::kSteps);
    const SharedBlackBox here = SharedBlackBox::create();
    SharedBlackBox there = SharedBlackBox::attach(here.fd());
    for (std::uint64_t i = 0; i < count; ++i) there.record(line_of(i));
    const std::vector<TextLine> lines = here.lines();
    RC_ASSERT(lines.size() == std::min<std::uint64_t>(count, BlackBox::kSteps));
    for (std::size_t i = 0; i < lines.size(); ++i) RC_ASSERT(number_of(lines[i]) == count - lines.size() + i);
  }));
}

TEST(SharedBlackBox, OutlivesAProcessThatIsKilledWhileItRecords) {
  for (int i = 0; i < 20; ++i) {
    const SharedBlackBox here = SharedBlackBox::create();
    const pid_t child = fork();
    if (child == 0) {
      SharedBlackBox there = SharedBlackBox::attach(here.fd());
      for (std::uint64_t number = 0;; ++number) there.record(line_of(number));
    }
    for (std::vector<TextLine> lines; lines.empty() || number_of(lines.back()) < BlackBox::kSteps; lines = here.lines())
      usleep(100);
    usleep(static_cast<useconds_t>(100 * i));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::vector<TextLine> lines = here.lines();
    ASSERT_EQ(lines.size(), BlackBox::kSteps);
    const std::uint64_t first = number_of(lines.front());
    for (std::size_t k = 0; k < lines.size(); ++k) ASSERT_EQ(number_of(lines[k]), first + k);
  }
}

TEST(SharedBlackBox, LinesOfAProcessThatRecordsAreWholeAndWithoutAGap) {
  const SharedBlackBox here = SharedBlackBox::create();
  const pid_t child = fork();
  if (child == 0) {
    SharedBlackBox there = SharedBlackBox::attach(here.fd());
    for (std::uint64_t number = 0;; ++number) there.record(line_of(number));
  }
  while (here.lines().empty()) usleep(100);  // it begins
  std::uint64_t newest = 0, several = 0;
  for (int i = 0; i < 2000 || (several <= 100 && i < 2'000'000); ++i) {
    const std::vector<TextLine> lines = here.lines();
    several += lines.size() > 1 ? 1 : 0;
    for (std::size_t k = 0; k < lines.size(); ++k)
      ASSERT_EQ(number_of(lines[k]), number_of(lines.front()) + k) << "copy " << i;
    if (lines.empty()) continue;  // it had not begun
    ASSERT_GE(number_of(lines.back()), newest);
    newest = number_of(lines.back());
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_GT(several, 100U);
}

TEST(SharedBlackBox, CorruptedMemoryIsReadWithinItsBounds) {
  const SharedBlackBox box = SharedBlackBox::create();
  const off_t size = lseek(box.fd(), 0, SEEK_END);
  const std::string rubbish(static_cast<std::size_t>(size), '\xff');
  ASSERT_EQ(pwrite(box.fd(), rubbish.data(), rubbish.size(), 0), size);
  const std::vector<TextLine> lines = box.lines();
  EXPECT_EQ(lines.size(), BlackBox::kSteps);
  for (const TextLine& line : lines) EXPECT_EQ(line.view().size(), TextLine::kCapacity);
}

TEST(SharedBlackBox, RefusesOtherMemory) {
  const int other = memfd_create("other", MFD_CLOEXEC);
  EXPECT_THROW(SharedBlackBox::attach(other), SystemError);
  EXPECT_THROW(SharedBlackBox::attach(-1), SystemError);
  close(other);
}

}  // namespace
}  // namespace mrroc::process::shared_black_box_test
