// What goes wrong on a bus or in a drive, at random moments of a motion: the robot stops inside its limits, the error
// names the drive and the cause, nothing moves any more, and `recover` works when the cause has gone.
#include <gtest/gtest.h>

#include <cstdio>

#include "bus_fault_rig.hpp"

namespace mrroc::edp {
namespace {

/// One kind of fault.
struct Case {
  std::string name;
  std::vector<ErrorCode> codes;  ///< that it may be found as
  std::string text;              ///< in the error's
  std::function<void(Rig&)> begin;
  std::function<void(Rig&)> end;
  bool on_sockets = true;  ///< also where the kernel carries the frames
};

void with_node(Rig& rig, const std::function<void(sim::DriveNode&)>& action) {
  rig.rack.with([&](auto& nodes) { action(rig.node(nodes)); });
}

/// What the controller reports comes as a frame from outside.
void report(Rig& rig, std::uint32_t classes, std::uint8_t controller) {
  can::Frame frame{classes, {0, controller, 0, 0, 0, 0, 0, 0}};
  frame.error = true;
  rig.bus.open()->send(frame);
}

void nothing(Rig&) {}

/// From now on somebody else sends `count` frames in every tick, with random data: what `identifier` gives.
void babble(Rig& rig, int count, const std::function<std::uint32_t(std::mt19937&)>& identifier) {
  rig.before_tick = [&rig, count, identifier, babbler = std::shared_ptr<can::Bus>(rig.bus.open())] {
    for (int i = 0; i < count; ++i) {
      can::Frame frame;
      frame.id = identifier(rig.random);
      frame.size = static_cast<std::uint8_t>(rig.random() % 9);
      for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(rig.random());
      babbler->send(frame);
    }
  };
}

std::vector<Case> cases() {
  return {
      {"NodeLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(false); }); }},
      {"HeartbeatLost",
       {ErrorCode::heartbeat_lost},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(false); }); }},
      {"SwitchesLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z), tick ",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.withhold_status(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.withhold_status(false); }); }},
      {"LimitSwitch",
       {ErrorCode::limit_switch},
       "axis 3 (z), tick ",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.press(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.press(false); }); }},
      {"Emergency",
       {ErrorCode::drive_fault},
       "error code 7305h, incremental sensor 1 fault",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.fail(0x7305); }); },
       nothing},
      {"Restarted",
       {ErrorCode::drive_restarted, ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.boot(0); }); },
       nothing},
      {"BusOff", {ErrorCode::bus_off}, "bus off", [](Rig& rig) { report(rig, 0x40, 0); }, nothing},
      {"ErrorPassive", {ErrorCode::bus_error}, "error passive", [](Rig& rig) { report(rig, 0x4, 0x20); }, nothing},
      {"Overflow",
       {ErrorCode::bus_error},
       "overflow: the controller has lost frames",
       [](Rig& rig) { report(rig, 0x4, 0x1); },
       nothing},
      {"NobodyAcknowledges", {ErrorCode::bus_error}, "no acknowledge", [](Rig& rig) { report(rig, 0x20, 0); }, nothing},
      {"Transceiver", {ErrorCode::bus_error}, "transceiver", [](Rig& rig) { report(rig, 0x10, 0); }, nothing},
      {"QueueFull",
       {ErrorCode::bus_error},
       "transmit queue full",
       [](Rig& rig) {
         if (rig.bus.is_hub())
           rig.weak_bus->answer = can::Sent::full;
         else
           disturb(rig, "limit 1 delay 10s");
       },
       [](Rig& rig) {
         rig.weak_bus->answer = can::Sent::yes;
         if (!rig.bus.is_hub()) leave_in_peace(rig);
       }},
      {"InterfaceDown",
       {ErrorCode::bus_off},
       "the interface is down",
       [](Rig& rig) {
         if (rig.bus.is_hub())
           rig.weak_bus->answer = can::Sent::down;
         else
           interface(rig, "ip link set DEV down");
       },
       [](Rig& rig) {
         rig.weak_bus->answer = can::Sent::yes;
         if (!rig.bus.is_hub()) interface(rig, "ip link set DEV up");
       }},
      {"SyncLost",
       {ErrorCode::hardware_silent},
       "no drive has answered more than 2 SYNCs in a row: they are lost, or the bus is cut",
       [](Rig& rig) { rig.weak_bus->loses_syncs = true; },
       [](Rig& rig) { rig.weak_bus->loses_syncs = false; }},
      {"PositionStuck",
       {ErrorCode::axis_stuck, ErrorCode::following_error, ErrorCode::overspeed, ErrorCode::encoder_fault},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(false); }); }},
      {"Impostor",
       {ErrorCode::encoder_fault},
       "answers more than SYNCs: another node sends under its number",
       [](Rig& rig) { babble(rig, 5, [](std::mt19937&) { return 0x183u; }); },
       [](Rig& rig) { rig.before_tick = {}; }},
      {"BitsTurnedOver",
       {ErrorCode::encoder_fault, ErrorCode::drive_fault, ErrorCode::drive_not_ready, ErrorCode::overspeed,
        ErrorCode::following_error, ErrorCode::axis_stuck},
       "axis 3 (z)",
       [](Rig& rig) {
         rig.spoil.use([&rig](can::Frame& frame) {
           if (frame.id == 0x183) frame.data[rig.random() % 6] ^= static_cast<std::uint8_t>(1 + rig.random() % 255);
           return true;
         });
       },
       [](Rig& rig) { rig.spoil.use({}); },
       false},
      {"FramesLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { rig.spoil.use([](can::Frame& frame) { return frame.id != 0x183; }); },
       [](Rig& rig) { rig.spoil.use({}); },
       false},
  };
}

class BusFault : public testing::TestWithParam<Case> {};

TEST_P(BusFault, StopsTheRobotAndCanBeRecovered) {
  const Case& fault = GetParam();
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    if (!rig.bus.is_hub() && !fault.on_sockets) return;
    ASSERT_EQ(rig.fault().code, ErrorCode::none) << describe(rig.fault().code);
    fault.begin(rig);
    rig.stop();
    EXPECT_NE(std::find(fault.codes.begin(), fault.codes.end(), rig.fault().code), fault.codes.end())
        << describe(rig.fault().code) << " " << rig.text();
    EXPECT_NE(rig.text().find(fault.text), std::string::npos) << rig.text();
    EXPECT_LE(rig.stopped_after, 300u);
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    EXPECT_LE(rig.worst_real_speed, 1.5);
    EXPECT_LT(rig.moved, 0.01) << "rad of a shaft, after the stop";
    fault.end(rig);
    rig.settle();
    ASSERT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
    EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
  }
}

INSTANTIATE_TEST_SUITE_P(Can, BusFault, testing::ValuesIn(cases()), [](const auto& each) { return each.param.name; });

TEST(BusFault, ADriveThatHasRestartedWithoutAnAbsoluteEncoderIsNotSynchronised) {
  Rig rig(1, false);
  with_node(rig, [](auto& node) { node.boot(0); });
  rig.stop();
  EXPECT_EQ(rig.fault().code, ErrorCode::drive_restarted);
  EXPECT_FALSE(rig.servo->snapshot().synchronised);
  EXPECT_TRUE(rig.recover()) << rig.text();
  EXPECT_TRUE(rig.servo->snapshot().enabled);
  EXPECT_FALSE(rig.moves_again()) << "joints are not known";
}

TEST(BusFault, WhoRecoversAtOnceTakesNoDrivesPowerInItsStop) {
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
  EXPECT_GT(slowing_down, 40) << "they were under way";
  EXPECT_EQ(rig.last.state.error.error_class, ErrorClass::none) << rig.text();
  EXPECT_TRUE(rig.moves_again());
}

/// What resets or starts drives, or claims to be their SYNC or master, no driver can stop; all else may come.
std::uint32_t harmful(std::mt19937& random) {
  for (;;) {
    const std::uint32_t id = random() % 0x800, function = id & 0x780;
    if (id != 0 && id != 0x80 && function != 0x200 && function != 0x600) return id;
  }
}

TEST(BusFault, BesideANodeThatBabblesTheRobotEndsItsMotionOrStopsAndSaysWhy) {
  unsigned stopped = 0;
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
      EXPECT_TRUE(rig.text().find("axis ") == 0 || rig.fault().code == ErrorCode::bus_error) << rig.text();
      rig.stop();
      EXPECT_LT(rig.moved, 0.01);
      rig.settle();
      EXPECT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
      EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
    }
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    EXPECT_LE(rig.worst_real_speed, 1.5);
  }
  std::printf("%u of %u were stopped\n", stopped, seeds());
}

TEST(BusFault, AnswersThatAreLostWhileADriveIsSetUpAnewAreAskedForAgain) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    if (!rig.bus.is_hub()) return;  // the kernel loses frames of no single kind
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
