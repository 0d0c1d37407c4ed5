#include "drivers/socketcan/drive_setup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "can_rig.hpp"
#include "canopen/object_value.hpp"
#include "config/table.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

std::vector<config::NodeSetting> settings(DriveMode mode, double period = kCanPeriod) {
  const config::DriveTable table = table_for(Slide{}.parameters(), mode);
  return drive_settings(table, table.drives[0], period);
}

std::int64_t last(const std::vector<config::NodeSetting>& all, Object object) {
  std::int64_t value = -1;
  for (const config::NodeSetting& setting : all)
    if (setting.object == object) value = setting.value;
  return value;
}

TEST(DriveSetup, PdoIsDisabledDuringItsChange) {
  const auto all = settings(DriveMode::cyclic_position);
  ASSERT_GT(all.size(), 12u);
  EXPECT_EQ(all[0].object, (Object{0x1400, 1}));
  EXPECT_EQ(all[0].value, 0x80000201);
  EXPECT_EQ(all[2].object, (Object{0x1600, 0}));
  EXPECT_EQ(all[2].value, 0);
  EXPECT_EQ(last(all, {0x1400, 1}), 0x201);
  EXPECT_EQ(last(all, {0x1600, 0}), 3);
  EXPECT_EQ(last(all, {0x1600, 1}), 0x60400010);
  EXPECT_EQ(last(all, {0x1600, 2}), 0x607a0020);
  EXPECT_EQ(last(all, {0x1600, 3}), 0x60600008);
  EXPECT_EQ(last(all, {0x1a00, 0}), 3);
  EXPECT_EQ(last(all, {0x1801, 2}), 4);
  EXPECT_EQ(last(all, {0x1800, 1}), 0x40000181) << "it is not requested";
}

TEST(DriveSetup, ModeDeterminesTheTransmittedObjects) {
  EXPECT_EQ(last(settings(DriveMode::cyclic_velocity), {0x1600, 2}), 0x60ff0020);
  EXPECT_EQ(last(settings(DriveMode::cyclic_torque), {0x1600, 2}), 0x60710010);
  EXPECT_EQ(last(settings(DriveMode::cyclic_torque), {0x1400, 2}), 255) << "at once";
  EXPECT_EQ(last(settings(DriveMode::cyclic_torque), kMode), 10);
}

TEST(DriveSetup, SyncOfASharedBusIsWritten) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  EXPECT_EQ(last(drive_settings(table, table.drives[0], kCanPeriod), kSyncIdentifier), -1) << "the usual one is not";
  table.sync = 0xfe;
  EXPECT_EQ(last(drive_settings(table, table.drives[0], kCanPeriod), kSyncIdentifier), 0xfe);
}

TEST(DriveSetup, ServoPeriodIsWrittenAsInTheProfile) {
  EXPECT_EQ(last(settings(DriveMode::cyclic_position, 0.002), kInterpolationTime), 2);
  EXPECT_EQ(last(settings(DriveMode::cyclic_position, 0.002), kInterpolationExponent), -3);
  EXPECT_EQ(last(settings(DriveMode::cyclic_position, 0.0005), kInterpolationTime), 5);
  EXPECT_EQ(last(settings(DriveMode::cyclic_position, 0.0005), kInterpolationExponent), -4);
  EXPECT_THROW(settings(DriveMode::cyclic_position, 1.0 / 3), config::ConfigurationError);
}

TEST(DriveSetup, ReadOnlySettingIsNotWritten) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  const std::string exponent = "[60C2sub2]\nParameterName=Interpolation time index\nObjectType=0x7\nDataType=0x0002\n";
  for (const std::string access : {"ro", "const"}) {
    table.eds = changed_eds(exponent + "AccessType=rw", exponent + "AccessType=" + access);
    const auto all = drive_settings(table, table.drives[0], kCanPeriod);
    EXPECT_EQ(last(all, kInterpolationTime), 2);
    EXPECT_EQ(last(all, kInterpolationExponent), -1) << access;
  }
}

TEST(DriveSetup, CyclePeriodIsWrittenInMicroseconds) {
  EXPECT_EQ(last(settings(DriveMode::cyclic_position, 0.0025), kCyclePeriod), 2500);
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  table.drives[0].settings.push_back({kCyclePeriod, "Communication cycle period", 0, 4});
  EXPECT_EQ(last(drive_settings(table, table.drives[0], kCanPeriod), kCyclePeriod), 0) << "the table's own";
}

/// The sections of a PDO's parameters.
std::string pdo(const std::string& index, const std::string& identifier) {
  std::string text = "[" + index + "]\nParameterName=PDO " + index + "\nSubNumber=2\n\n";
  return text.append("[" + index + "sub1]\nParameterName=COB-ID\nDataType=7\nAccessType=rw\nDefaultValue=")
      .append(identifier + "\n\n");
}

TEST(DriveSetup, OtherPdosOfADriveAreDisabled) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  table.eds = changed_eds("[1A00]", pdo("1802", "$NODEID+0x380") + pdo("1803", "0x80000480+$NODEID") +
                                        pdo("1804", "0x40000123") + pdo("1805", "0x124") + "[1A00]");
  table.drives[0].settings.push_back({{0x1805, 1}, "0x1805:1", 0x124, 4});
  const auto all = drive_settings(table, table.drives[0], kCanPeriod);
  EXPECT_EQ(last(all, {0x1802, 1}), 0x80000381);
  EXPECT_EQ(last(all, {0x1803, 1}), -1) << "the manufacturer has disabled it";
  EXPECT_EQ(last(all, {0x1804, 1}), 0xc0000123);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& each) { return each.object.index == 0x1805; }), 1)
      << "the table requires it";
  EXPECT_EQ(last(all, {0x1801, 1}), 0x40000281) << "ours";
  HeldGantry rig([] {
    config::DriveTable four = table_for(Gantry{}.parameters(), DriveMode::cyclic_position);
    four.eds = changed_eds("[1A00]", pdo("1802", "$NODEID+0x380") + "[1A00]");
    return four;
  }());
  EXPECT_EQ(rig.refusal(), "") << "a drive accepts it";
}

TEST(DriveSetup, DriveWithoutHomingGetsNoHomingSettings) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  table.drives[0].homing.method = 0;
  const auto all = drive_settings(table, table.drives[0], kCanPeriod);
  for (const Object object : {kHomingMethod, kHomingSpeedSwitch, kHomingSpeedZero}) EXPECT_EQ(last(all, object), -1);
  EXPECT_NE(last(settings(DriveMode::cyclic_position), kHomingSpeedZero), -1);
}

TEST(DriveSetup, HomingSpeedsAreWrittenInVelocityUnits) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  table.drives[0].velocity_units_per_turn = -60;  // revolutions per minute, reversed
  table.drives[0].homing = {3, 2 * std::numbers::pi, 0.2 * std::numbers::pi};
  const auto all = drive_settings(table, table.drives[0], kCanPeriod);
  EXPECT_EQ(last(all, kHomingSpeedSwitch), 60);
  EXPECT_EQ(last(all, kHomingSpeedZero), 6);
}

TEST(DriveSetup, ValueOfTheTableReplacesTheDefault) {
  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  for (const Object object : {kQuickStopOption, kFaultReactionOption, kAbortConnectionOption})
    table.drives[0].settings.push_back({object, to_text(object), 0, 2});
  const auto all = drive_settings(table, table.drives[0], kCanPeriod);
  for (const Object object : {kQuickStopOption, kFaultReactionOption, kAbortConnectionOption}) {
    const auto same = [object](const config::NodeSetting& setting) { return setting.object == object; };
    EXPECT_EQ(std::count_if(all.begin(), all.end(), same), 1) << to_text(object);
    EXPECT_EQ(last(all, object), 0);
  }
}

TEST(DriveSetup, HeartbeatsAndHomeAreThoseOfTheTable) {
  const auto all = settings(DriveMode::cyclic_position);
  EXPECT_EQ(last(all, kConsumerHeartbeat), 127 << 16 | 60);
  EXPECT_EQ(last(all, kProducerHeartbeat), 20);
  EXPECT_EQ(last(all, kHomeOffset), 0) << "a homed drive counts from there";
  EXPECT_EQ(last(all, kAbortConnectionOption), 1) << "the loss of the master's heartbeat is a fault";
}

}  // namespace
}  // namespace mrroc::edp
