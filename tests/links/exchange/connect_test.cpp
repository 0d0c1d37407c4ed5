#include "links/exchange/connect.hpp"

#include <gtest/gtest.h>

#include "links/code_of.hpp"
#include "links/exchange/robot_requester.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/raw_writer.hpp"

namespace mrroc::links {
namespace {

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

TEST(Connect, AcceptsOnlyThePongOfItsOwnPing) {
  TestDomain net;
  TestClock clock;
  RobotRequester ecp(net.domain, clock, "t/arm", "arm_edp");
  Writer<RobotState> edp(net.domain, clock, "t/arm/state");
  edp.pong(net.domain.boot() + 1);
  EXPECT_THROW(ecp.connect(0.05), SystemError);
}

}  // namespace
}  // namespace mrroc::links
