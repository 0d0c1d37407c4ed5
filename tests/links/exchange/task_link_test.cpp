#include <gtest/gtest.h>

#include "links/exchange/task_subordinate.hpp"
#include "links/exchange/task_superior.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"

namespace mrroc::links {
namespace {

/// An MP's and an ECP's end in one process.
struct TaskPair {
  TaskPair() { mp.connect(kPatience); }
  TestDomain net;
  TestClock clock;
  TaskSubordinate ecp{net.domain, clock, "t/arm"};
  TaskSuperior mp{net.domain, clock, "t/arm", "arm"};
};

TEST(TaskLink, CarriesCommandsInOrderAndTellsWhichTheStatusKnows) {
  TaskPair pair;
  TaskSubordinate& ecp = pair.ecp;
  TaskSuperior& mp = pair.mp;
  TaskCommand command;
  EXPECT_FALSE(ecp.take(command));
  const auto report = [&](TaskState state, std::uint64_t step) {
    TaskStatus status;
    status.state = state;
    status.step = step;
    ecp.report(status);
  };
  report(TaskState::idle, 0);
  EXPECT_EQ(mp.send(TaskCommandKind::start), 1U);
  EXPECT_EQ(mp.send(TaskCommandKind::pause), 2U);
  ASSERT_TRUE(ecp.take(command));
  EXPECT_EQ(command.kind, TaskCommandKind::start);
  report(TaskState::running, 0);
  ASSERT_TRUE(ecp.take(command));
  EXPECT_EQ(command.kind, TaskCommandKind::pause);
  report(TaskState::paused, 4);

  TaskStatus status;
  std::uint64_t last_command = 9;
  ASSERT_TRUE(mp.take(status, last_command));
  EXPECT_EQ(last_command, 0U);
  ASSERT_TRUE(mp.take(status, last_command));
  EXPECT_EQ(status.state, TaskState::running);
  EXPECT_EQ(last_command, 1U);
  ASSERT_TRUE(mp.take(status, last_command));
  EXPECT_EQ(status.state, TaskState::paused);
  EXPECT_EQ(status.step, 4U);
  EXPECT_EQ(last_command, 2U);
  EXPECT_FALSE(mp.take(status, last_command));
  EXPECT_TRUE(mp.peer_alive());
  EXPECT_TRUE(ecp.peer_alive());
}

// original's defect 3: buffers of one message, a second one overwrote the first; replies taken in were lost on entry
TEST(TaskLink, WhatComesBetweenTwoLooksIsAllTakenInOrder) {
  TaskPair pair;
  TaskSubordinate& ecp = pair.ecp;
  TaskSuperior& mp = pair.mp;
  const std::vector<TaskCommandKind> kinds = {TaskCommandKind::start, TaskCommandKind::pause, TaskCommandKind::resume,
                                              TaskCommandKind::trigger, TaskCommandKind::stop};
  for (int i = 0; i < 3; ++i)
    for (const TaskCommandKind kind : kinds) mp.send(kind);
  TaskCommand command;
  TaskStatus status;
  for (std::uint64_t n = 0; n < 15; ++n) {
    ASSERT_TRUE(ecp.take(command)) << n;
    EXPECT_EQ(command.kind, kinds[n % kinds.size()]) << n;
    status.step = n;
    ecp.report(status);
  }
  EXPECT_FALSE(ecp.take(command));
  for (std::uint64_t n = 0; n < 15; ++n) {
    std::uint64_t last_command = 0;
    ASSERT_TRUE(mp.take(status, last_command)) << n;
    EXPECT_EQ(status.step, n);
    EXPECT_EQ(last_command, n + 1);
  }
  EXPECT_EQ(ecp.counters().overwritten + mp.counters().overwritten, 0U);
}

TEST(TaskLink, KeepsMoreThanAMailboxHoldsAndReportsWhatIsLost) {
  TaskPair pair;
  TaskSubordinate& ecp = pair.ecp;
  TaskSuperior& mp = pair.mp;
  TaskCommand command;
  mp.send(TaskCommandKind::start);
  for (std::size_t i = 1; i < TaskSubordinate::kDepth; ++i) mp.send(TaskCommandKind::message);
  for (std::size_t i = 0; i < TaskSubordinate::kDepth; ++i) {
    ASSERT_TRUE(ecp.take(command)) << i;
    EXPECT_EQ(command.kind, i == 0 ? TaskCommandKind::start : TaskCommandKind::message);
  }
  EXPECT_FALSE(ecp.take(command));
  mp.send(TaskCommandKind::start);
  for (std::size_t i = 0; i < TaskSubordinate::kDepth; ++i) mp.send(TaskCommandKind::message);
  EXPECT_THROW(ecp.take(command), NonFatalError) << "the start is lost";
  EXPECT_TRUE(ecp.take(command)) << "it is reported once";
}

}  // namespace
}  // namespace mrroc::links
