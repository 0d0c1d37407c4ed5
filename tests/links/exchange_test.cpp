#include <gtest/gtest.h>

#include <thread>

#include "links/connect.hpp"
#include "links/raw_writer.hpp"
#include "links/robot_requester.hpp"
#include "links/robot_responder.hpp"
#include "links/sensor_requester.hpp"
#include "links/sensor_responder.hpp"
#include "links/task_subordinate.hpp"
#include "links/task_superior.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::links {
namespace {

/// An ECP's and an EDP's end in one process: what one writes the other has when the call returns.
struct RobotPair {
  explicit RobotPair(bool simulated = false, Tick timeout = 100000)
      : clock(simulated), ecp(net.domain, clock, "t/arm", "arm_edp", timeout), edp(net.domain, clock, "t/arm", 1000) {
    ecp.connect(kPatience);
  }
  /// The EDP answers what it is asked.
  void answer(double value) {
    ASSERT_TRUE(edp.take(command, sequence));
    RobotState answered;
    answered.joints = JointVector::Constant(6, value);
    EXPECT_TRUE(edp.reply(answered, sequence));
  }

  TestDomain net;
  TestClock clock;
  RobotRequester ecp;
  RobotResponder edp;
  RobotCommand command;
  std::uint64_t sequence = 0;
  RobotState state;
};

ErrorCode code_of(const std::function<void()>& action, const std::string& part) {
  try {
    action();
  } catch (const SystemError& error) {
    EXPECT_NE(error.detail().find(part), std::string::npos) << error.detail();
    return error.code();
  }
  return ErrorCode::none;
}

TEST(RobotLink, ExchangesCommandAndState) {
  RobotPair pair;
  EXPECT_FALSE(pair.edp.take(pair.command, pair.sequence)) << "pings are no commands";
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.joints = JointVector::LinSpaced(6, 0.0, 1.0);
  for (int i = 1; i <= 3; ++i) {
    pair.ecp.send(command);
    pair.answer(i);
    EXPECT_EQ(pair.command.joints, command.joints);
    pair.ecp.receive(pair.state);
    EXPECT_EQ(pair.state.joints[5], i);
  }
  EXPECT_EQ(pair.ecp.stale_replies(), 0U);
  EXPECT_EQ(pair.clock.in_flight.load(), 0)
      << "what is sent is counted, what has arrived is taken off, pings are neither";
}

TEST(RobotLink, WaitsForTheReply) {
  for (const bool simulated : {false, true}) {
    RobotPair pair(simulated);
    std::thread edp([&] {
      pair.clock.next_delta();  // the thread stands for a process that runs in a later delta
      EXPECT_TRUE(eventually([&] { return pair.edp.take(pair.command, pair.sequence); }));
      pair.edp.reply({}, pair.sequence);
    });
    pair.ecp.send({});
    pair.clock.next_delta();
    EXPECT_NO_THROW(pair.ecp.receive(pair.state));
    edp.join();
  }
}

TEST(RobotLink, DropsRepliesToOtherRequests) {
  RobotPair pair;
  RawWriter<RobotState> late(pair.net.domain, "t/arm/state");
  auto wire = wire_of(RobotState{});
  const std::uint64_t here = pair.net.domain.boot();
  const auto send_late = [&](std::uint64_t sequence, std::uint64_t boot, std::uint64_t answers) {
    wire.header.number = sequence;
    wire.header.boot = boot;
    wire.header.answers = answers;
    late.write(wire);
  };
  pair.ecp.send({});
  send_late(9, here, here);      // to a request that was never made
  send_late(1, here + 1, here);  // from a peer that is not the one of the hand-shake
  send_late(1, here, here + 1);  // to a process that had this sequence before its restart
  pair.answer(4.5);
  pair.ecp.receive(pair.state);
  EXPECT_EQ(pair.state.joints[0], 4.5);
  EXPECT_EQ(pair.ecp.stale_replies(), 3U);
}

TEST(RobotLink, AMalformedReplyIsNone) {
  RobotPair pair(false, 50);
  RawWriter<RobotState> writer(pair.net.domain, "t/arm/state");
  pair.ecp.send({});
  auto wire = wire_of(RobotState{});
  wire.header.number = 1;
  wire.header.boot = wire.header.answers = pair.net.domain.boot();
  wire.enabled = 2;
  writer.write(wire);
  EXPECT_THROW(pair.ecp.receive(pair.state), SystemError);
  EXPECT_EQ(pair.ecp.malformed_replies(), 1U);
}

TEST(RobotLink, ARequestThatIsOvertakenIsNotAnswered) {
  RobotPair pair;
  pair.ecp.send({});
  std::uint64_t first = 0;
  ASSERT_TRUE(pair.edp.take(pair.command, first));
  pair.ecp.send({});
  ASSERT_TRUE(pair.edp.take(pair.command, pair.sequence));
  EXPECT_FALSE(pair.edp.reply({}, first));
  EXPECT_TRUE(pair.edp.reply({}, pair.sequence));
  EXPECT_NO_THROW(pair.ecp.receive(pair.state));
}

TEST(RobotLink, SilenceIsAnErrorInRealTime) {
  RobotPair pair(false, 20);
  pair.ecp.send({});
  EXPECT_EQ(code_of([&] { pair.ecp.receive(pair.state); }, "arm_edp has not answered on topic t/arm/state"),
            ErrorCode::process_silent);
}

TEST(RobotLink, TheReplyIsDueAtTheTickOfTheCommand) {
  RobotPair pair(false, 0);
  RobotCommand command;
  command.kind = CommandKind::hold;
  command.start_tick = pair.clock.tick() + 20;
  command.reply_step = 5;
  pair.ecp.send(command);
  EXPECT_THROW(pair.ecp.receive(pair.state), SystemError);
  EXPECT_GE(pair.clock.tick(), command.start_tick + command.reply_step);
}

TEST(RobotLink, SimulatedTimeHasNoDeadline) {
  RobotPair pair(true, 0);
  pair.ecp.send({});
  std::thread host([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pair.clock.interrupt();
  });
  EXPECT_THROW(pair.ecp.receive(pair.state), Stopped);
  host.join();
}

TEST(RobotLink, AnInterruptedClockStopsTheWait) {
  RobotPair pair;
  pair.ecp.send({});
  pair.clock.interrupt();
  EXPECT_THROW(pair.ecp.receive(pair.state), Stopped);
}

TEST(Connect, NamesWhoDoesNotAnswer) {
  TestDomain net;
  TestClock clock;
  RobotRequester ecp(net.domain, clock, "t/arm", "arm_edp");
  EXPECT_EQ(code_of([&] { ecp.connect(0.1); }, "arm_edp does not answer: nothing on topic t/arm/state"),
            ErrorCode::link_lost);
}

TEST(Connect, ReportsAPeerWithAnotherMessageTypeAtOnce) {
  TestDomain net;
  TestClock clock;
  RobotRequester ecp(net.domain, clock, "t/arm", "arm_edp");
  const Entity other{dds_create_participant(static_cast<dds_domainid_t>(net.domain.id()), nullptr, nullptr),
                     "participant", ""};
  const Entity topic{
      dds_create_topic(other.get(), &WireOf<SensorReading>::descriptor(), "t/arm/command", nullptr, nullptr), "topic",
      ""};
  const Entity reader{dds_create_reader(other.get(), topic.get(), link_reader_qos().get(), nullptr), "reader", ""};
  EXPECT_EQ(code_of([&] { ecp.connect(kPatience); }, "topic t/arm/command: a peer has another message type"),
            ErrorCode::configuration);
}

TEST(Connect, TakesAPongForItsOwnPingOnly) {
  TestDomain net;
  TestClock clock;
  RobotRequester ecp(net.domain, clock, "t/arm", "arm_edp");
  Writer<RobotState> edp(net.domain, clock, "t/arm/state");
  edp.pong(net.domain.boot() + 1);
  EXPECT_THROW(ecp.connect(0.05), SystemError);
}

struct SensorPair {
  explicit SensorPair(bool published, bool simulated = false)
      : clock(simulated),
        vsp(net.domain, clock, "t/wrist", {"arm", "mp"}, published),
        arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.published = published}),
        mp(net.domain, clock, "t/wrist", "mp", "wrist_vsp", {.published = published}) {
    arm.connect(kPatience);
    mp.connect(kPatience);
  }

  TestDomain net;
  TestClock clock;
  SensorResponder vsp;
  SensorRequester arm;
  SensorRequester mp;
  SensorRequest request;
  SensorReading reading;
  SensorResponder::Ticket ticket;
};

TEST(SensorLink, AnswersEachClientItsOwnRequest) {
  SensorPair pair(false);
  EXPECT_FALSE(pair.vsp.take(pair.request, pair.ticket));
  pair.mp.request({SensorRequestKind::bias, 7});
  pair.arm.request({SensorRequestKind::reading, 8});
  SensorReading reading;
  reading.channel_count = 1;
  ASSERT_TRUE(pair.vsp.take(pair.request, pair.ticket));
  EXPECT_EQ(pair.ticket.client, 0U) << "clients are served in the order given";
  EXPECT_EQ(pair.request.measure_at, 8U);
  reading.values[0] = 1.5;
  EXPECT_TRUE(pair.vsp.reply(reading, pair.ticket));
  ASSERT_TRUE(pair.vsp.take(pair.request, pair.ticket));
  EXPECT_EQ(pair.ticket.client, 1U);
  EXPECT_EQ(pair.request.kind, SensorRequestKind::bias);
  reading.values[0] = 2.5;
  EXPECT_TRUE(pair.vsp.reply(reading, pair.ticket));
  EXPECT_FALSE(pair.vsp.take(pair.request, pair.ticket));
  pair.arm.receive(pair.reading);
  EXPECT_EQ(pair.reading.values[0], 1.5);
  pair.mp.receive(pair.reading);
  EXPECT_EQ(pair.reading.values[0], 2.5);
  EXPECT_FALSE(pair.arm.latest(pair.reading)) << "nothing is published";
  EXPECT_THROW(pair.vsp.publish(reading), SystemError);
}

TEST(SensorLink, PublishesToAllWhoReadIt) {
  SensorPair pair(true);
  EXPECT_FALSE(pair.arm.latest(pair.reading));
  SensorReading reading;
  for (reading.sequence = 1; reading.sequence <= 50; ++reading.sequence) pair.vsp.publish(reading);
  for (SensorRequester* client : {&pair.arm, &pair.mp}) {
    for (int i = 0; i < 2; ++i) {
      pair.reading.sequence = 0;
      ASSERT_TRUE(client->latest(pair.reading));
      EXPECT_EQ(pair.reading.sequence, 50U);
    }
  }
}

TEST(SensorLink, ConnectsToThePublishedReadingsToo) {
  TestDomain net;
  TestClock clock;
  SensorResponder vsp(net.domain, clock, "t/wrist", {"arm"}, false);
  SensorRequester arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.published = true});
  EXPECT_EQ(code_of([&] { arm.connect(0.1); }, "wrist_vsp does not answer: nothing on topic t/wrist/published"),
            ErrorCode::link_lost);
}

TEST(SensorLink, SilenceIsAnErrorInRealTime) {
  TestDomain net;
  TestClock clock;
  SensorResponder vsp(net.domain, clock, "t/wrist", {"arm"}, false);
  SensorRequester arm(net.domain, clock, "t/wrist", "arm", "wrist_vsp", {.timeout = 10});
  arm.connect(kPatience);
  arm.request({});
  SensorReading reading;
  EXPECT_EQ(code_of([&] { arm.receive(reading); }, "wrist_vsp has not answered"), ErrorCode::process_silent);
}

TEST(TaskLink, CarriesCommandsInOrderAndTellsWhichTheStatusKnows) {
  TestDomain net;
  TestClock clock;
  TaskSubordinate ecp(net.domain, clock, "t/arm");
  TaskSuperior mp(net.domain, clock, "t/arm", "arm");
  mp.connect(kPatience);
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
  TestDomain net;
  TestClock clock;
  TaskSubordinate ecp(net.domain, clock, "t/arm");
  TaskSuperior mp(net.domain, clock, "t/arm", "arm");
  mp.connect(kPatience);
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

}  // namespace
}  // namespace mrroc::links
