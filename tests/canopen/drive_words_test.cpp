#include "canopen/drive_words.hpp"

#include <gtest/gtest.h>

namespace mrroc::canopen {
namespace {

TEST(DriveWords, DescribesControlwords) {
  const auto position = DriveMode::cyclic_position;
  EXPECT_EQ(controlword_text(kDisableVoltage, position), "disable voltage");
  EXPECT_EQ(controlword_text(kQuickStop, position), "quick stop");
  EXPECT_EQ(controlword_text(kShutdown, position), "shutdown");
  EXPECT_EQ(controlword_text(kSwitchOn, position), "switch on");
  EXPECT_EQ(controlword_text(kEnableOperation, position), "enable operation");
  EXPECT_EQ(controlword_text(kFaultReset, position), "fault reset");
  EXPECT_EQ(controlword_text(0x1f, position), "enable operation");
  EXPECT_EQ(controlword_text(0x1f, DriveMode::homing), "enable operation, start homing");
  EXPECT_EQ(controlword_text(0x10f, position), "enable operation, halt");
}

TEST(DriveWords, DescribesStatuswords) {
  EXPECT_EQ(statusword_text(0x0040, DriveMode::none), "switch on disabled");
  EXPECT_EQ(statusword_text(0x1637, DriveMode::cyclic_position), "operation enabled, target reached, follows command");
  EXPECT_EQ(statusword_text(0x1637, DriveMode::homing), "operation enabled, target reached, homing attained");
  EXPECT_EQ(statusword_text(0x2037, DriveMode::homing), "operation enabled, homing error");
  EXPECT_EQ(statusword_text(0x2037, DriveMode::cyclic_position), "operation enabled, following error");
  EXPECT_EQ(statusword_text(0x2037, DriveMode::cyclic_torque), "operation enabled");
  EXPECT_EQ(statusword_text(0x0888, DriveMode::none), "fault, warning, internal limit");
}

TEST(DriveWords, DescribesSwitches) {
  EXPECT_EQ(switches_text(0), "no switch");
  EXPECT_EQ(switches_text(0xffff0000), "no switch");
  EXPECT_EQ(switches_text(7), "negative limit switch, positive limit switch, home switch");
}

}  // namespace
}  // namespace mrroc::canopen
