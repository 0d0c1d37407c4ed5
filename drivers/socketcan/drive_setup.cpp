#include "drivers/socketcan/drive_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "canopen/default_value.hpp"
#include "canopen/object_value.hpp"
#include "config/table.hpp"

namespace mrroc::edp {

namespace {

using namespace canopen;

constexpr std::uint8_t kAtOnce = 255;            // transmission type: the value is taken when it comes
constexpr std::int64_t kSlowDownAndDisable = 2;  // quick stop and fault reaction option codes: on the quick stop ramp
constexpr std::int64_t kFault = 1;               // abort connection option code: our heartbeat is lost

class Settings {
 public:
  Settings(const config::DriveTable& table, const config::DriveEntry& drive) : table_(table), drive_(drive) {}

  void add(Object object, std::int64_t value, std::uint8_t size) {
    settings_.push_back({object, to_text(object), value, size});
  }
  /// Adds the setting if the drive has the object, it is writable, and its `objects` do not set it.
  void add_known(Object object, std::int64_t value, std::uint8_t size) {
    // the table's own value may be there because the drive refuses ours
    const auto same = [object](const config::DriveSetting& own) { return own.object == object; };
    if (std::any_of(drive_.settings.begin(), drive_.settings.end(), same)) return;
    const ObjectEntry* const entry = table_.eds.find(object);
    if (entry != nullptr && entry->writable()) add(object, value, size);
  }
  /// One PDO: it may be changed only while it is not used (CiA 301, 7.5.2.36).
  void add_pdo(std::uint16_t parameters, std::uint16_t mapping, std::uint32_t identifier, std::uint8_t transmission,
               const PdoMapping& map) {
    if (wants_bit_30({parameters, 1})) identifier |= kPdoNoRemote;
    add({parameters, 1}, kPdoNotUsed | identifier, 4);
    add({parameters, 2}, transmission, 1);
    add({mapping, 0}, 0, 1);
    std::uint8_t place = 0;
    for (const MappedObject& mapped : map.objects()) add({mapping, ++place}, mapped.entry(), 4);
    add({mapping, 0}, place, 1);
    add({parameters, 1}, identifier, 4);
  }
  /// Other PDOs that a drive sends on its own, according to its EDS file, only fill the bus.
  void switch_off_pdos_from(std::uint16_t first) {
    const auto& entries = table_.eds.entries();
    const auto end = entries.lower_bound({kTransmitPdoMapping, 0});
    for (auto place = entries.lower_bound({first, 0}); place != end; ++place) {
      const auto& [object, entry] = *place;
      if (object.sub != 1) continue;
      // a DCF describes the drive after its configuration, which it may not have yet
      for (const auto& identifier : {default_number(entry, drive_.node), configured_number(entry, drive_.node)}) {
        if (!identifier || (*identifier & kPdoNotUsed) != 0) continue;
        add_known(object, kPdoNotUsed | *identifier, 4);
        break;
      }
    }
  }
  std::vector<config::DriveSetting> settings_;

 private:
  /// The drive sends its transmit PDOs without a request. In receive PDOs the bit is reserved, and some drives accept
  /// only their manufacturer's value.
  bool wants_bit_30(Object identifier) const {
    if (identifier.index >= kTransmitPdoParameters) return true;
    const ObjectEntry* const entry = table_.eds.find(identifier);
    return entry != nullptr && (default_number(*entry, drive_.node).value_or(0) & kPdoNoRemote) != 0;
  }

  const config::DriveTable& table_;
  const config::DriveEntry& drive_;
};

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

std::vector<config::DriveSetting> drive_settings(const config::DriveTable& table, const config::DriveEntry& drive,
                                                 double period) {
  const DrivePdos pdos = drive_pdos(table.mode);
  Settings list(table, drive);
  list.add_pdo(kReceivePdoParameters, kReceivePdoMapping, kReceivePdo1 + drive.node, table.target_at_sync ? 1 : kAtOnce,
               pdos.command);
  list.add_pdo(kTransmitPdoParameters, kTransmitPdoMapping, kTransmitPdo1 + drive.node, 1, pdos.feedback);
  list.add_pdo(kTransmitPdoParameters + 1, kTransmitPdoMapping + 1, kTransmitPdo1 + 0x100 + drive.node,
               static_cast<std::uint8_t>(table.status_every), pdos.status);
  list.switch_off_pdos_from(kTransmitPdoParameters + 2);
  const auto milliseconds = static_cast<std::int64_t>(std::lround(table.heartbeat * 1e3));
  list.add(kConsumerHeartbeat, static_cast<std::int64_t>(table.master) << 16 | kMissedHeartbeats * milliseconds, 4);
  list.add(kProducerHeartbeat, milliseconds, 2);
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
  for (const config::DriveSetting& setting : drive.settings) list.settings_.push_back(setting);
  return list.settings_;
}

DriveSetup::DriveSetup(NodeId node, std::vector<config::DriveSetting> settings)
    : node_(node), settings_(std::move(settings)) {}

can::Frame DriveSetup::start() noexcept {
  place_ = 0;
  status_ = Status::writing;
  looks_ = forgotten_ = false;
  return request();
}

can::Frame DriveSetup::resume() noexcept {
  place_ = 0;
  status_ = Status::writing;
  looks_ = true;
  forgotten_ = false;
  return poll();
}

can::Frame DriveSetup::poll() noexcept { return transfer_.upload(node_, kProducerHeartbeat); }

can::Frame DriveSetup::request() noexcept {
  std::array<std::uint8_t, 8> bytes{};
  can::put(bytes, 0, bytes.size(), static_cast<std::uint64_t>(setting().value));
  return transfer_.download(node_, setting().object, std::span(bytes).first(setting().size));
}

bool DriveSetup::take(const can::Frame& frame, can::Frame& next) noexcept {
  if (status_ != Status::writing || !transfer_.take(frame, next)) return false;
  if (looks_) {
    if (transfer_.status() == SdoTransfer::Status::waiting) return true;
    const auto beat = [](const config::DriveSetting& setting) { return setting.object == kProducerHeartbeat; };
    const auto ours = std::find_if(settings_.begin(), settings_.end(), beat);
    forgotten_ = transfer_.status() != SdoTransfer::Status::done || ours == settings_.end() ||
                 static_cast<std::int64_t>(can::get(transfer_.value(), 0, 2)) != ours->value;
    looks_ = false;
    next = request();
  } else if (transfer_.status() == SdoTransfer::Status::refused) {
    status_ = Status::refused;
  } else if (transfer_.status() == SdoTransfer::Status::done) {
    if (place_ + 1 == settings_.size()) {
      status_ = Status::done;
    } else {
      ++place_;
      next = request();
    }
  }
  return true;
}

}  // namespace mrroc::edp
