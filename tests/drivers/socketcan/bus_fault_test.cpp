// Faults of a bus or a drive at random moments of a motion: the robot stops inside its limits, the error names the
// drive and the cause, no axis moves afterwards, and `recover` works when the cause is gone.
#include <gtest/gtest.h>

#include <cstdio>

#include "bus_fault_cases.hpp"

namespace mrroc::edp {
namespace {

class BusFault : public testing::TestWithParam<Case> {};

TEST_P(BusFault, StopsTheRobotAndCanBeRecovered) {
  const Case& fault = GetParam();
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    if (!rig.bus.is_hub() && !fault.on_sockets) return;
    ASSERT_EQ(rig.fault().code, ErrorCode::none) << describe(rig.fault().code);
    fault.begin(rig);
    rig.stop(fault.hears);
    EXPECT_NE(std::find(fault.codes.begin(), fault.codes.end(), rig.fault().code), fault.codes.end())
        << describe(rig.fault().code) << " " << rig.text();
    EXPECT_NE(rig.text().find(fault.text), std::string::npos) << rig.text();
    EXPECT_LE(rig.stopped_after, 300u);
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    EXPECT_LE(rig.worst_position, 1);
    if (fault.obeys) {
      EXPECT_LE(rig.worst_real_speed, 1.05);
      EXPECT_LE(rig.off_its_way, 0.01);
    }
    EXPECT_LT(rig.moved, 0.01) << "rad of a shaft, after the stop";
    if (fault.hears) {
      EXPECT_FALSE(rig.operates());
    }
    fault.end(rig);
    rig.settle();
    EXPECT_FALSE(rig.powered());
    ASSERT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
    EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
  }
}

INSTANTIATE_TEST_SUITE_P(Can, BusFault, testing::ValuesIn(cases()), [](const auto& each) { return each.param.name; });

TEST(BusFault, RestartedDriveWithoutAnAbsoluteEncoderIsNotSynchronised) {
  Rig rig(1, false);
  with_node(rig, [](auto& node) { node.boot(0); });
  rig.stop();
  EXPECT_EQ(rig.fault().code, ErrorCode::drive_restarted);
  EXPECT_FALSE(rig.servo->snapshot().synchronised);
  EXPECT_TRUE(rig.recover()) << rig.text();
  EXPECT_TRUE(rig.servo->snapshot().enabled());
  EXPECT_FALSE(rig.moves_again()) << "joints are unknown";
}

TEST(BusFault, ImmediateRecoveryTakesNoDrivesPowerDuringItsStop) {
  Rig rig(1, true, 100);  // rad/s^2: a stop of a quarter of a second
  with_node(rig, [](auto& node) { node.fail(0x7305); });
  while (rig.fault().code == ErrorCode::none) rig.tick();
  RobotCommand command;
  command.kind = CommandKind::recover;
  ASSERT_FALSE(rig.effector.accept(command, ++rig.number, rig.answer));
  int slowing_down = 0;
  rig.last = {};
  for (int i = 0; i < 4000 && rig.last.command != rig.number; ++i) {
    const JointVector before = rig.rack.shafts();
    rig.tick();
    const JointVector speed = (rig.rack.shafts() - before) / kCanPeriod;
    rig.rack.with([&](auto& nodes) {
      for (std::size_t axis = 0; axis < nodes.size(); ++axis) {
        if (std::abs(speed[static_cast<Eigen::Index>(axis)]) < 5) continue;
        EXPECT_TRUE(nodes[axis].powered()) << axis << ": it coasts";
        ++slowing_down;
      }
    });
  }
  EXPECT_GT(slowing_down, 40) << "the drives were moving";
  EXPECT_EQ(rig.last.state.error.error_class, ErrorClass::none) << rig.text();
  EXPECT_TRUE(rig.moves_again());
}

TEST(BusFault, PersistentCauseIsReportedAtEachRecovery) {
  Rig rig(1);
  rig.weak_bus->goes_off = true;
  report(rig, 0x40, 0);
  while (rig.fault().code == ErrorCode::none) rig.tick();
  for (int i = 0; i < 2; ++i) {
    for (int tick = 0; tick < 100; ++tick) rig.tick();
    EXPECT_FALSE(rig.recover());
    EXPECT_EQ(rig.fault().code, ErrorCode::bus_off) << rig.text();
    EXPECT_NE(rig.text().find("bus off: the controller has left the bus"), std::string::npos) << rig.text();
  }
  rig.weak_bus->goes_off = rig.weak_bus->is_off = false;
  report(rig, 0x100, 0);  // ip link set can0 type can restart
  rig.settle();
  EXPECT_TRUE(rig.recover()) << rig.text();
  EXPECT_TRUE(rig.moves_again()) << rig.text();
}

/// No driver can prevent frames that reset drives or write to them; all other frames may occur.
std::uint32_t harmful(std::mt19937& random) {
  for (;;) {
    const std::uint32_t id = random() % 0x800, function = id & 0x780;
    if (id != 0 && function != 0x600) return id;
  }
}

TEST(BusFault, BabblingNodeLetsTheMotionEndOrTheRobotStopsWithTheCause) {
  unsigned stopped = 0, foreign_masters = 0;
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    babble(rig, 20, harmful);
    for (int i = 0; i < 300 && rig.fault().code == ErrorCode::none; ++i) rig.tick();
    rig.before_tick = {};
    if (rig.fault().code == ErrorCode::none) {
      for (int i = 0; i < 1500 && rig.last.command != rig.number; ++i) rig.tick();
      EXPECT_EQ(rig.last.command, rig.number) << "the motion has not ended";
      EXPECT_EQ(rig.last.state.error.error_class, ErrorClass::none) << rig.text();
    } else {
      ++stopped;
      if (rig.text().find("another node sends SYNC, NMT or set-points") != std::string::npos) ++foreign_masters;
      EXPECT_TRUE(rig.text().find("axis ") == 0 || rig.fault().code == ErrorCode::bus_error) << rig.text();
      rig.stop();
      EXPECT_LT(rig.moved, 0.01);
      rig.settle();
      EXPECT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
      EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
    }
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
  }
  EXPECT_EQ(stopped, seeds()) << "some of so many frames are those of a master";
  EXPECT_GT(foreign_masters, 0u);
  std::printf("%u of %u were stopped, %u for another master\n", stopped, seeds(), foreign_masters);
}

TEST(BusFault, LostAnswersDuringARepeatedSetUpAreRequestedAgain) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    if (!rig.bus.is_hub()) return;  // the kernel cannot lose frames of one kind only
    with_node(rig, [](auto& node) { node.boot(0); });
    rig.stop();
    int lost = 0;
    rig.spoil.use([&rig, &lost](can::Frame& frame) {
      if ((frame.id != 0x583 && frame.id != 0x603) || rig.random() % 12 != 0) return true;
      ++lost;
      return false;
    });
    EXPECT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
    rig.spoil.use({});
    EXPECT_GT(lost, 0);
    EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
  }
}

}  // namespace
}  // namespace mrroc::edp
