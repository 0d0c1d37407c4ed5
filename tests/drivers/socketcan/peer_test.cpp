// The driver against drives of python-canopen: motion in every mode, emergency, quick stop, silence, a second run.
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

TEST_P(PeerTest, MovesStopsOnAnEmergencyRecoversAndMovesAgain) {
  const JointVector begin = seen().joints;
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.2), 100))) << last.state.error.detail.view();
  run(160);
  EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
  EXPECT_NEAR(seen().joints[0] - begin[0], 0.2, 0.02);
  EXPECT_NEAR(seen().joints[1] - begin[1], 0.2, 0.02);

  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.2), 200)));
  run(60);
  peer.say("node 2 emcy 0x7305");
  for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
  EXPECT_EQ(seen().fault.code, ErrorCode::drive_fault) << describe(seen().fault.code);
  EXPECT_NE(text().find("axis 2 (y)"), std::string::npos) << text();
  EXPECT_NE(text().find("7305h, incremental sensor 1 fault"), std::string::npos) << text();
  run(50);
  const JointVector there = seen().joints;
  run(30);
  EXPECT_LT((seen().joints - there).cwiseAbs().maxCoeff(), 1e-3) << "it stands";

  EXPECT_TRUE(do_now(CommandKind::recover, 600)) << text() << " " << last.state.error.detail.view();
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, -0.1), 100))) << last.state.error.detail.view();
  run(160);
  EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
  EXPECT_NEAR(seen().joints[0] - there[0], -0.1, 0.02);
}

TEST_P(PeerTest, FailureOfOneDriveQuickStopsTheOther) {
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.4), 200)));
  run(60);
  const auto listener = bus.open();
  peer.say("node 2 emcy 0x7305");
  for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
  const double where = seen().joints[0];
  run(80);
  bool reported = false;
  std::vector<canopen::DriveState> states;
  can::Frame frame;
  while (listener->receive(frame, 0)) {
    const auto word = static_cast<std::uint16_t>(can::get(frame.bytes(), 0, 2));
    if (frame.id == 0x201 && word == canopen::kQuickStop) reported = true;
    if (frame.id != 0x181) continue;
    const canopen::DriveState state = canopen::drive_state(word);
    if (states.empty() || states.back() != state) states.push_back(state);
  }
  EXPECT_TRUE(reported) << "its controlword";
  using enum canopen::DriveState;
  EXPECT_EQ(states, (std::vector{operation_enabled, quick_stop_active, switch_on_disabled}));
  EXPECT_GT(seen().joints[0], where) << "on its own ramp";
  const JointVector there = seen().joints;
  run(30);
  EXPECT_LT((seen().joints - there).cwiseAbs().maxCoeff(), 1e-3) << "it stands";
}

TEST_P(PeerTest, SilentNodeIsLost) {
  peer.say("node 1 silence");
  for (int i = 0; i < 300 && seen().fault.code == ErrorCode::none; ++i) tick();
  EXPECT_TRUE(seen().fault.code == ErrorCode::hardware_silent || seen().fault.code == ErrorCode::heartbeat_lost)
      << describe(seen().fault.code);
  EXPECT_EQ(seen().fault.axis, 0);
}

TEST_P(PeerTest, SecondRunClearsTheFaultsAndContinues) {
  hardware.reset();
  // Python's drives run in real time: longer than their timeout for the master's heartbeat
  ::usleep(static_cast<useconds_t>(3.5 * kHeartbeat * 1e6));
  const auto second =
      std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.opener(), kPeerTiming, true);
  second->open();
  HardwareInput input;
  second->read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
}

INSTANTIATE_TEST_SUITE_P(Can, PeerTest, every_mode(), name_of_mode);

}  // namespace
}  // namespace mrroc::edp
