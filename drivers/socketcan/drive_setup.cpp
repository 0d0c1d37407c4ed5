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

std::vector<config::NodeSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                double period) {
  const DrivePdos pdos = drive_pdos(table.mode);
  SettingList list(drive.node, table.eds, drive.settings);
  list.add_pdo(kReceivePdoParameters, kReceivePdoMapping, kReceivePdo1 + drive.node, table.target_at_sync ? 1 : kAtOnce,
               pdos.command);
  list.add_pdo(kTransmitPdoParameters, kTransmitPdoMapping, kTransmitPdo1 + drive.node, 1, pdos.feedback);
  list.add_pdo(kTransmitPdoParameters + 1, kTransmitPdoMapping + 1, kTransmitPdo1 + 0x100 + drive.node,
               static_cast<std::uint8_t>(table.status_every), pdos.status);
  list.switch_off_pdos_from(kTransmitPdoParameters + 2);
  list.add_sync(table.sync);
  list.add_heartbeats(table.master, table.heartbeat);
  list.add_known(kCyclePeriod, std::llround(period * 1e6), 4);
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

}  // namespace mrroc::edp
