#include "process/record/step_ring.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <thread>
#include <vector>

#include "mrroc/errors.hpp"

namespace mrroc::process::step_ring_test {
namespace {

EncodedStep step_of(std::uint64_t number) {
  EncodedStep step;
  step.clear();
  return step << number;
}

std::vector<std::byte> bytes_of(std::uint64_t number) {
  const EncodedStep step = step_of(number);
  return {step.view().begin(), step.view().end()};
}

TEST(StepRing, CarriesStepsInOrder) {
  StepRing runner = StepRing::create();
  StepRing task = StepRing::attach(runner.fd());
  EXPECT_FALSE(runner.take());
  for (std::uint64_t number = 0; number < 3 * StepRing::kSteps; ++number) {
    task.add(10 * number, step_of(number), false);
    if (number % 2 == 0) continue;
    for (const std::uint64_t expected : {number - 1, number}) {
      const auto step = runner.take();
      ASSERT_TRUE(step);
      EXPECT_EQ(step->tick, 10 * expected);
      EXPECT_EQ(step->cdr, bytes_of(expected));
    }
  }
  EXPECT_EQ(runner.added(), 3 * StepRing::kSteps);
  EXPECT_EQ(runner.dropped(), 0U);
  EXPECT_FALSE(runner.ended());
  task.end();
  EXPECT_TRUE(runner.ended());
}

TEST(StepRing, DropsAndCountsWhenFull) {
  StepRing runner = StepRing::create();
  StepRing task = StepRing::attach(runner.fd());
  for (std::uint64_t number = 0; number < StepRing::kSteps + 5; ++number) task.add(number, step_of(number), false);
  EXPECT_EQ(runner.added(), StepRing::kSteps);
  EXPECT_EQ(runner.dropped(), 5U);
  EXPECT_EQ(runner.take()->cdr, bytes_of(0));
  task.add(99, step_of(99), false);
  for (std::uint64_t number = 1; number < StepRing::kSteps; ++number) EXPECT_EQ(runner.take()->cdr, bytes_of(number));
  EXPECT_EQ(runner.take()->cdr, bytes_of(99));
  EXPECT_FALSE(runner.take());
}

TEST(StepRing, LosesNothingWhenTheTaskWaits) {
  constexpr std::uint64_t kCount = 2000;
  StepRing runner = StepRing::create();
  std::thread task([fd = runner.fd()] {
    StepRing ring = StepRing::attach(fd);
    for (std::uint64_t number = 0; number < kCount; ++number) ring.add(number, step_of(number), true);
    ring.end();
  });
  for (std::uint64_t number = 0; number < kCount;) {
    const auto step = runner.take();
    if (!step) continue;
    EXPECT_EQ(step->cdr, bytes_of(number));
    ++number;
    if (number % 500 == 0) usleep(20'000);  // the ring is full meanwhile
  }
  task.join();
  EXPECT_TRUE(runner.ended());
  EXPECT_EQ(runner.dropped(), 0U);
}

/// A reader that takes nothing and then dies: its writer, which had waited, drops the step and continues.
TEST(StepRing, WaitsNoLongerThanItsReaderLives) {
  std::array<int, 2> answer{};
  ASSERT_EQ(pipe(answer.data()), 0);
  const pid_t reader = fork();
  if (reader == 0) {
    StepRing ring = StepRing::create();
    if (fork() != 0) pause();  // the writer kills it
    StepRing writer = StepRing::attach(ring.fd());
    for (std::uint64_t number = 0; number < StepRing::kSteps; ++number) writer.add(number, step_of(number), true);
    std::thread later([dying = getppid()] {
      usleep(50'000);  // the writer waits by then
      kill(dying, SIGKILL);
    });
    writer.add(99, step_of(99), true);
    const auto dropped = static_cast<char>(writer.dropped());
    later.join();
    _exit(write(answer[1], &dropped, 1) == 1 ? 0 : 1);
  }
  close(answer[1]);
  EXPECT_EQ(waitpid(reader, nullptr, 0), reader);
  char dropped = 0;
  EXPECT_EQ(read(answer[0], &dropped, 1), 1) << "the writer has ended";
  EXPECT_EQ(dropped, 1);
  close(answer[0]);
}

TEST(StepRing, WithADamagedCounterIsEmpty) {
  StepRing runner = StepRing::create();
  StepRing task = StepRing::attach(runner.fd());
  task.add(1, step_of(1), false);
  for (const std::uint64_t added : {std::uint64_t{0}, StepRing::kSteps + std::uint64_t{1}, ~std::uint64_t{0}}) {
    ASSERT_EQ(pwrite(runner.fd(), &added, sizeof(added), 0), static_cast<ssize_t>(sizeof(added)));
    EXPECT_FALSE(runner.take()) << added;
  }
}

TEST(StepRing, RefusesAnotherMemory) {
  const int fd = memfd_create("other", 0);
  ASSERT_EQ(ftruncate(fd, 100), 0);
  EXPECT_THROW(StepRing::attach(fd), SystemError);
  close(fd);
}

}  // namespace
}  // namespace mrroc::process::step_ring_test
