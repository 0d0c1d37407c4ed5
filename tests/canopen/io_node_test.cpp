#include "sim/can/io_node.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "canopen/emergency.hpp"

namespace mrroc::sim {
namespace {

using namespace canopen;

constexpr std::int64_t kMs = 1'000'000;

config::IoEntry io_entry() {
  config::IoEntry entry;
  entry.node = 9;
  entry.eds = EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia401.eds");
  entry.digital_inputs = {2, 12};
  entry.digital_outputs = {0, 16};
  entry.analog_inputs = {{1, 2}, 10};
  entry.analog_outputs = {{0, 8}, 10};
  return entry;
}

/// A node of CiA 401's default mapping, without its owner's settings.
class SimulatedIoNode : public testing::Test {
 protected:
  void SetUp() override {
    node.boot(kMs);
    ASSERT_EQ(sent.back(), heartbeat_frame(9, NmtState::boot_up));
  }
  void nmt(NmtCommand command) { node.take(nmt_frame(command, 9), kMs); }
  std::uint8_t write(Object object, std::uint32_t value, std::uint8_t size) {
    can::Frame request{0x609, {static_cast<std::uint8_t>(0x23 | (4 - size) << 2), 0, 0, object.sub, 0, 0, 0, 0}};
    can::put(request.data, 1, 2, object.index);
    can::put(request.data, 4, 4, value);
    sent.clear();
    node.take(request, kMs);
    return sent.empty() ? std::uint8_t{0} : sent.front().data[0];
  }
  std::uint16_t digital() const {
    ControllerIo outputs;
    node.drive(outputs);
    return outputs.digital;
  }

  std::vector<can::Frame> sent;
  IoNode node{io_entry(), [this](const can::Frame& frame) { sent.push_back(frame); }};
};

TEST_F(SimulatedIoNode, SendsItsInputsAtTheSyncsOfTheirType) {
  for (const std::uint16_t parameters : {std::uint16_t{0x1800}, std::uint16_t{0x1801}})
    ASSERT_EQ(write({parameters, 2}, 3, 1), 0x60);
  nmt(NmtCommand::start);
  ControllerIo inputs;
  inputs.digital = 0x2a04;
  inputs.analog[1] = -10;
  inputs.analog[2] = 5;
  node.measure(inputs);
  sent.clear();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(sent.empty());
    node.synchronise();
  }
  ASSERT_EQ(sent.size(), 2u) << "the third PDO is event-driven";
  EXPECT_EQ(sent[0], (can::Frame{0x189, {0x81, 0x0a}}));
  EXPECT_EQ(sent[1], (can::Frame{0x289, {0x01, 0x80, 0x00, 0x40, 0, 0, 0, 0}}));
}

TEST_F(SimulatedIoNode, TakesOutputsWhileItIsOperational) {
  node.take({0x209, {0xff, 0xff}}, kMs);
  EXPECT_EQ(digital(), 0);
  nmt(NmtCommand::start);
  node.take({0x209, {0x12, 0x34}}, kMs);
  EXPECT_EQ(digital(), 0x3412);
  node.take({0x209, {0xff}}, kMs);
  EXPECT_EQ(digital(), 0x3412) << "a short frame";
  node.take({0x409, {0, 0, 0, 0, 0, 0, 0xff, 0x7f}}, kMs);
  ControllerIo outputs;
  node.drive(outputs);
  EXPECT_DOUBLE_EQ(outputs.analog[7], 10);
}

TEST_F(SimulatedIoNode, StoppedNodeUsesItsErrorValues) {
  ASSERT_EQ(write({kOutputErrorMode, 1}, 0x0f, 1), 0x60);
  ASSERT_EQ(write({kOutputErrorValue, 1}, 0x05, 1), 0x60);
  ASSERT_EQ(write({kAnalogOutputErrorMode, 2}, 0, 1), 0x60);
  nmt(NmtCommand::start);
  node.take({0x209, {0xff, 0xff}}, kMs);
  node.take({0x309, {0x10, 0, 0x20, 0, 0, 0, 0, 0}}, kMs);
  nmt(NmtCommand::stop);
  EXPECT_EQ(digital(), 0x00f5) << "bits 4 to 7 keep their state, the second block has the default 0";
  ControllerIo outputs;
  node.drive(outputs);
  EXPECT_EQ(outputs.analog[0], 0);
  EXPECT_GT(outputs.analog[1], 0);
  EXPECT_EQ(write({kOutputErrorMode, 1}, 0, 1), 0) << "no SDO in stopped";
}

TEST_F(SimulatedIoNode, LostHeartbeatOfTheMasterIsAnErrorThatEndsWithIt) {
  ASSERT_EQ(write(kConsumerHeartbeat, 127u << 16 | 30, 4), 0x60);
  nmt(NmtCommand::start);
  node.take({0x209, {0xff, 0xff}}, kMs);
  node.update(100 * kMs);
  EXPECT_EQ(digital(), 0xffff) << "the master has sent none yet";
  node.take(heartbeat_frame(127, NmtState::operational), 100 * kMs);
  node.update(130 * kMs);
  EXPECT_EQ(digital(), 0xffff);
  sent.clear();
  node.update(131 * kMs);
  EXPECT_EQ(digital(), 0);
  EXPECT_FALSE(node.operational()) << "the default of 1029h";
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(emergency_of(sent[0])->code, 0x8130);
  node.take(heartbeat_frame(127, NmtState::operational), 140 * kMs);
  EXPECT_EQ(emergency_of(sent.back())->code, 0);
}

TEST_F(SimulatedIoNode, CommunicationResetKeepsTheProfile) {
  ASSERT_EQ(write({kOutputErrorValue, 1}, 0x05, 1), 0x60);
  ASSERT_EQ(write(kProducerHeartbeat, 20, 2), 0x60);
  nmt(NmtCommand::reset_communication);
  EXPECT_EQ(sent.back(), heartbeat_frame(9, NmtState::boot_up));
  nmt(NmtCommand::start);
  sent.clear();
  node.update(1000 * kMs);
  EXPECT_TRUE(sent.empty()) << "no heartbeat";
  nmt(NmtCommand::stop);
  EXPECT_EQ(digital(), 0x05);
  nmt(NmtCommand::reset_node);
  EXPECT_EQ(digital(), 0);
}

}  // namespace
}  // namespace mrroc::sim
