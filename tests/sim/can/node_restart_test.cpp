// A simulated node that is switched on or restarted knows nothing of what was under way.
#include <gtest/gtest.h>

#include "canopen/identifiers.hpp"
#include "canopen/sdo.hpp"
#include "sim/can/io_node.hpp"

namespace mrroc::sim::node_restart_test {
namespace {

using namespace canopen;

constexpr NodeId kNode = 40;
const can::Frame kReadName{kSdoRequest + kNode, {0x40, 0x08, 0x10, 0, 0, 0, 0, 0}};  // 1008h, in segments
const can::Frame kNextSegment{kSdoRequest + kNode, {0x60, 0, 0, 0, 0, 0, 0, 0}};

class NodeRestart : public testing::Test {
 protected:
  NodeRestart() {
    config::IoEntry entry;
    entry.node = kNode;
    entry.eds = EdsFile::load(MRROC_SOURCE_DIR "/src/canopen/cia401.eds");
    node = std::make_unique<IoNode>(entry, [this](const can::Frame& frame) { answer = frame; });
    node->boot(0);
  }
  /// The answer's first byte.
  int ask(const can::Frame& request) {
    answer = {};
    node->take(request, 0);
    return answer.data[0];
  }

  std::unique_ptr<IoNode> node;
  can::Frame answer;
};

TEST_F(NodeRestart, ForgetsATransferInSegments) {
  ASSERT_EQ(ask(kReadName), 0x41);
  ASSERT_EQ(ask(kNextSegment) & 0xe0, 0) << "it is read in segments";
  for (const NmtCommand command : {NmtCommand::reset_node, NmtCommand::reset_communication}) {
    ASSERT_EQ(ask(kReadName), 0x41);
    node->take(nmt_frame(command, kNode), 0);
    EXPECT_EQ(ask(kNextSegment), 0x80);
  }
  ASSERT_EQ(ask(kReadName), 0x41);
  node->boot(0);
  EXPECT_EQ(ask(kNextSegment), 0x80);
}

TEST_F(NodeRestart, RestoresTheValuesOfTheManufacturer) {
  const can::Frame read{kSdoRequest + kNode, {0x40, 0x17, 0x10, 0, 0, 0, 0, 0}};  // 1017h, heartbeat
  const can::Frame write{kSdoRequest + kNode, {0x2b, 0x17, 0x10, 0, 0x64, 0, 0, 0}};
  for (const NmtCommand command : {NmtCommand::reset_node, NmtCommand::reset_communication}) {
    ask(read);
    const can::Frame before = answer;
    ASSERT_EQ(ask(write), 0x60);
    ask(read);
    ASSERT_NE(answer.data, before.data);
    node->take(nmt_frame(command, kNode), 0);
    ask(read);
    EXPECT_EQ(answer.data, before.data);
  }
}

}  // namespace
}  // namespace mrroc::sim::node_restart_test
