// Faults of the robot and disturbances of the connection: found, reported, recovered.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/ur/ur_hardware.hpp"
#include "drivers/ur/ur_rig.hpp"

namespace mrroc::ur::ur_disturbance_test {
namespace {

using testing::HasSubstr;

struct StateFault {
  const char* name;
  ErrorCode code;
  const char* text;
  std::function<void(VirtualController&)> cause, repair;
};

class StateFaults : public testing::TestWithParam<StateFault> {};

TEST_P(StateFaults, AreReportedAndRecovered) {
  const StateFault& fault = GetParam();
  Rig rig;
  ASSERT_TRUE(rig.start());
  rig.controller.servers.with(fault.cause);
  ASSERT_TRUE(rig.finds(fault.code)) << rig.text();
  EXPECT_THAT(rig.text(), HasSubstr(fault.text));
  rig.enable(false);
  rig.ticks(5);
  if (fault.repair) {
    EXPECT_FALSE(rig.recover()) << "its cause is still there";
    rig.controller.servers.with(fault.repair);
  }
  ASSERT_TRUE(rig.recover());
  rig.rate[0] = 20;
  const double before = rig.joints()[0];
  rig.ticks(100);
  EXPECT_GT(rig.joints()[0], before + 0.01);
  EXPECT_TRUE(rig.healthy());
}

INSTANTIATE_TEST_SUITE_P(
    UrHardware, StateFaults,
    testing::Values(
        StateFault{"ProtectiveStop",
                   ErrorCode::drive_fault,
                   "protective stop",
                   [](VirtualController& c) { c.protective_stop(); },
                   {}},
        StateFault{"EmergencyStop", ErrorCode::emergency_stop, "ROBOT_EMERGENCY_STOP",
                   [](VirtualController& c) { c.emergency_stop(true); },
                   [](VirtualController& c) { c.emergency_stop(false); }},
        StateFault{"SafeguardStop", ErrorCode::drive_not_ready, "SAFEGUARD_STOP",
                   [](VirtualController& c) { c.safeguard_stop(true); },
                   [](VirtualController& c) { c.safeguard_stop(false); }},
        StateFault{
            "PowerOff", ErrorCode::drive_not_ready, "POWER_OFF", [](VirtualController& c) { c.power_off(); }, {}},
        StateFault{"ProgramStopped",
                   ErrorCode::drive_not_ready,
                   "does not run",
                   [](VirtualController& c) { c.stop_program(); },
                   {}},
        StateFault{"OtherProgram",
                   ErrorCode::drive_not_ready,
                   "",
                   [](VirtualController& c) { c.start_program("def other():\nend\n"); },
                   {}},
        StateFault{"JointFault", ErrorCode::drive_fault, "joint mode FAULT",
                   [](VirtualController& c) { c.fail_joint(3); }, [](VirtualController& c) { c.power_off(); }}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(UrHardware, NamesTheAxisOfAJointFault) {
  Rig rig;
  rig.controller.servers.with([](VirtualController& c) { c.fail_joint(3); });
  ASSERT_TRUE(rig.finds(ErrorCode::drive_fault));
  EXPECT_EQ(rig.input.fault_axis, 3);
}

TEST(UrHardware, ReportsThatTheRobotIsNotInRemoteControl) {
  Rig rig;
  rig.controller.servers.with([](VirtualController& c) { c.set_remote_control(false); });
  EXPECT_FALSE(rig.start());
  EXPECT_EQ(rig.input.fault, ErrorCode::drive_not_ready);
  EXPECT_THAT(rig.text(), HasSubstr("remote control"));
  rig.controller.servers.with([](VirtualController& c) { c.set_remote_control(true); });
  EXPECT_TRUE(rig.recover());
}

TEST(UrHardware, ConnectsAgainAfterACut) {
  Rig rig;
  ASSERT_TRUE(rig.start());
  rig.controller.servers.refuse(true);
  ASSERT_TRUE(rig.finds(ErrorCode::hardware_silent));
  EXPECT_THAT(rig.text(), HasSubstr("RTDE interface at 127.0.0.1:"));
  rig.enable(false);
  rig.controller.servers.refuse(false);
  ASSERT_TRUE(rig.recover());
  EXPECT_GE(rig.hardware->link_counters().connections, 2u);
}

TEST(UrHardware, ConnectsAgainAfterARestartOfTheController) {
  Rig rig;
  ASSERT_TRUE(rig.start());
  rig.controller.servers.restart();
  ASSERT_TRUE(rig.tick_until([&] { return rig.input.fault != ErrorCode::none; }));
  rig.enable(false);
  ASSERT_TRUE(rig.recover());
}

TEST(UrHardware, GarbageEndsTheConnection) {
  Rig rig;
  ASSERT_TRUE(rig.start());
  rig.controller.servers.send_garbage();
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().connections == 2; }));
  EXPECT_TRUE(rig.recover());
}

TEST(UrHardware, CountsLostAndDoubledPackages) {
  Rig rig;
  ASSERT_TRUE(rig.start());
  const LinkCounters before = rig.hardware->link_counters();
  rig.controller.servers.lose(7);
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().lost == before.lost + 7; }));
  rig.controller.servers.repeat(5);
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().doubled == before.doubled + 5; }));
  rig.controller.servers.delay(10);
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().late > before.late; }));
  EXPECT_EQ(rig.hardware->link_counters().lost, before.lost + 7);
  EXPECT_TRUE(rig.healthy());
  EXPECT_GT(rig.hardware->link_counters().sent, before.sent);
}

TEST(UrHardware, PostponedPackagesArriveInTheirOrder) {
  Rig rig;
  ASSERT_TRUE(rig.start());
  rig.controller.servers.postpone(5);
  rig.ticks(50);
  rig.controller.servers.postpone(0);
  rig.ticks(50);
  EXPECT_EQ(rig.hardware->link_counters().lost, 0u);
  EXPECT_EQ(rig.hardware->link_counters().doubled, 0u);
  EXPECT_TRUE(rig.healthy());
  rig.controller.servers.lose_every(5);
  const std::uint64_t lost = rig.hardware->link_counters().lost;
  ASSERT_TRUE(rig.tick_until([&] { return rig.hardware->link_counters().lost >= lost + 10; }));
  EXPECT_TRUE(rig.healthy());
}

TEST(UrHardware, APositionThatIsNoNumberIsNotHidden) {
  Rig rig;
  rig.controller.servers.with([](VirtualController& c) { c.falsify(std::nan("")); });
  EXPECT_TRUE(rig.tick_until([&] { return !std::isfinite(rig.input.motors[0]); }));
  rig.controller.servers.with([](VirtualController& c) { c.falsify(0); });
  EXPECT_TRUE(rig.tick_until([&] { return std::isfinite(rig.input.motors[0]); }));
}

TEST(UrHardware, TheTimeOfARepeatedReadingIsRepeated) {
  Rig rig;
  rig.ticks(5);
  rig.controller.servers.refuse(true);
  ASSERT_TRUE(rig.finds(ErrorCode::hardware_silent));
  const double last = rig.input.time;
  rig.ticks(3);
  EXPECT_EQ(rig.input.time, last);
  EXPECT_LT(rig.input.time, static_cast<double>(rig.now));
}

}  // namespace
}  // namespace mrroc::ur::ur_disturbance_test
