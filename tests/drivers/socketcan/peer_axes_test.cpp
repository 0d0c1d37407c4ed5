// The driver against one node of python-canopen with two axes.
#include "peer_rig.hpp"

namespace mrroc::edp {
namespace {

class PeerAxesTest : public PeerTest {
 protected:
  PeerAxesTest() : PeerTest("--axes 2", "1") {}
  void place(config::DriveTable& drives) const override {
    config::DriveEntry& second = drives.drives[1];
    second.node = 1;
    second.channel = 2;
    second.first_pdo = canopen::first_pdo_of_channel(2);
    second.pdos_of = 2;
    drives.eds.repeat_axis(2, second.first_pdo);
  }
  void expect_motion(double way) {
    const JointVector begin = seen().joints;
    ASSERT_FALSE(send(relative_joints(JointVector{{way, -way}}, 100))) << last.state.error.detail.view();
    run(160);
    EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
    EXPECT_NEAR(seen().joints[0] - begin[0], way, 0.02);
    EXPECT_NEAR(seen().joints[1] - begin[1], -way, 0.02);
  }
};

TEST_P(PeerAxesTest, MovesAndReportsTheFaultOfTheAxisThatHasIt) {
  expect_motion(0.2);
  for (const char* const axis : {"1", "2"}) {
    peer.say(std::string("node 1 axis ") + axis + " emcy 0x7305");
    for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
    EXPECT_EQ(seen().fault.code, ErrorCode::drive_fault) << text();
    EXPECT_NE(text().find(std::string("axis ") + axis), std::string::npos) << text();
    run(50);
    EXPECT_TRUE(do_now(CommandKind::recover, 600)) << text() << " " << last.state.error.detail.view();
  }
  expect_motion(0.1);
}

TEST_P(PeerAxesTest, RecoversWhenItHasRestarted) {
  peer.say("node 1 reboot");
  for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
  EXPECT_EQ(seen().fault.code, ErrorCode::drive_restarted) << text();
  run(50);
  EXPECT_TRUE(do_now(CommandKind::recover, 1000)) << text() << " " << last.state.error.detail.view();
  expect_motion(0.1);
}

INSTANTIATE_TEST_SUITE_P(Can, PeerAxesTest, every_mode(), name_of_mode);

}  // namespace
}  // namespace mrroc::edp
