#include "links/transport/reader.hpp"

#include <gtest/gtest.h>

#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/raw_writer.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

struct Link {
  explicit Link(bool simulated = false, ReaderOptions options = {})
      : clock(simulated), writer(net.domain, clock, "t/x"), reader(net.domain, clock, "t/x", std::move(options)) {}

  void send(std::uint64_t sequence) {
    SensorReading sent;
    sent.sequence = sequence;
    writer.write(sent, sequence);
  }
  /// Numbers of all messages that `take` returns.
  std::vector<std::uint64_t> take_all() {
    std::vector<std::uint64_t> numbers;
    while (reader.take(message, header)) numbers.push_back(message.sequence);
    return numbers;
  }

  TestDomain net;
  TestClock clock;
  Writer<SensorReading> writer;
  Reader<SensorReading> reader;
  SensorReading message;
  Header header;
};

using Numbers = std::vector<std::uint64_t>;

TEST(Reader, TakesEachOnceInOrder) {
  Link link;
  for (std::uint64_t n = 1; n <= 5; ++n) link.send(n);
  EXPECT_EQ(link.take_all(), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_EQ(link.take_all(), Numbers{});
  EXPECT_EQ(link.clock.in_flight.load(), 0);
}

TEST(Reader, TakeNewestDropsAndCountsTheOthers) {
  Link link;
  for (std::uint64_t n = 1; n <= 5; ++n) link.send(n);
  ASSERT_TRUE(link.reader.take_newest(link.message, link.header));
  EXPECT_EQ(link.message.sequence, 5U);
  EXPECT_FALSE(link.reader.take_newest(link.message, link.header));
  EXPECT_EQ(link.reader.counters().stale, 4U);
}

TEST(Reader, OverwritesTheOldestWhenNobodyLooks) {
  Link link(false, {.depth = 4});
  for (std::uint64_t n = 1; n <= 10; ++n) link.send(n);
  EXPECT_EQ(link.take_all(), (Numbers{7, 8, 9, 10}));
  EXPECT_EQ(link.reader.counters().overwritten, 6U);
}

TEST(Reader, LatestKeepsItsValue) {
  Link link(false, {.depth = 4});
  EXPECT_FALSE(link.reader.latest(link.message));
  for (std::uint64_t n = 1; n <= 100; ++n) link.send(n);
  for (int i = 0; i < 2; ++i) {
    link.message.sequence = 0;
    ASSERT_TRUE(link.reader.latest(link.message));
    EXPECT_EQ(link.message.sequence, 100U);
  }
}

TEST(Reader, MessagesOfEarlierDeltasAreVisibleUnderSimulatedTime) {
  Link link(true);
  link.send(1);
  EXPECT_EQ(link.take_all(), Numbers{});
  EXPECT_FALSE(link.reader.take_newest(link.message, link.header));
  EXPECT_FALSE(link.reader.latest(link.message));
  link.clock.next_delta();
  link.send(2);
  link.send(3);
  ASSERT_TRUE(link.reader.latest(link.message));
  EXPECT_EQ(link.message.sequence, 1U);
  EXPECT_EQ(link.take_all(), Numbers{}) << "from the present delta";
  link.clock.next_delta();
  EXPECT_EQ(link.take_all(), (Numbers{2, 3}));
  EXPECT_EQ(link.header.stamp_ns, 0) << "simulated time has no wall clock";
  EXPECT_EQ(link.reader.counters().stale, 0U);
}

TEST(Reader, LatestFindsTheVisibleOneAmongNewerMessages) {
  Link link(true, {.depth = 4});
  for (std::uint64_t n = 1; n <= 3; ++n) link.send(n);
  link.clock.next_delta();
  link.send(4);
  link.send(5);
  ASSERT_TRUE(link.reader.latest(link.message));
  EXPECT_EQ(link.message.sequence, 3U);
  link.clock.next_delta();
  ASSERT_TRUE(link.reader.latest(link.message));
  EXPECT_EQ(link.message.sequence, 5U);
}

TEST(Reader, UncountedLinkDoesNotAffectTheClock) {
  FreeDomain number;
  Domain domain({.id = number.id()});
  TestClock clock(true);
  Writer<TaskStatus> writer(domain, clock, "t/x", {.counted = false});
  Reader<TaskStatus> reader(domain, clock, "t/x", {.counted = false});
  EXPECT_EQ(clock.senders.load() + clock.receivers.load(), 0);
  writer.write({}, 1);
  EXPECT_EQ(clock.in_flight.load(), 0);
  EXPECT_GT(clock.notified.load(), 0);
  TaskStatus status;
  Header header;
  EXPECT_TRUE(reader.take(status, header)) << "visible at once";
}

TEST(Reader, TakeFreshRefusesOldMessages) {
  TestDomain net;
  TestClock clock;
  RawWriter<RobotCommand> writer(net.domain, "t/x");
  Reader<RobotCommand> reader(net.domain, clock, "t/x");
  const auto send = [&](std::uint64_t boot, double age) {
    auto wire = wire_of(RobotCommand{});
    wire.header.boot = boot;
    wire.header.stamp_ns = clock::monotonic_ns() - static_cast<std::int64_t>(age * 1e9);
    writer.write(wire);
  };
  RobotCommand command;
  Header header;
  const std::uint64_t here = net.domain.boot() ^ 1;                   // another process of this machine
  const std::uint64_t elsewhere = net.domain.boot() ^ (1ULL << 40U);  // a clock of another machine
  send(here, 1000);
  EXPECT_FALSE(reader.take_fresh(command, header, 500));
  EXPECT_EQ(reader.counters().stale, 1U);
  send(here, 0);
  send(here, 1000);
  EXPECT_FALSE(reader.take_fresh(command, header, 500)) << "overtaken messages are not used instead";
  send(here, 1000);
  send(here, 0);
  EXPECT_TRUE(reader.take_fresh(command, header, 500));
  send(elsewhere, 1000);
  EXPECT_TRUE(reader.take_fresh(command, header, 500));
  EXPECT_EQ(reader.counters().stale, 4U);
}

TEST(Reader, StampCountsFromTickZeroOnEveryMachine) {
  TestDomain net;
  TestClock clock;
  clock.epoch = clock::monotonic_ns() - 1'000'000'000;
  Reader<RobotCommand> reader(net.domain, clock, "t/x");
  RobotCommand command;
  Header header;
  {
    Writer<RobotCommand> writer(net.domain, clock, "t/x");
    const std::int64_t before = clock::monotonic_ns() - clock.epoch;
    writer.write({}, 1);
    ASSERT_TRUE(reader.take(command, header));
    EXPECT_GE(header.stamp_ns, before);
    EXPECT_LE(header.stamp_ns, clock::monotonic_ns() - clock.epoch);
  }
  RawWriter<RobotCommand> elsewhere(net.domain, "t/x");
  const auto send = [&](double age) {
    auto wire = wire_of(RobotCommand{});
    wire.header.boot = net.domain.boot() ^ (1ULL << 40U);
    wire.header.stamp_ns = clock::monotonic_ns() - clock.epoch - static_cast<std::int64_t>(age * 1e9);
    elsewhere.write(wire);
  };
  send(1000);
  EXPECT_FALSE(reader.take_fresh(command, header, 500)) << "the age of another machine's message is known";
  send(0);
  EXPECT_TRUE(reader.take_fresh(command, header, 500));
}

TEST(Reader, TakeFreshIgnoresTheAgeUnderSimulatedTime) {
  Link link(true);
  link.send(1);
  link.clock.next_delta();
  EXPECT_TRUE(link.reader.take_fresh(link.message, link.header, 1e-9));
}

TEST(Reader, ReceivesMessagesDuringItsConstruction) {
  // the listener is set at creation: a later one would miss earlier messages
  TestDomain net;
  TestClock clock;
  Writer<TaskCommand> writer(net.domain, clock, "t/x");
  std::atomic<bool> done = false;
  std::atomic<std::uint64_t> sent = 0;
  std::thread sender([&] {
    while (!done) writer.write({}, ++sent);
  });
  for (int i = 0; i < 20; ++i) {
    Reader<TaskCommand> reader(net.domain, clock, "t/x");
    TaskCommand command;
    Header header;
    EXPECT_TRUE(eventually([&] { return reader.take(command, header); }));
  }
  done = true;
  sender.join();
}

TEST(Reader, ReportsWhetherItsWriterIsAlive) {
  TestDomain net;
  TestClock clock;
  Reader<TaskCommand> reader(net.domain, clock, "t/x");
  EXPECT_FALSE(reader.peer_alive());
  {
    Writer<TaskCommand> writer(net.domain, clock, "t/x");
    EXPECT_TRUE(eventually([&] { return reader.peer_alive(); }));
  }
  EXPECT_TRUE(eventually([&] { return !reader.peer_alive(); }));
  EXPECT_GE(clock.notified.load(), 2);
}

TEST(Reader, HasNoLatencyBudget) {
  Link link;
  for (const dds_entity_t entity : {link.writer.entity(), link.reader.entity()}) {
    Qos qos{dds_create_qos()};
    ASSERT_EQ(dds_get_qos(entity, qos.get()), DDS_RETCODE_OK);
    dds_duration_t budget = -1;
    ASSERT_TRUE(dds_qget_latency_budget(qos.get(), &budget));
    EXPECT_EQ(budget, 0);
    dds_reliability_kind_t reliability{};
    dds_duration_t blocking = 0;
    ASSERT_TRUE(dds_qget_reliability(qos.get(), &reliability, &blocking));
    EXPECT_EQ(reliability, DDS_RELIABILITY_RELIABLE);
  }
}

TEST(Reader, ReportsAPeerWithAnotherMessageType) {
  TestDomain net;
  TestClock clock;
  Reader<RobotCommand> reader(net.domain, clock, "t/x");
  EXPECT_EQ(reader.problem(), "");
  // a separate participant: one participant refuses two types with one name
  const Entity other{dds_create_participant(static_cast<dds_domainid_t>(net.domain.id()), nullptr, nullptr),
                     "participant", ""};
  const Entity topic{dds_create_topic(other.get(), &WireOf<RobotState>::descriptor(), "t/x", nullptr, nullptr), "topic",
                     ""};
  const Entity writer{dds_create_writer(other.get(), topic.get(), link_writer_qos(net.domain).get(), nullptr), "writer",
                      ""};
  ASSERT_TRUE(eventually([&] { return !reader.problem().empty(); }));
  EXPECT_EQ(reader.problem(),
            "topic t/x: a peer has another message type (DDS policy 24): it was built from other sources");
  EXPECT_FALSE(reader.peer_alive());
}

TEST(Reader, RefusesAnInvalidTopicName) {
  TestDomain net;
  TestClock clock;
  EXPECT_THROW(Reader<TaskCommand>(net.domain, clock, "a b"), SystemError);
  EXPECT_THROW(Writer<TaskCommand>(net.domain, clock, "3a"), SystemError);
}

}  // namespace
}  // namespace mrroc::links
