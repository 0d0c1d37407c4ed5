// The driver against drives of python-canopen that search for their positions.
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

/// Drives that count from their position at power-on, and home by `method` of CiA 402. They were turned by 5 rad
/// before; the home switch of the Python drives is at their start.
class PeerHoming : public testing::TestWithParam<int> {
 protected:
  PeerHoming() {
    table.heartbeat = kHeartbeat;
    for (config::DriveEntry& drive : table.drives) drive.homing.method = static_cast<std::int8_t>(GetParam());
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.opener(), kPeerTiming, false);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kPeerPeriod, hand_over);
    effector.enable(true);
    while (!servo->snapshot().enabled() && now < 500) tick();
  }
  void tick() {
    pause();
    servo->tick(now++);
    while (effector.poll(reply)) {
    }
    if (!servo->snapshot().synchronised) least = std::min(least, servo->snapshot().motors.maxCoeff());
  }

  TwoSlides model;
  config::DriveTable table = table_for(model.parameters(), canopen::DriveMode::cyclic_position);
  TestBus bus;
  Peer peer{bus.name()};
  std::unique_ptr<CanHardware> hardware;
  ServoChannel hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kPeerPeriod, hand_over};
  Reply reply;
  Tick now = 0;
  double least = 1e9;  ///< rad, of the shaft with the larger distance
};

TEST_P(PeerHoming, FindsItsPositions) {
  ASSERT_TRUE(servo->snapshot().enabled());
  const double begin = servo->snapshot().motors.maxCoeff();
  RobotCommand turn;
  turn.kind = CommandKind::motor;
  turn.relative = true;
  turn.joints = JointVector::Constant(2, 5);
  turn.motion_steps = 200;
  ASSERT_FALSE(effector.accept(turn, 1, reply)) << reply.state.error.detail.view();
  for (int i = 0; i < 250; ++i) tick();
  EXPECT_NEAR(servo->snapshot().motors.maxCoeff() - begin, 5, 0.1);
  least = 1e9;

  RobotCommand synchronise;
  synchronise.kind = CommandKind::synchronise;
  ASSERT_FALSE(effector.accept(synchronise, 2, reply)) << reply.state.error.detail.view();
  for (int i = 0; i < 1500 && !servo->snapshot().synchronised; ++i) tick();
  ASSERT_TRUE(servo->snapshot().synchronised) << make_report(servo->snapshot().fault, model.parameters()).detail.view();
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(servo->snapshot().motors[i], 12.5, 0.1) << i;
  const bool to_the_switch = GetParam() != 37;
  EXPECT_EQ(least < begin + 1, to_the_switch) << "method 37 uses the present position; least" << least - begin;
}

INSTANTIATE_TEST_SUITE_P(Can, PeerHoming, testing::Values(3, 37),
                         [](const auto& each) { return "Method" + std::to_string(each.param); });

}  // namespace
}  // namespace mrroc::edp
