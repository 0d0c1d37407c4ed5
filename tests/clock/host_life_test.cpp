// Reaction of a participant when the process that keeps its clock is killed, stopped or held.
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <utility>

#include "clock/child.hpp"
#include "clock/host.hpp"
#include "clock/participant.hpp"

namespace mrroc::clock::host_life_test {
namespace {

/// The owner of a clock and its one participant, which writes 'r' when it runs, executes `body` and then writes 'y'.
class Owned {
 public:
  Owned(Mode mode, Part part, void (*body)(Clock&)) : owner_([=, this] { own(mode, part, body); }) {
    EXPECT_EQ(answer(), 'r');
  }
  ~Owned() {
    ::close(pipe_.ends[0]);
    ::close(pipe_.ends[1]);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;

  Child& owner() { return owner_; }
  char answer() const {
    char letter = 0;
    EXPECT_EQ(::read(pipe_.ends[0], &letter, 1), 1);
    return letter;
  }
  bool answers_within(int milliseconds) const {
    pollfd entry{pipe_.ends[0], POLLIN, 0};
    return ::poll(&entry, 1, milliseconds) > 0;
  }

 private:
  struct Pipe {
    Pipe() { EXPECT_EQ(::pipe(ends), 0); }
    int ends[2];
  };

  void own(Mode mode, Part part, void (*body)(Clock&)) const {
    HostOptions options;
    options.mode = mode;
    options.participants = {"a"};
    ClockHost host(options);
    Child participant([&] {
      const auto clock = attach_clock(host.fd(), "a", part);
      (void)!::write(pipe_.ends[1], clock->start() ? "r" : "n", 1);
      body(*clock);
      (void)!::write(pipe_.ends[1], "y", 1);
    });
    if (!host.wait_ready(60).empty()) ::_exit(1);
    host.at_tick(kNever - 1, [](Tick) {});  // so that waiting for mail is not a dead end
    host.run();
  }

  Pipe pipe_;
  Child owner_;
};

void wait_for_mail(Clock& clock) {
  while (clock.wait(kNever) != Wake::interrupted) {
  }
}

void get_mail_all_the_time(Clock& clock) {
  do clock.notify();
  while (clock.wait(kNever) == Wake::mail);
}

/// Like an EDP, which has a robot to stop then.
void wait_for_the_end(Clock& clock) {
  while (!clock.stopping())
    if (clock.wait(kNever) == Wake::interrupted) ::_exit(3);
}

TEST(HostLife, ParticipantEndsAfterAKilledHost) {
  Owned owned(Mode::lockstep, Part::task, wait_for_mail);
  owned.owner().kill();
  EXPECT_EQ(owned.answer(), 'y');
}

TEST(HostLife, ParticipantWithConstantMailEndsAfterAKilledHost) {
  Owned owned(Mode::real, Part::task, get_mail_all_the_time);
  owned.owner().kill();
  EXPECT_EQ(owned.answer(), 'y');
}

/// The process that started it may be unable to kill it: an agent behind ssh. Robots must not continue without
/// supervision.
TEST(HostLife, ParticipantEndsAfterAStoppedHostUnderTheRealClock) {
  for (const auto& [part, body] : {std::pair{Part::task, &wait_for_mail},
                                   {Part::task, &get_mail_all_the_time},
                                   {Part::drives, &wait_for_the_end}}) {
    Owned owned(Mode::real, part, body);
    owned.owner().stop();
    EXPECT_EQ(owned.answer(), 'y');
  }
}

TEST(HostLife, WaitsForAHostHeldByADebugger) {
  Owned owned(Mode::real, Part::task, wait_for_mail);
  owned.owner().hold(2);
  EXPECT_FALSE(owned.answers_within(500));
  owned.owner().stop();
  EXPECT_EQ(owned.answer(), 'y');
}

TEST(HostLife, SimulatedTimeStandsStillWithAStoppedHost) {
  Owned owned(Mode::lockstep, Part::task, wait_for_mail);
  owned.owner().stop();
  EXPECT_FALSE(owned.answers_within(2500)) << "it continues with its host";
  owned.owner().kill();
  EXPECT_EQ(owned.answer(), 'y');
}

}  // namespace
}  // namespace mrroc::clock::host_life_test
