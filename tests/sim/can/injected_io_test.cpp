#include "sim/can/injected_io.hpp"

#include <gtest/gtest.h>

#include "canopen/emergency.hpp"
#include "clock/host.hpp"
#include "clock/participant.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::sim::injected_io_test {
namespace {

/// Nodes 40 and 41 with 4 inputs each, and 41 with 2 analogue inputs.
config::IoTable two_nodes() {
  config::IoTable table;
  table.nodes.resize(2);
  table.nodes[0].node = 40;
  table.nodes[1].node = 41;
  table.nodes[0].digital_inputs = {0, 4};
  table.nodes[1].digital_inputs = {4, 4};
  table.nodes[1].digital_outputs = {0, 4};
  table.nodes[1].analog_inputs = {{0, 2}, 10};
  for (config::IoEntry& node : table.nodes)
    node.eds = canopen::EdsFile::load(MRROC_SOURCE_DIR "/src/canopen/cia401.eds");
  return table;
}

/// The faults of a run at tick 5, and the nodes that they affect.
struct Rig {
  explicit Rig(const std::vector<std::string>& texts) : plan(texts) {
    options.participants = {"arm_drives"};
    host = std::make_unique<clock::ClockHost>(options);
    clock = clock::attach_clock(host->fd(), "arm_drives");
    for (const config::IoEntry& entry : table.nodes)
      nodes.emplace_back(entry, [this](const can::Frame& frame) { sent.push_back(frame); });
    for (IoNode& node : nodes) node.boot(0);
    sent.clear();
    for (std::size_t i = 0; i < texts.size(); ++i) host->set_off_fault(i, 5);
    faults = std::make_unique<InjectedIo>(plan.of("arm_drives", *clock), table);
  }
  /// The inputs that the nodes measure at `tick`, when all wires are off.
  ControllerIo inputs(Tick tick) {
    ControllerIo inputs;
    faults->apply(tick, 0, nodes, inputs);
    return inputs;
  }
  /// Whether the second node answers a request at `tick`.
  bool answers(Tick tick) {
    inputs(tick);
    sent.clear();
    nodes[1].take(can::Frame{canopen::kSdoRequest + 41, {0x40, 0, 0x10, 0, 0, 0, 0, 0}}, 0);
    return !sent.empty();
  }

  faults::FaultPlan plan;
  clock::HostOptions options;
  std::unique_ptr<clock::ClockHost> host;
  std::unique_ptr<clock::Clock> clock;
  config::IoTable table = two_nodes();
  std::vector<can::Frame> sent;
  std::vector<IoNode> nodes;
  std::unique_ptr<InjectedIo> faults;
};

TEST(InjectedIo, AnInputHasItsValueWhileItSticks) {
  Rig rig({"stick io:arm input 6 to 1 at tick 5 for 3 ticks", "stick io:arm analog 1 to -2.5 at tick 5 for 3 ticks"});
  EXPECT_EQ(rig.inputs(4), ControllerIo{});
  for (const Tick tick : {5, 6, 7}) {
    EXPECT_EQ(rig.inputs(tick).digital, 1U << 6) << tick;
    EXPECT_EQ(rig.inputs(tick).analog[1], -2.5) << tick;
  }
  EXPECT_EQ(rig.inputs(8), ControllerIo{});
}

TEST(InjectedIo, AnInputSticksAtOff) {
  Rig rig({"stick io:arm input 6 to 0 at tick 5"});
  ControllerIo inputs;
  inputs.digital = 0xff;
  rig.faults->apply(5, 0, rig.nodes, inputs);
  EXPECT_EQ(inputs.digital, 0xff & ~(1U << 6));
}

TEST(InjectedIo, ASilentNodeAnswersNoRequest) {
  Rig rig({"silence io:arm node 41 at tick 5 for 2 ticks"});
  EXPECT_TRUE(rig.answers(4));
  EXPECT_FALSE(rig.answers(5));
  EXPECT_FALSE(rig.answers(6));
  EXPECT_TRUE(rig.answers(7));
}

TEST(InjectedIo, ANodeBootsOnceAndItsOutputsFall) {
  Rig rig({"restart io:arm node 41 at tick 5"});
  rig.nodes[1].take(can::Frame{canopen::kSdoRequest + 41, {0x2f, 0x00, 0x62, 1, 0b0101, 0, 0, 0}}, 0);
  ControllerIo outputs;
  rig.nodes[1].drive(outputs);
  EXPECT_EQ(outputs.digital, 0b0101);
  rig.sent.clear();
  for (Tick tick = 4; tick < 20; ++tick) rig.inputs(tick);
  ASSERT_EQ(rig.sent.size(), 1U);
  EXPECT_EQ(rig.sent[0].id, canopen::kHeartbeat + 41);
  EXPECT_EQ(rig.sent[0].data[0], 0) << "boot-up";
  rig.nodes[1].drive(outputs);
  EXPECT_EQ(outputs.digital, 0);
}

TEST(InjectedIo, ANodeReportsItsErrorAndTheEnd) {
  Rig rig({"fault io:arm node 40 at tick 5 for 2 ticks"});
  for (Tick tick = 4; tick < 20; ++tick) rig.inputs(tick);
  ASSERT_EQ(rig.sent.size(), 2U);
  EXPECT_EQ(canopen::emergency_of(rig.sent[0])->code, 0x5000);
  EXPECT_EQ(canopen::emergency_of(rig.sent[1])->code, 0);
}

TEST(InjectedIo, ANodeSendsNoHeartbeat) {
  Rig rig({"hush io:arm node 40 at tick 5 for 2 ticks"});
  constexpr std::int64_t kMs = 1'000'000;
  // 1017h = 10 ms
  rig.nodes[0].take(can::Frame{canopen::kSdoRequest + 40, {0x2b, 0x17, 0x10, 0, 10, 0, 0, 0}}, 0);
  const auto heartbeats = [&rig](Tick tick, std::int64_t now) {
    rig.inputs(tick);
    rig.sent.clear();
    rig.nodes[0].update(now);
    return rig.sent.size();
  };
  EXPECT_EQ(heartbeats(4, 20 * kMs), 1U);
  EXPECT_EQ(heartbeats(5, 40 * kMs), 0U);
  EXPECT_EQ(heartbeats(7, 60 * kMs), 1U);
}

TEST(InjectedIo, IgnoresTheFaultsOfDrives) {
  Rig rig({"silence drives:arm axis 2 at tick 5"});
  EXPECT_TRUE(rig.answers(6));
}

/// A node or an input that the robot does not have, and the end of its error.
using Unknown = std::pair<const char*, const char*>;
class UnknownPart : public testing::TestWithParam<Unknown> {};

TEST_P(UnknownPart, IsRefusedWithTheOnesThatExist) {
  try {
    Rig rig({GetParam().first});
    FAIL() << GetParam().first;
  } catch (const NonFatalError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(GetParam().first), std::string::npos) << text;
    EXPECT_NE(text.find(GetParam().second), std::string::npos) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(
    InjectedIo, UnknownPart,
    testing::Values(Unknown{"silence io:arm node 42 at tick 1", "no I/O node 42, expected one of 40, 41"},
                    Unknown{"stick io:arm input 8 to 1 at tick 1", "no digital input 8, expected 0 to 7"},
                    Unknown{"stick io:arm analog 2 to 1 at tick 1", "no analogue input 2, expected 0 to 1"}));

}  // namespace
}  // namespace mrroc::sim::injected_io_test
