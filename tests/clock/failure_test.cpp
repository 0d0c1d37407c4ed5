#include <gtest/gtest.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "clock/child.hpp"
#include "clock/thread_deployment.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::clock::failure_test {
namespace {

std::string message(const std::function<void()>& action) {
  try {
    action();
  } catch (const SystemError& error) {
    return error.detail();
  }
  return "no SystemError";
}

TEST(ClockFailure, ZeroTimeLoopNamesItsParticipants) {
  HostOptions options;
  options.delta_limit = 100;
  ThreadDeployment deployment({"a", "bystander", "b"}, options);
  Clock* clocks[2];
  int senders[2];
  int receivers[2];
  for (const int me : {0, 1}) {
    const std::string name = me == 0 ? "a" : "b";
    clocks[me] = &deployment.attach(name);
    senders[me] = clocks[me]->register_sender(name);
    receivers[me] = clocks[me]->register_receiver(me == 0 ? "b" : "a");
    deployment.body([&, me](Clock& clock) {
      if (clock.wait(12) == Wake::tick && me == 0) {
        clock.sent(senders[0]);
        clocks[1]->arrived(receivers[1]);
      }
      while (clock.wait(13) == Wake::mail) {
        clock.sent(senders[me]);
        clocks[1 - me]->arrived(receivers[1 - me]);
      }
    });
  }
  deployment.add("bystander", [](Clock& clock) {
    while (clock.wait(clock.tick() + 1) == Wake::tick) {
    }
  });
  deployment.start();
  while (deployment.host.state() != State::failed) std::this_thread::yield();
  EXPECT_EQ(deployment.host.error(), "zero-time loop at tick 12 between a, b: 100 deltas");
  deployment.join();
}

TEST(ClockFailure, DeadEndNamesTheWaitingProcesses) {
  ThreadDeployment deployment({"arm", "press", "belt"});
  deployment.add("arm", [](Clock& clock) {
    EXPECT_EQ(clock.wait(12), Wake::tick);
    EXPECT_EQ(clock.wait(kNever), Wake::interrupted);
  });
  deployment.add("press", [](Clock& clock) { clock.wait(3); });
  deployment.add("belt", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.error(),
            "nothing can happen any more at tick 12: arm, belt waiting for mail that no process can send; "
            "ended: press");
  EXPECT_TRUE(deployment.host.failed_with("arm"));
  EXPECT_TRUE(deployment.host.failed_with("belt"));
  EXPECT_FALSE(deployment.host.failed_with("press")) << "it is the cause";
  EXPECT_FALSE(deployment.host.failed_with("nobody"));
}

TEST(ClockFailure, FailEndsEveryWaitAndTheFirstCauseStays) {
  ThreadDeployment deployment({"a", "b"});
  deployment.add("a", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  deployment.add("b", [&](Clock& clock) {
    EXPECT_EQ(clock.wait(3), Wake::tick);
    deployment.host.fail("the wrist is on fire");
    deployment.host.fail("so is the arm");
    deployment.host.end();
    EXPECT_EQ(clock.wait(4), Wake::interrupted);
  });
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.state(), State::failed);
  EXPECT_EQ(deployment.host.error(), "the wrist is on fire");
  EXPECT_EQ(deployment.host.describe(), "failed: the wrist is on fire");
}

TEST(ClockFailure, EventThatThrowsFailsTheClock) {
  ThreadDeployment deployment({"a"});
  deployment.add("a", [](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  deployment.host.at_tick(3, [](Tick) { throw std::runtime_error("no such button"); });
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.error(), "event at tick 3: no such button");
}

TEST(ClockFailure, UncountedArrivalIsAnError) {
  ThreadDeployment deployment({"a", "b"});
  deployment.attach("a").register_sender("a/b");
  deployment.body([](Clock& clock) { EXPECT_EQ(clock.wait(kNever), Wake::interrupted); });
  int receiver = -1;
  receiver = deployment
                 .add("b",
                      [&receiver](Clock& clock) {
                        clock.arrived(receiver);
                        EXPECT_EQ(clock.wait(1), Wake::interrupted);
                      })
                 .register_receiver("a/b");
  deployment.start();
  deployment.join();
  EXPECT_EQ(deployment.host.error(),
            "topic a/b: 1 messages arrived, 0 were sent: one was not counted, or arrived twice");
}

TEST(ClockFailure, RevokesWhatAKilledProcessHeld) {
  HostOptions options;
  options.participants = {"survivor", "victim"};
  ClockHost host(options);
  Child victim([&host] {
    const auto clock = attach_clock(host.fd(), "victim");
    const int sender = clock->register_sender("victim/survivor");
    clock->register_receiver("survivor/victim");
    if (!clock->start() || clock->wait(5) != Wake::tick) return;
    clock->sent(sender);  // never delivered
    for (;;) ::pause();   // never blocks in its clock either
  });
  Child survivor([&host] {
    const auto clock = attach_clock(host.fd(), "survivor");
    const int sender = clock->register_sender("survivor/victim");
    clock->register_receiver("victim/survivor");
    if (!clock->start() || clock->wait(5) != Wake::tick) ::_exit(1);
    clock->sent(sender);  // never received
    if (clock->wait(20) != Wake::tick || clock->tick() != 20) ::_exit(2);
  });
  ASSERT_TRUE(host.wait_ready(60).empty());
  host.start();
  const std::string held =
      "running at tick 5, delta 2; at work: victim; in flight on victim/survivor to survivor: 1; "
      "in flight on survivor/victim to victim: 1";
  const std::string also_held =
      "running at tick 5, delta 2; at work: victim; in flight on survivor/victim to victim: 1; "
      "in flight on victim/survivor to survivor: 1";
  while (host.describe() != held && host.describe() != also_held) std::this_thread::yield();
  victim.kill();
  host.participant_died("victim");
  EXPECT_TRUE(survivor.join());
  EXPECT_EQ(host.state(), State::running) << host.error();
}

TEST(ClockFailure, ASignalHandlerMayInterrupt) {
  HostOptions options;
  options.participants = {"a"};
  ClockHost host(options);
  Child participant([&host] {
    static Clock* clock = nullptr;
    const auto owned = attach_clock(host.fd(), "a");
    clock = owned.get();
    ::signal(SIGUSR1, [](int) { clock->interrupt(); });
    if (!clock->start()) ::_exit(1);
    ::raise(SIGUSR1);
    if (clock->wait(kNever) != Wake::interrupted) ::_exit(2);
  });
  ASSERT_TRUE(host.wait_ready(60).empty());
  host.start();
  EXPECT_TRUE(participant.join());
}

TEST(ClockFailure, StartNamesMissingParticipants) {
  HostOptions options;
  options.participants = {"a", "b", "c"};
  ClockHost host(options);
  Child b([&host] { attach_clock(host.fd(), "b")->start(); });
  while (host.wait_ready(0.01).size() > 2) {
  }
  EXPECT_EQ(host.wait_ready(0), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(message([&host] { host.start(); }), "clock: not ready for the start: a, c");
  EXPECT_EQ(host.describe(), "setting up, not ready: a, c");
  host.end();
  EXPECT_TRUE(b.join());
}

TEST(ClockFailure, TopicHasOneSender) {
  HostOptions options;
  options.participants = {"a", "b"};
  ClockHost host(options);
  std::vector<Child> children;
  for (const char* name : {"a", "b"})
    children.emplace_back([&host, name] {
      const auto clock = attach_clock(host.fd(), name);
      clock->register_sender("press/arm/command");
      clock->start();
    });
  ASSERT_TRUE(host.wait_ready(60).empty());
  const std::string text = message([&host] { host.start(); });
  EXPECT_TRUE(text == "clock: topic 'press/arm/command' has two senders, a and b: expected one" ||
              text == "clock: topic 'press/arm/command' has two senders, b and a: expected one")
      << text;
  host.end();
}

TEST(ClockFailure, RefusesInvalidOptionsAndNames) {
  const auto host_of = [](std::vector<std::string> names, double period, std::uint64_t limit) {
    HostOptions options;
    options.participants = std::move(names);
    options.period = period;
    options.delta_limit = limit;
    return message([&options] { ClockHost host(options); });
  };
  EXPECT_EQ(host_of({"a", "a"}, 0.002, 10), "clock: participant 'a' is named twice");
  EXPECT_EQ(host_of({""}, 0.002, 10), "clock: participant '': expected 1 to 31 characters");
  EXPECT_EQ(host_of(std::vector<std::string>(65, "x"), 0.002, 10), "clock: 65 participants: expected at most 64");
  EXPECT_EQ(host_of({"a"}, -1, 10), "clock: period -1.000000 s: expected 1e-6 to 10");
  EXPECT_EQ(host_of({"a"}, 0.002, 1), "clock: delta_limit 1: expected at least 2");

  HostOptions options;
  options.participants = {"a", "b"};
  ClockHost host(options);
  EXPECT_EQ(message([&] { attach_clock(host.fd(), "c"); }),
            "clock: participant 'c' is not expected: expected one of a, b");
  const auto a = attach_clock(host.fd(), "a");
  EXPECT_EQ(message([&] { attach_clock(host.fd(), "a"); }),
            "clock: participant 'a' is attached already, by process " + std::to_string(::getpid()));
  const std::string long_name(96, 'x');
  EXPECT_EQ(message([&] { a->register_sender(long_name); }),
            std::string("clock: topic '").append(long_name).append("': expected 1 to 95 characters"));
  EXPECT_EQ(message([&] {
              for (std::uint32_t i = 0; i <= kMaxLinks; ++i) a->register_receiver("t");
            }),
            "clock: topic 't': the table of 2048 links is full");
  EXPECT_NE(message([] { attach_clock(0, "a"); }).find("descriptor 0 is not this version's clock memory"),
            std::string::npos);
  EXPECT_EQ(message([&] { host.participant_died("x"); }), "clock: 'x' is not a participant");
  const auto panel = host.operator_clock();
  EXPECT_EQ(message([&] { host.operator_clock(); }), "clock: the host has given out its operator clock already");
}

}  // namespace
}  // namespace mrroc::clock::failure_test
