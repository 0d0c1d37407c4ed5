#include "sim/can/drive_node.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "can/frame.hpp"
#include "canopen/emergency.hpp"

namespace mrroc::sim {
namespace {

using namespace canopen;

config::DriveTable one_drive() {
  config::DriveTable table;
  table.eds = EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  table.drives.push_back({});
  table.drives[0].node = 3;
  table.drives[0].units_per_turn = 4000;
  table.drives[0].rated_current = 10;
  return table;
}

class DriveNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    node.boot(1);
    sent.clear();
  }
  void nmt(NmtCommand command) { node.take(nmt_frame(command, 3), 1); }
  void write(Object object, std::uint32_t value, std::uint8_t size) {
    can::Frame request{0x603, {0, 0, 0, 0, 0, 0, 0, 0}};
    request.data[0] = static_cast<std::uint8_t>(0x23 | (4 - size) << 2);
    can::put(request.data, 1, 2, object.index);
    request.data[3] = object.sub;
    can::put(request.data, 4, 4, value);
    sent.clear();
    node.take(request, 1);
    ASSERT_FALSE(sent.empty());
    ASSERT_EQ(sent.front().data[0], 0x60) << "refused";
  }
  std::uint32_t read(Object object) {
    can::Frame request{0x603, {0x40, 0, 0, object.sub, 0, 0, 0, 0}};
    can::put(request.data, 1, 2, object.index);
    sent.clear();
    node.take(request, 1);
    return sent.empty() ? 0xffffffff : static_cast<std::uint32_t>(can::get(sent.front().bytes(), 4, 4));
  }
  void switch_on() {
    for (const std::uint16_t word : {kShutdown, kSwitchOn, kEnableOperation}) write(kControlword, word, 2);
    ASSERT_EQ(node.state(), DriveState::operation_enabled);
  }

  std::vector<can::Frame> sent;
  DriveNode node{
      one_drive(), one_drive().drives[0], {}, 0.002, [this](const can::Frame& frame) { sent.push_back(frame); }};
};

TEST_F(DriveNodeTest, CommunicationResetKeepsTheDriveState) {
  write(kProducerHeartbeat, 50, 2);
  write(kQuickStopOption, 6, 2);
  node.fail(0x7305);
  nmt(NmtCommand::reset_communication);
  EXPECT_EQ(node.state(), DriveState::fault);
  EXPECT_EQ(sent.back(), heartbeat_frame(3, NmtState::boot_up));
  EXPECT_EQ(read(kProducerHeartbeat), 0u);
  EXPECT_EQ(read(kQuickStopOption), 6u);
  EXPECT_EQ(read(kErrorCode), 0x7305u);
  EXPECT_EQ(read(kErrorRegister), 1u);
  EXPECT_EQ(drive_state(static_cast<std::uint16_t>(read(kStatusword))), DriveState::fault);
  write(kControlword, kFaultReset, 2);
  EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(read(kErrorCode), 0u);
}

TEST_F(DriveNodeTest, NodeResetEqualsPowerCycle) {
  write(kQuickStopOption, 6, 2);
  node.fail(0x7305);
  nmt(NmtCommand::reset_node);
  EXPECT_EQ(node.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(read(kQuickStopOption), 2u);
  EXPECT_EQ(read(kErrorCode), 0u);
}

TEST_F(DriveNodeTest, CommunicationResetUnderPowerFollowsObject6007h) {
  const std::pair<std::uint16_t, DriveState> reactions[] = {{0, DriveState::operation_enabled},
                                                            {1, DriveState::fault_reaction_active},
                                                            {2, DriveState::switch_on_disabled},
                                                            {3, DriveState::quick_stop_active}};
  for (const auto& [option, state] : reactions) {
    nmt(NmtCommand::reset_node);
    write(kAbortConnectionOption, option, 2);
    switch_on();
    nmt(NmtCommand::reset_communication);
    EXPECT_EQ(node.state(), state) << option;
  }
}

}  // namespace
}  // namespace mrroc::sim
