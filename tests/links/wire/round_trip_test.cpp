// Every message passes through DDS unchanged, with any content; values out of range never arrive.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <limits>

#include "links/telemetry/status_collector.hpp"
#include "links/telemetry/status_publisher.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "links/transport/raw_writer.hpp"
#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/random_messages.hpp"
#include "links/wire/same_messages.hpp"

namespace mrroc::links {
namespace {

template <class T>
class RoundTrip : public ::testing::Test {};
using Messages = ::testing::Types<RobotCommand, RobotState, SensorRequest, SensorReading, TaskCommand, TaskStatus,
                                  OperatorQuestion, OperatorAnswer, TrajectoryPart, TrajectoryReport>;
TYPED_TEST_SUITE(RoundTrip, Messages);

TYPED_TEST(RoundTrip, KeepsEveryBit) {
  TestDomain net;
  TestClock clock;
  Writer<TypeParam> writer(net.domain, clock, "t/x");
  Reader<TypeParam> reader(net.domain, clock, "t/x");
  std::uint64_t sequence = 0;
  // one process delivers to itself within dds_write
  EXPECT_TRUE(rc::check([&](const TypeParam& message) {
    writer.write(message, ++sequence, 77);
    TypeParam received;
    Header header;
    RC_ASSERT(reader.take(received, header));
    RC_ASSERT(same(received, message));
    RC_ASSERT(header.sequence == sequence);
    RC_ASSERT(header.boot == net.domain.boot());
    RC_ASSERT(header.answers == 77U);
    RC_ASSERT(header.stamp_ns > 0);
  }));
}

TEST(RoundTripOfStatus, KeepsEveryBit) {
  TestDomain net;
  StatusPublisher publisher(net.domain, "t");
  StatusCollector collector(net.domain, "t");
  EXPECT_TRUE(rc::check([&](const ProcessStatus& status) {
    publisher.publish(status);
    collector.poll();
    const auto& process = collector.processes().at(std::string(status.process.view()));
    RC_ASSERT(same(process.status, status));
    RC_ASSERT(process.alive);
  }));
}

TEST(RoundTrip, NonFiniteNumbersArriveAndAreAnswered) {
  TestDomain net;
  TestClock clock;
  Writer<RobotCommand> writer(net.domain, clock, "t/x");
  Reader<RobotCommand> reader(net.domain, clock, "t/x");
  RobotCommand command;
  command.joints = JointVector::Constant(6, std::numeric_limits<double>::quiet_NaN());
  writer.write(command, 1);
  Header header;
  ASSERT_TRUE(reader.take(command, header));
  EXPECT_TRUE(command.joints.array().isNaN().all());
}

template <class T>
struct Damage {
  const char* name;
  std::function<void(Wire<T>&)> apply;
};

/// Each damage alone gives a message that is dropped and counted, and does not change the reader's output. It is no
/// longer in flight, so that simulated time continues.
template <class T>
void expect_dropped(const std::vector<Damage<T>>& damages) {
  TestDomain net;
  TestClock clock;
  RawWriter<T> writer(net.domain, "t/x");
  Reader<T> reader(net.domain, clock, "t/x");
  std::uint64_t malformed = 0;
  for (const Damage<T>& damage : damages) {
    Wire<T> wire = wire_of(T{});
    wire.header.number = 2;
    damage.apply(wire);
    clock.sent(0);
    writer.write(wire);
    T message;
    Header header;
    EXPECT_FALSE(reader.take(message, header)) << damage.name;
    EXPECT_TRUE(same(message, T{})) << damage.name;
    EXPECT_EQ(header.sequence, 0U) << damage.name;
    EXPECT_EQ(reader.counters().malformed, ++malformed) << damage.name;
    EXPECT_EQ(clock.in_flight.load(), 0) << damage.name;
  }
  writer.write(wire_of(T{}));
  T message;
  Header header;
  EXPECT_TRUE(reader.take(message, header)) << "an undamaged message must still arrive";
}

template <std::size_t Size>
void fill(char (&text)[Size]) {
  std::fill_n(text, Size, 'x');
}

TEST(Malformed, RobotCommand) {
  expect_dropped<RobotCommand>({{"kind", [](auto& w) { w.command_kind = 17; }},
                                {"with_outputs", [](auto& w) { w.with_outputs = 2; }},
                                {"force.behaviour", [](auto& w) { w.force.behaviour[5] = 3; }},
                                {"relative", [](auto& w) { w.relative = 2; }},
                                {"joints", [](auto& w) { w.joints.count = 9; }},
                                {"joint_velocity", [](auto& w) { w.joint_velocity.count = 0xffffffff; }},
                                {"joint_acceleration", [](auto& w) { w.joint_acceleration.count = 9; }}});
}

TEST(Malformed, RobotState) {
  expect_dropped<RobotState>({{"synchronised", [](auto& w) { w.synchronised = 2; }},
                              {"enabled", [](auto& w) { w.enabled = 255; }},
                              {"error class", [](auto& w) { w.error.error_class = 4; }},
                              {"error code", [](auto& w) { w.error.code = 50; }},
                              {"error detail", [](auto& w) { fill(w.error.detail); }},
                              {"joints", [](auto& w) { w.joints.count = 9; }},
                              {"joint_velocity", [](auto& w) { w.joint_velocity.count = 9; }},
                              {"motors", [](auto& w) { w.motors.count = 9; }},
                              {"current", [](auto& w) { w.current.count = 9; }},
                              {"desired_joints", [](auto& w) { w.desired_joints.count = 9; }},
                              {"desired_velocity", [](auto& w) { w.desired_velocity.count = 9; }},
                              {"desired_acceleration", [](auto& w) { w.desired_acceleration.count = 9; }}});
}

TEST(Malformed, Sensor) {
  expect_dropped<SensorRequest>({{"kind", [](auto& w) { w.request_kind = 3; }}});
  expect_dropped<SensorReading>({{"channel_count", [](auto& w) { w.channel_count = 17; }},
                                 {"error code", [](auto& w) { w.error.code = 9999; }},
                                 {"error detail", [](auto& w) { fill(w.error.detail); }}});
}

TEST(Malformed, Task) {
  expect_dropped<TaskCommand>({{"kind", [](auto& w) { w.command_kind = 8; }},
                               {"label", [](auto& w) { fill(w.parcel.label); }},
                               {"size", [](auto& w) { w.parcel.size = 513; }}});
  expect_dropped<TaskStatus>({{"state", [](auto& w) { w.state = 6; }},
                              {"error class", [](auto& w) { w.error.error_class = 9; }},
                              {"process", [](auto& w) { fill(w.process); }},
                              {"device", [](auto& w) { fill(w.device); }},
                              {"label", [](auto& w) { fill(w.parcel.label); }},
                              {"size", [](auto& w) { w.parcel.size = 513; }}});
}

TEST(Malformed, Operator) {
  expect_dropped<OperatorQuestion>({{"text", [](auto& w) { fill(w.text); }},
                                    {"kind", [](auto& w) { w.question_kind = 4; }},
                                    {"choice count", [](auto& w) { w.choice_count = 9; }},
                                    {"choices", [](auto& w) { fill(w.choices[7]); }}});
}

TEST(Malformed, Trajectories) {
  expect_dropped<TrajectoryPart>({{"robot", [](auto& w) { fill(w.robot); }},
                                  {"order", [](auto& w) { w.trajectory_order = 2; }},
                                  {"count", [](auto& w) { w.count = TrajectoryPart::kNumbers + 1; }}});
  expect_dropped<TrajectoryReport>({{"robot", [](auto& w) { fill(w.robot); }},
                                    {"state", [](auto& w) { w.trajectory_state = 9; }},
                                    {"text", [](auto& w) { fill(w.text); }}});
}

TEST(Malformed, ProcessStatus) {
  ProcessStatus message;
  message.pid = 7;
  const Wire<ProcessStatus> good = wire_of(message);
  EXPECT_TRUE(decode(good, message));
  const std::vector<Damage<ProcessStatus>> damages = {{"process", [](auto& w) { fill(w.process); }},
                                                      {"role", [](auto& w) { w.process_role = 5; }},
                                                      {"state", [](auto& w) { w.process_state = 5; }},
                                                      {"activity", [](auto& w) { fill(w.activity); }},
                                                      {"error", [](auto& w) { w.error.error_class = 4; }}};
  for (const auto& damage : damages) {
    Wire<ProcessStatus> wire = good;
    wire.pid = 8;
    damage.apply(wire);
    EXPECT_FALSE(decode(wire, message)) << damage.name;
    EXPECT_EQ(message.pid, 7) << damage.name;
  }
}

TEST(Malformed, AMessageOfUnknownKindIsNoMessage) {
  TestDomain net;
  TestClock clock;
  RawWriter<TaskCommand> writer(net.domain, "t/x");
  Reader<TaskCommand> reader(net.domain, clock, "t/x");
  auto wire = wire_of(TaskCommand{});
  wire.header.kind = 3;
  writer.write(wire);
  TaskCommand command;
  Header header;
  EXPECT_FALSE(reader.take(command, header));
  EXPECT_EQ(reader.counters().malformed, 1U);
  EXPECT_EQ(clock.in_flight.load(), 0);
}

}  // namespace
}  // namespace mrroc::links
