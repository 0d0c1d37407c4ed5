#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <thread>

#include "links/code_of.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/raw_writer.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::links {
namespace {

/// An ECP's and an EDP's end in one process: a message has arrived when its write returns.
struct RobotPair {
  explicit RobotPair(bool simulated = false, Tick timeout = 100000)
      : clock(simulated), ecp(net.domain, clock, "t/arm", "arm_edp", timeout), edp(net.domain, clock, "t/arm", 1000) {
    ecp.connect(kPatience);
  }
  /// The EDP answers its requests.
  void answer(double value) {
    ASSERT_TRUE(edp.take(command, sequence));
    RobotState answered;
    answered.joints = JointVector::Constant(6, value);
    EXPECT_TRUE(edp.reply(answered, sequence));
  }

  /// The first exchange, whose reply may take longer.
  void begin() {
    ecp.send({});
    clock.next_delta();
    answer(0);
    clock.next_delta();
    ecp.receive(state);
  }

  TestDomain net;
  TestClock clock;
  RobotRequester ecp;
  RobotResponder edp;
  RobotCommand command;
  std::uint64_t sequence = 0;
  RobotState state;
};

TEST(RobotLink, ExchangesCommandAndState) {
  RobotPair pair;
  EXPECT_FALSE(pair.edp.take(pair.command, pair.sequence)) << "pings are not commands";
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
      << "sent messages are counted, arrived ones are subtracted, pings are ignored";
}

/// A transparent ECP between an MP and an EDP.
TEST(RobotLink, ForwardsCommandAndStateAsTheyCame) {
  RobotPair pair;
  RobotRequester mp(pair.net.domain, pair.clock, "t/arm/mp", "arm", 100000);
  RobotResponder ecp(pair.net.domain, pair.clock, "t/arm/mp", 1000);
  mp.connect(kPatience);
  RobotCommand command, seen;
  RobotState state;
  std::uint64_t number = 0;
  command.kind = CommandKind::twist;
  command.twist << 1, -0.0, 3, std::numeric_limits<double>::quiet_NaN(), 5, 6;
  for (int i = 1; i <= 3; ++i) {
    mp.send(command);
    ASSERT_TRUE(ecp.take(seen, number));
    pair.ecp.forward(ecp, seen);
    pair.answer(i);
    EXPECT_EQ(pair.command.kind, CommandKind::twist);
    EXPECT_EQ(std::memcmp(pair.command.twist.data(), command.twist.data(), sizeof(Twist)), 0) << "bit by bit";
    pair.ecp.receive(pair.state);
    EXPECT_TRUE(ecp.forward(pair.ecp, number));
    mp.receive(state);
    EXPECT_EQ(state.joints[5], i);
  }
  mp.send(command);
  ASSERT_TRUE(ecp.take(seen, number));
  EXPECT_FALSE(ecp.forward(pair.ecp, number - 1)) << "a command that another one has overtaken has no answer";
  EXPECT_EQ(pair.clock.in_flight.load(), 0);
}

TEST(RobotLink, AgeOfACommandIsThatSinceItWasSent) {
  for (const bool simulated : {false, true}) {
    RobotPair pair(simulated);
    pair.ecp.send({});
    pair.clock.next_delta();
    ASSERT_TRUE(pair.edp.take(pair.command, pair.sequence));
    EXPECT_TRUE(pair.edp.fresh(1000));
    EXPECT_EQ(pair.edp.fresh(0), simulated) << "it has taken no simulated time";
  }
}

TEST(RobotLink, WaitsForTheReply) {
  for (const bool simulated : {false, true}) {
    RobotPair pair(simulated);
    std::thread edp([&] {
      pair.clock.next_delta();  // the thread represents a process that runs in a later delta
      EXPECT_TRUE(eventually([&] { return pair.edp.take(pair.command, pair.sequence); }));
      pair.edp.reply({}, pair.sequence);
    });
    pair.ecp.send({});
    pair.clock.next_delta();
    EXPECT_NO_THROW(pair.ecp.receive(pair.state));
    edp.join();
  }
}

/// The EDP answers only after `timeout`.
TEST(RobotLink, WaitsLongerForTheFirstReplyAndForWhatTakesLong) {
  RobotPair pair(false, 20);
  const auto late_reply = [&](RobotCommand command) {
    pair.ecp.send(command);
    std::thread edp([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      pair.answer(1);
    });
    const auto wait = [&] { pair.ecp.receive(pair.state); };
    const ErrorCode code = code_of(wait, "arm_edp");
    edp.join();
    if (code != ErrorCode::none) {
      EXPECT_NO_THROW(wait());  // it is there now
    }
    return code;
  };
  RobotCommand query, recover, synchronise, command;
  recover.kind = CommandKind::recover;
  synchronise.kind = CommandKind::synchronise;
  EXPECT_EQ(late_reply(query), ErrorCode::none) << "the first one: the drives are switched on";
  EXPECT_EQ(late_reply(query), ErrorCode::process_silent);
  EXPECT_EQ(late_reply(recover), ErrorCode::none);
  EXPECT_EQ(late_reply(synchronise), ErrorCode::none);
  command.kind = CommandKind::hold;
  EXPECT_EQ(late_reply(command), ErrorCode::process_silent);
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
  send_late(9, here, here);      // to a request that does not exist
  send_late(1, here + 1, here);  // from a peer other than the one of the handshake
  send_late(1, here, here + 1);  // to a process that had this sequence before its restart
  pair.answer(4.5);
  pair.ecp.receive(pair.state);
  EXPECT_EQ(pair.state.joints[0], 4.5);
  EXPECT_EQ(pair.ecp.stale_replies(), 3U);
}

TEST(RobotLink, DropsAMalformedReply) {
  RobotPair pair(false, 50);
  RawWriter<RobotState> writer(pair.net.domain, "t/arm/state");
  pair.begin();
  pair.ecp.send({});
  auto wire = wire_of(RobotState{});
  wire.header.number = 2;
  wire.header.boot = wire.header.answers = pair.net.domain.boot();
  wire.enabled = 2;
  writer.write(wire);
  EXPECT_THROW(pair.ecp.receive(pair.state), SystemError);
  EXPECT_EQ(pair.ecp.malformed_replies(), 1U);
}

TEST(RobotLink, OvertakenRequestIsNotAnswered) {
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
  pair.begin();
  pair.ecp.send({});
  EXPECT_EQ(code_of([&] { pair.ecp.receive(pair.state); }, "arm_edp has not answered on topic t/arm/state"),
            ErrorCode::process_silent);
}

TEST(RobotLink, ReplyIsDueAtTheTickOfTheCommand) {
  RobotPair pair(false, 0);
  pair.begin();
  RobotCommand command;
  command.kind = CommandKind::hold;
  command.start_tick = pair.clock.tick() + 20;
  command.reply_step = 5;
  pair.ecp.send(command);
  EXPECT_THROW(pair.ecp.receive(pair.state), SystemError);
  EXPECT_GE(pair.clock.tick(), command.start_tick + command.reply_step);
}

TEST(RobotLink, DeadlineAlsoAppliesInSimulatedTime) {
  RobotPair pair(true, 0);
  pair.begin();
  pair.ecp.send({});
  try {
    pair.ecp.receive(pair.state);
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::process_silent);
  }
}

TEST(RobotLink, InterruptedClockStopsTheWait) {
  RobotPair pair;
  pair.ecp.send({});
  pair.clock.interrupt();
  EXPECT_THROW(pair.ecp.receive(pair.state), Stopped);
}

}  // namespace
}  // namespace mrroc::links
