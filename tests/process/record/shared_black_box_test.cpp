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

using recording::RecordedStep;

/// A step with the number at both ends, so that a torn step is detected.
EncodedStep step_of(std::uint64_t number) {
  EncodedStep step;
  step.clear();
  return step << number << std::string_view{" a step "} << number;
}

std::uint64_t number_of(const RecordedStep& step) {
  const EncodedStep expected = step_of(step.tick);
  EXPECT_TRUE(std::equal(step.cdr.begin(), step.cdr.end(), expected.view().begin(), expected.view().end()));
  return step.tick;
}

TEST(SharedBlackBox, HasTheLastStepsInOrder) {
  EXPECT_TRUE(rc::check([] {
    const auto count = *rc::gen::inRange<std::uint64_t>(0, 4 * BlackBox::kSteps);
    const SharedBlackBox here = SharedBlackBox::create();
    SharedBlackBox there = SharedBlackBox::attach(here.fd());
    for (std::uint64_t i = 0; i < count; ++i) there.record(i, step_of(i));
    const std::vector<RecordedStep> steps = here.steps();
    RC_ASSERT(steps.size() == std::min<std::uint64_t>(count, BlackBox::kSteps));
    for (std::size_t i = 0; i < steps.size(); ++i) RC_ASSERT(number_of(steps[i]) == count - steps.size() + i);
  }));
}

TEST(SharedBlackBox, OutlivesAProcessThatIsKilledWhileItRecords) {
  for (int i = 0; i < 20; ++i) {
    const SharedBlackBox here = SharedBlackBox::create();
    const pid_t child = fork();
    if (child == 0) {
      SharedBlackBox there = SharedBlackBox::attach(here.fd());
      for (std::uint64_t number = 0;; ++number) there.record(number, step_of(number));
    }
    for (std::vector<RecordedStep> steps; steps.empty() || number_of(steps.back()) < BlackBox::kSteps;
         steps = here.steps())
      usleep(100);
    usleep(static_cast<useconds_t>(100 * i));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::vector<RecordedStep> steps = here.steps();
    ASSERT_EQ(steps.size(), BlackBox::kSteps);
    const std::uint64_t first = number_of(steps.front());
    for (std::size_t k = 0; k < steps.size(); ++k) ASSERT_EQ(number_of(steps[k]), first + k);
  }
}

TEST(SharedBlackBox, StepsOfAProcessThatRecordsAreWholeAndWithoutAGap) {
  const SharedBlackBox here = SharedBlackBox::create();
  const pid_t child = fork();
  if (child == 0) {
    SharedBlackBox there = SharedBlackBox::attach(here.fd());
    for (std::uint64_t number = 0;; ++number) there.record(number, step_of(number));
  }
  while (here.steps().empty()) usleep(100);  // it begins
  std::uint64_t newest = 0, several = 0;
  for (int i = 0; i < 2000 || (several <= 100 && i < 2'000'000); ++i) {
    const std::vector<RecordedStep> steps = here.steps();
    several += steps.size() > 1 ? 1 : 0;
    for (std::size_t k = 0; k < steps.size(); ++k)
      ASSERT_EQ(number_of(steps[k]), number_of(steps.front()) + k) << "copy " << i;
    if (steps.empty()) continue;  // it had not begun
    ASSERT_GE(number_of(steps.back()), newest);
    newest = number_of(steps.back());
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
  const std::vector<RecordedStep> steps = box.steps();
  EXPECT_EQ(steps.size(), BlackBox::kSteps);
  for (const RecordedStep& step : steps) EXPECT_EQ(step.cdr.size(), EncodedStep::kCapacity);
}

TEST(SharedBlackBox, RefusesOtherMemory) {
  const int other = memfd_create("other", MFD_CLOEXEC);
  EXPECT_THROW(SharedBlackBox::attach(other), SystemError);
  EXPECT_THROW(SharedBlackBox::attach(-1), SystemError);
  close(other);
}

}  // namespace
}  // namespace mrroc::process::shared_black_box_test
