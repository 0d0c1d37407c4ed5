// The driver with an I/O node of python-canopen: its set-up, its values, its faults and its outputs as another
// participant of the bus reads them.
#include "canopen/sdo_client.hpp"
#include "clock/wall/monotonic.hpp"
#include "io_rig.hpp"
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

/// Node 40: 16 digital inputs and outputs, 2 analogue inputs and 1 analogue output.
config::IoTable peer_io() {
  config::IoTable io = io_table();
  io.nodes.pop_back();
  config::IoEntry& node = io.nodes[0];
  node.digital_inputs = node.digital_outputs = {0, 16};
  node.analog_inputs = {{0, 2}, 10};
  node.analog_outputs = {{0, 1}, 10};
  node.settings.push_back({{kOutputErrorValue, 2}, "0x6207:2", 0x50, 1});
  return io;
}

class PeerIoTest : public testing::Test {
 protected:
  PeerIoTest() {
    table.absolute_encoders = true;
    table.heartbeat = kHeartbeat;
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.opener(), kPeerTiming, true,
                                             peer_io());
    hardware->open();
  }
  void run(Tick ticks) {
    for (const Tick end = tick + ticks; tick < end; ++tick) {
      pause();
      hardware->read(tick, input);
      hardware->set_points(input.motors, JointVector::Zero(2));
      hardware->write(tick, JointVector::Zero(2));
    }
  }
  bool runs_until(const std::function<bool()>& condition, Tick most = 600) {
    for (const Tick end = tick + most; tick < end && !condition();) run(1);
    return condition();
  }
  /// As the second participant reads it.
  std::int64_t number(Object object) {
    can::Frame answer;  // to the driver
    while (second->receive(answer, 0)) {
    }
    const std::vector<std::uint8_t> value = client.upload(40, object);
    return can::sign_extended(can::get(value, 0, value.size()), value.size());
  }
  /// Without its sign.
  std::int64_t block(std::uint16_t index, std::uint8_t sub) { return number({index, sub}) & 0xff; }

  TwoSlides model;
  config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  TestBus bus;
  Peer peer{bus.name(), std::string("--io-eds " MRROC_SOURCE_DIR "/src/canopen/cia401.eds --io 40")};
  std::unique_ptr<CanHardware> hardware;
  std::unique_ptr<can::Bus> second = bus.open();
  SdoClient client{*second, clock::kSecond};
  HardwareInput input;
  Tick tick = 0;
};

TEST_F(PeerIoTest, NodeHasTheSettingsOfItsTable) {
  EXPECT_EQ(number(kConsumerHeartbeat), 127 << 16 | static_cast<int>(3000 * kHeartbeat));
  EXPECT_EQ(number(kProducerHeartbeat), 1000 * kHeartbeat);
  EXPECT_EQ(number({0x1a00, 0}), 2);
  EXPECT_EQ(number({0x1a00, 2}), 0x60000208);
  EXPECT_EQ(number({0x1a01, 2}), 0x64010210);
  EXPECT_EQ(number({0x1800, 2}), table.status_every);
  EXPECT_EQ(number({0x1602, 0}), 4) << "not used, as the node has it";
  EXPECT_EQ(block(kOutputErrorMode, 2), 0xff);
  EXPECT_EQ(block(kOutputErrorValue, 2), 0x50);
  EXPECT_EQ(number(kAnalogInterruptEnable) & 1, 1);
}

TEST_F(PeerIoTest, ValuesArriveInBothDirections) {
  ControllerIo outputs;
  outputs.digital = 0xa53c;
  outputs.analog[0] = -2.5;
  hardware->set_outputs(outputs);
  peer.say("node 40 input 1 0x0f");
  peer.say("node 40 input 2 0xc0");
  peer.say("node 40 analog 1 16384");
  peer.say("node 40 analog 2 -32767");
  EXPECT_TRUE(runs_until([this] { return input.inputs.digital == 0xc00f && input.inputs.analog[1] == -10; }));
  EXPECT_NEAR(input.inputs.analog[0], 5, 1e-3);
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault_detail).view();
  EXPECT_EQ(block(kWriteOutputs, 1), 0x3c);
  EXPECT_EQ(block(kWriteOutputs, 2), 0xa5);
  EXPECT_EQ(number({kWriteAnalogOutputs, 1}), -8192);
}

TEST_F(PeerIoTest, ErrorLastsUntilTheNodeReportsItsEnd) {
  peer.say("node 40 emcy 0x2310");
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::io_fault; }));
  EXPECT_NE(describe(input.fault_detail).view().find("node 40: error code 2310h"), std::string_view::npos);
  peer.say("node 40 emcy 0");
  run(50);
  hardware->reset_fault();
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::none; }));
}

TEST_F(PeerIoTest, RestartedNodeIsSetUpAgainAndGetsItsOutputs) {
  ControllerIo outputs;
  outputs.digital = 0x1234;
  hardware->set_outputs(outputs);
  run(20);
  peer.say("node 40 input 1 0x01");
  peer.say("node 40 reboot");
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::io_fault; }));
  EXPECT_EQ(input.inputs.digital, 0);
  EXPECT_EQ(block(kWriteOutputs, 1), 0);
  hardware->reset_fault();
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::none && !hardware->busy(); }));
  run(20);
  EXPECT_EQ(block(kWriteOutputs, 1), 0x34);
  EXPECT_EQ(block(kWriteOutputs, 2), 0x12);
}

TEST_F(PeerIoTest, SilentNodeIsAFaultAndIsRecovered) {
  peer.say("node 40 input 1 0x01");
  EXPECT_TRUE(runs_until([this] { return input.inputs.digital == 1; }));
  peer.say("node 40 silence");
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::io_fault; }));
  EXPECT_EQ(input.inputs.digital, 0);
  peer.say("node 40 speak");
  run(50);
  hardware->reset_fault();
  EXPECT_TRUE(runs_until([this] { return input.fault == ErrorCode::none && input.inputs.digital == 1; }));
}

TEST_F(PeerIoTest, OutputsTakeTheirErrorValuesWhenTheDriverEnds) {
  ControllerIo outputs;
  outputs.digital = 0xffff;
  hardware->set_outputs(outputs);
  run(20);
  EXPECT_EQ(block(kWriteOutputs, 2), 0xff);
  hardware.reset();
  can::Frame frame;
  while (frame != nmt_frame(NmtCommand::stop, 40))
    ASSERT_TRUE(second->receive(frame, clock::monotonic_ns() + clock::kSecond));
  second->send(nmt_frame(NmtCommand::enter_pre_operational, 40));  // a stopped node answers no SDO
  EXPECT_EQ(block(kWriteOutputs, 1), 0);
  EXPECT_EQ(block(kWriteOutputs, 2), 0x50);
}

}  // namespace
}  // namespace mrroc::edp
