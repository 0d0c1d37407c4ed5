#include "drivers/socketcan/drive_setup.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "config/table.hpp"
#include "drivers/socketcan/setting_list.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr std::int64_t kSlowDownAndDisable = 2;  // quick stop and fault reaction option codes: on the quick stop ramp
constexpr std::int64_t kFault = 1;               // abort connection option code: our heartbeat is lost

/// The servo period in the form of 60C2h: a number up to 255, and an exponent of ten.
std::array<int, 2> period_of(const config::DriveTable& table, double period) {
  for (int exponent = -3; exponent >= -6; --exponent) {
    const double number = period / std::pow(10.0, exponent);
    if (number <= 255.5 && std::abs(number - std::round(number)) < 1e-6 && number > 0.5)
      return {static_cast<int>(std::lround(number)), exponent};
  }
  throw config::ConfigurationError(table.file, 0, "", "a servo period of " + std::to_string(period) + " s",
                                   "up to 255 whole units of a power of ten, as CiA 402 object 60C2h requires");
}

/// Of a shaft, rad/s, in velocity units as an object of 32 bits takes them.
std::int64_t speed(const config::DriveTable& table, const config::DriveEntry& drive, double shaft) {
  constexpr double kMost = 0xffffffff;
  const double units = std::abs(shaft * drive.velocity_units_per_turn / (2 * std::numbers::pi));
  if (units <= kMost) return std::llround(units);
  throw config::ConfigurationError(table.file, 0, "drives." + drive.axis,
                                   "a homing speed of " + std::to_string(units) + " units per s", "at most 2^32 - 1");
}

}  // namespace

DrivePdos drive_pdos(DriveMode mode) {
  const MappedObject target = mode == DriveMode::cyclic_position   ? MappedObject{kTargetPosition, 4}
                              : mode == DriveMode::cyclic_velocity ? MappedObject{kTargetVelocity, 4}
                                                                   : MappedObject{kTargetTorque, 2};
  return {PdoMapping({{kControlword, 2}, target, {kMode, 1}}),
          PdoMapping({{kStatusword, 2}, {kPositionActual, 4}, {kTorqueActual, 2}}),
          PdoMapping({{kVelocityActual, 4}, {kDigitalInputs, 4}})};
}

namespace {

/// What all axes of a node have in common. PDOs of its axes stay as they are.
void add_common(SettingList& list, const config::DriveTable& table, const config::DriveEntry& first, double period) {
  std::vector<std::uint16_t> used;
  for (const config::DriveEntry& axis : table.drives)
    if (axis.node == first.node)
      for (const int number : {axis.first_pdo, axis.first_pdo + 1})
        used.push_back(static_cast<std::uint16_t>(kTransmitPdoParameters + number - 1));
  list.switch_off_pdos_but(used);
  list.add_sync(table.sync);
  list.add_heartbeats(table.master, table.heartbeat);
  list.add_known(kCyclePeriod, std::llround(period * 1e6), 4);
}

}  // namespace

std::vector<config::NodeSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                double period) {
  const DrivePdos pdos = drive_pdos(table.mode);
  SettingList list(drive.node, table.eds, drive.settings, drive.channel);
  const auto at = [&drive](int first) { return static_cast<std::uint16_t>(first + drive.first_pdo - 1); };
  list.add_pdo(at(kReceivePdoParameters), at(kReceivePdoMapping), kReceivePdo1 + drive.pdo_node(),
               table.target_at_sync ? 1 : kAtOnce, pdos.command);
  list.add_pdo(at(kTransmitPdoParameters), at(kTransmitPdoMapping), kTransmitPdo1 + drive.pdo_node(), 1, pdos.feedback);
  list.add_pdo(at(kTransmitPdoParameters + 1), at(kTransmitPdoMapping + 1), kTransmitPdo1 + 0x100 + drive.pdo_node(),
               static_cast<std::uint8_t>(table.status_every), pdos.status);
  if (table.is_first_of_node(drive)) add_common(list, table, drive, period);
  const auto [number, exponent] = period_of(table, period);
  list.add_known(kInterpolationTime, number, 1);
  list.add_known(kInterpolationExponent, exponent, 1);
  list.add(kMode, static_cast<std::int64_t>(table.mode), 1);
  list.add_known(kQuickStopOption, kSlowDownAndDisable, 2);
  list.add_known(kFaultReactionOption, kSlowDownAndDisable, 2);
  list.add_known(kAbortConnectionOption, kFault, 2);
  // manufacturers differ in its sign: a drive counts from its home position, and we add that position
  if (!table.absolute_encoders) list.add_known(kHomeOffset, 0, 4);
  if (drive.homing.method != 0) {
    list.add_known(kHomingMethod, drive.homing.method, 1);
    list.add_known(kHomingSpeedSwitch, speed(table, drive, drive.homing.speed_switch), 4);
    list.add_known(kHomingSpeedZero, speed(table, drive, drive.homing.speed_zero), 4);
  }
  return list.take();
}

std::vector<config::NodeSetting> node_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                               double period) {
  std::vector<config::NodeSetting> all;
  if (!table.is_first_of_node(drive)) return all;
  for (const config::DriveEntry& axis : table.drives) {
    if (axis.node != drive.node) continue;
    const std::vector<config::NodeSetting> own = drive_settings(table, axis, period);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

}  // namespace mrroc::edp
