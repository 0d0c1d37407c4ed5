// The driver against drives of python-canopen whose axes reach a limit switch, or are jammed.
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

/// An axis that cannot continue, and its recovery.
class PeerObstacle : public PeerTest {
 protected:
  void move(double way) {
    ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, way), 200))) << last.state.error.detail.view();
  }
  void run_into(const std::string& obstacle) {
    move(0.4);
    run(60);
    EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
    peer.say(obstacle);
    for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
    for (int i = 0; i < 200 && servo->drives_on(); ++i) tick();
    EXPECT_FALSE(servo->drives_on());
    run(20);  // the end of the drives' own ramps
    stopped = seen().joints;
    run(30);
    EXPECT_LT((seen().joints - stopped).cwiseAbs().maxCoeff(), 1e-3) << "it stands";
  }
  void recover_and_move(double way) {
    ASSERT_TRUE(do_now(CommandKind::recover, 600)) << text() << " " << last.state.error.detail.view();
    move(way);
    run(260);
    EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(seen().joints[i] - stopped[i], way, 0.02) << i;
  }

  JointVector stopped;
};

TEST_P(PeerObstacle, LimitSwitchStopsTheRobotWhichMayMoveAwayFromIt) {
  run_into("node 2 limit positive on");
  EXPECT_EQ(seen().fault.code, ErrorCode::limit_switch) << describe(seen().fault.code);
  EXPECT_NE(text().find("axis 2 (y)"), std::string::npos) << text();
  EXPECT_NE(text().find("rad of the shaft"), std::string::npos) << text();
  recover_and_move(-0.1);
}

INSTANTIATE_TEST_SUITE_P(Can, PeerObstacle, every_mode(), name_of_mode);

/// A window (6065h) that is narrower than the servo's own, and a timeout (6066h) so long that it is not a fault.
class PeerWindow : public PeerObstacle {
 protected:
  PeerWindow() {
    settings = {{{0x6065}, "Following error window", 1000, 4}, {{0x6066}, "Following error time out", 60'000, 2}};
  }
};

TEST_P(PeerWindow, DriveReportsAJammedAxisAndItRecovers) {
  run_into("node 2 jam on");
  EXPECT_EQ(seen().fault.code, ErrorCode::following_error) << describe(seen().fault.code);
  EXPECT_NE(text().find("axis 2 (y)"), std::string::npos) << text();
  EXPECT_NE(text().find("reported by its drive"), std::string::npos) << text();
  peer.say("node 2 jam off");
  recover_and_move(-0.1);
}

INSTANTIATE_TEST_SUITE_P(Can, PeerWindow, testing::Values(canopen::DriveMode::cyclic_position), name_of_mode);

}  // namespace
}  // namespace mrroc::edp
