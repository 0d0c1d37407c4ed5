#include "drivers/socketcan/io_node.hpp"

#include <gtest/gtest.h>

#include "canopen/emergency.hpp"
#include "drivers/socketcan/io_setup.hpp"
#include "io_rig.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

/// A node whose frames the test sends; inputs at every second SYNC, at most 2 missed; heartbeats of 10 ticks.
class IoNodeTest : public testing::Test {
 protected:
  IoNodeTest() { node.begin(0); }

  static config::DriveTable drives() {
    config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
    table.status_every = 2;
    return table;
  }
  static config::IoEntry entry() {
    config::IoEntry entry = io_table().nodes[0];
    entry.analog_inputs.count = entry.analog_outputs.count = 0;
    return entry;
  }
  can::Frame take(const can::Frame& frame) {
    can::Frame next;
    EXPECT_TRUE(node.take(frame, tick, next));
    return next;
  }
  /// A cycle with this TPDO, and a heartbeat.
  void cycle(const std::optional<can::Frame>& inputs, NmtState state = NmtState::operational) {
    node.expect();
    ++tick;
    if (inputs) take(*inputs);
    take(heartbeat_frame(40, state));
  }
  void cycles(int count, const std::optional<can::Frame>& inputs) {
    for (int i = 0; i < count; ++i) cycle(inputs);
  }
  ControllerIo inputs() const {
    ControllerIo values;
    node.read(tick, values);
    return values;
  }
  std::string text() const { return std::string(describe(40, node.fault(tick)).view()); }
  /// Answers every request of the set-up.
  void answer_set_up(can::Frame request) {
    for (int i = 0; i < 100 && request.id == 0x628; ++i)
      request = take({0x5a8, {0x60, request.data[1], request.data[2], request.data[3], 0, 0, 0, 0}});
    EXPECT_EQ(request, nmt_frame(NmtCommand::start, 40));
  }

  const can::Frame both{0x1a8, {0x81, 0x02}};
  IoNode node{entry(), drives(), kCanPeriod};
  Tick tick = 0;
};

TEST_F(IoNodeTest, InputsAreThoseOfItsLastFrame) {
  EXPECT_FALSE(node.knows_inputs());
  cycle(both);
  EXPECT_TRUE(node.knows_inputs());
  EXPECT_EQ(inputs().digital, 0x281);
  cycle(std::nullopt);
  EXPECT_EQ(inputs().digital, 0x281);
  cycle(can::Frame{0x1a8, {0x01, 0x00}});
  EXPECT_EQ(inputs().digital, 0x001);
  EXPECT_EQ(text(), "");
}

TEST_F(IoNodeTest, SilentNodeIsAFaultAndItsInputsAreOff) {
  cycle(both);
  cycles(6, std::nullopt);
  EXPECT_EQ(text(), "");
  EXPECT_EQ(inputs().digital, 0x281);
  cycle(std::nullopt);
  EXPECT_EQ(text(), "node 40: no TPDO 1, inputs, after more than 6 SYNCs in a row");
  EXPECT_EQ(inputs().digital, 0);
  can::Frame next;
  node.reset(tick, next);
  EXPECT_EQ(next.id, 0x628u) << "it is set up again";
  EXPECT_TRUE(node.busy(tick));
  answer_set_up(next);
  cycle(both);
  EXPECT_FALSE(node.busy(tick));
  EXPECT_EQ(text(), "");
  EXPECT_EQ(inputs().digital, 0x281);
}

TEST_F(IoNodeTest, ShortFramesAreSilence) {
  cycle(both);
  cycles(7, can::Frame{0x1a8, {0xff}});
  EXPECT_TRUE(std::holds_alternative<IoSilent>(node.fault(tick)));
  EXPECT_EQ(inputs().digital, 0);
}

TEST_F(IoNodeTest, RestartedNodeIsAFaultUntilItIsSetUp) {
  cycle(both);
  cycle(both, NmtState::boot_up);
  EXPECT_EQ(text(), "node 40 has restarted, or is not operational");
  EXPECT_EQ(inputs().digital, 0);
  can::Frame next;
  node.reset(tick, next);
  answer_set_up(next);
  cycle(both);
  EXPECT_EQ(text(), "");
}

TEST_F(IoNodeTest, NodeThatAnotherMasterStopsIsAFault) {
  cycles(40, both);
  cycle(both, NmtState::pre_operational);
  EXPECT_TRUE(std::holds_alternative<IoRestarted>(node.fault(tick)));
}

TEST_F(IoNodeTest, HeartbeatFromBeforeTheStartIsStale) {
  cycle(both, NmtState::pre_operational);
  EXPECT_EQ(text(), "");
}

TEST_F(IoNodeTest, RefusedSettingIsAFaultWithItsReason) {
  cycle(both, NmtState::boot_up);
  can::Frame next;
  node.reset(tick, next);
  take({0x5a8, {0x80, next.data[1], next.data[2], next.data[3], 0x22, 0, 0, 0x08}});
  EXPECT_TRUE(text().starts_with("node 40 refuses to be set up: object 1400h:1, ")) << text();
}

TEST_F(IoNodeTest, LostRequestIsRepeated) {
  cycle(both, NmtState::boot_up);
  can::Frame first, next;
  node.reset(tick, first);
  EXPECT_FALSE(node.repeats(tick + 50, next));
  EXPECT_TRUE(node.repeats(tick + 51, next));
  EXPECT_EQ(next, first);
}

TEST_F(IoNodeTest, NodeThatBootsDuringItsSetUpIsSetUpFromTheBeginning) {
  cycle(both, NmtState::boot_up);
  can::Frame first;
  node.reset(tick, first);
  take({0x5a8, {0x60, first.data[1], first.data[2], first.data[3], 0, 0, 0, 0}});
  EXPECT_EQ(take(heartbeat_frame(40, NmtState::boot_up)), first);
}

TEST_F(IoNodeTest, MissingHeartbeatIsAFault) {
  cycle(both);
  for (int i = 0; i < 31; ++i) {
    node.expect();
    ++tick;
    take(both);
  }
  EXPECT_EQ(text(), "node 40: the last heartbeat is 31 ticks old, limit 30");
  EXPECT_EQ(inputs().digital, 0);
}

TEST_F(IoNodeTest, ErrorLastsUntilTheNodeReportsItsEnd) {
  cycle(both);
  take(to_frame({40, 0x2310, 1, {}}));
  EXPECT_TRUE(text().starts_with("node 40: error code 2310h, ")) << text();
  EXPECT_EQ(inputs().digital, 0x281) << "its frames still arrive";
  can::Frame next;
  node.reset(tick, next);
  EXPECT_EQ(next.size, 0);
  EXPECT_TRUE(std::holds_alternative<IoError>(node.fault(tick)));
  take(to_frame({40, 0, 0, {}}));
  EXPECT_TRUE(std::holds_alternative<IoError>(node.fault(tick))) << "it has been";
  node.reset(tick, next);
  EXPECT_EQ(text(), "");
}

TEST_F(IoNodeTest, OutputsAreSentWhenTheyChangeAndWithEveryHeartbeat) {
  ControllerIo outputs;
  int sent = 0;
  for (int i = 0; i < 30; ++i, ++tick)
    if (node.command(1, outputs, tick).size != 0) ++sent;
  EXPECT_EQ(sent, 3) << "a heartbeat is 10 ticks";
  outputs.set(11, true);
  EXPECT_EQ(node.command(1, outputs, tick), (can::Frame{0x228, {0, 0x08}}));
  EXPECT_EQ(node.command(1, outputs, tick).size, 0);
  EXPECT_EQ(node.command(2, outputs, tick).size, 0) << "no analogue outputs";
  cycle(both, NmtState::boot_up);
  outputs.set(0, true);
  EXPECT_EQ(node.command(1, outputs, tick).size, 0) << "out of service";
}

TEST_F(IoNodeTest, TakesOnlyItsOwnFrames) {
  can::Frame next;
  for (const std::uint32_t id : {0x000u, 0x080u, 0x1a9u, 0x2a8u, 0x3a8u, 0x228u, 0x729u, 0x5a9u})
    EXPECT_FALSE(node.take({id, {1, 2, 3, 4, 5, 6, 7, 8}}, tick, next)) << std::hex << id;
  can::Frame frame = both;
  frame.remote = true;
  EXPECT_FALSE(node.take(frame, tick, next));
  EXPECT_TRUE(node.is_command({0x228, {}}));
  EXPECT_FALSE(node.is_command({0x328, {}})) << "not used";
}

std::int64_t last_value(const std::vector<config::NodeSetting>& all, Object object) {
  std::int64_t value = -1;
  for (const config::NodeSetting& setting : all)
    if (setting.object == object) value = setting.value;
  return value;
}

TEST(IoSettings, AreThoseOfTheTables) {
  config::DriveTable drives = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  config::IoEntry entry = io_table().nodes[0];
  const auto all = io_settings(entry, drives);
  EXPECT_EQ(last_value(all, {0x1400, 1}), 0x228);
  EXPECT_EQ(last_value(all, {0x1400, 2}), 255) << "outputs are taken when they come";
  EXPECT_EQ(last_value(all, {0x1600, 2}), 0x62000208);
  EXPECT_EQ(last_value(all, {0x1800, 2}), 4) << "status_every";
  EXPECT_EQ(last_value(all, {0x1802, 1}), 0x400003a8) << "the fifth analogue input";
  EXPECT_EQ(last_value(all, {0x1402, 1}), -1) << "two analogue outputs";
  EXPECT_EQ(last_value(all, kConsumerHeartbeat), 127 << 16 | 60);
  EXPECT_EQ(last_value(all, {0x6206, 2}), 0xff);
  EXPECT_EQ(last_value(all, {0x6207, 2}), 0);
  EXPECT_EQ(last_value(all, {0x6443, 2}), 1);
  EXPECT_EQ(last_value(all, {0x6423, 0}), 1);
  entry.analog_inputs.count = 0;
  EXPECT_EQ(last_value(io_settings(entry, drives), {0x1801, 1}), 0xc00002a8) << "an unused PDO is switched off";
  entry.settings.push_back({{0x6207, 1}, "0x6207:1", 0x0f, 1});
  EXPECT_EQ(last_value(io_settings(entry, drives), {0x6207, 1}), 0x0f) << "the table's own";
}

}  // namespace
}  // namespace mrroc::edp
