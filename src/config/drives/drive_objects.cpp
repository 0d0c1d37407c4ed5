#include "config/drives/drive_objects.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

#include "canopen/object_value.hpp"
#include "canopen/objects.hpp"
#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

using canopen::DriveMode;
using canopen::Object;

/// The source of the value that the EDP writes into this object of every drive; null: the EDP does not write it.
const char* source_of(Object object, bool absolute_encoders) {
  if (object == canopen::kConsumerHeartbeat) return "from the keys 'heartbeat' and 'master'";
  if (object == canopen::kProducerHeartbeat) return "from the key 'heartbeat'";
  if (object == canopen::kInterpolationTime || object == canopen::kInterpolationExponent)
    return "from the deployment's servo_period";
  if (object == canopen::kMode) return "from the key 'mode'";
  if (object == canopen::kHomingMethod) return "from the drive's key 'homing_method'";
  if (object == canopen::kHomingSpeedSwitch) return "from the drive's key 'homing_speed_switch'";
  if (object == canopen::kHomingSpeedZero) return "from the drive's key 'homing_speed_zero'";
  if (object == canopen::kHomeOffset && !absolute_encoders) return "as 0, and adds motor_synchro of the robot's axis";
  for (const Object cyclic :
       {canopen::kControlword, canopen::kTargetPosition, canopen::kTargetVelocity, canopen::kTargetTorque})
    if (object == cyclic) return "in every cycle";
  return nullptr;
}

/// Of RPDO 1, TPDO 1 and TPDO 2: identifier, transmission type and mapping.
bool is_of_own_pdo(Object object) {
  for (const std::uint16_t parameters : {canopen::kReceivePdoParameters, canopen::kTransmitPdoParameters,
                                         static_cast<std::uint16_t>(canopen::kTransmitPdoParameters + 1)})
    if (object.index == parameters) return object.sub == 1 || object.sub == 2;
  return object.index == canopen::kReceivePdoMapping || object.index == canopen::kTransmitPdoMapping ||
         object.index == canopen::kTransmitPdoMapping + 1;
}

void refuse_own(const Table& table, const std::string& key, Object object, bool absolute_encoders) {
  if (is_of_own_pdo(object))
    table.fail(key, "is of a PDO that the EDP sets up itself", "an object that it leaves alone");
  if (const char* const source = source_of(object, absolute_encoders))
    table.fail(key, std::string("is written by the EDP itself, ") + source, "an object that it leaves alone");
}

/// The objects that the PDOs carry.
void check_objects(const Table& table, const canopen::EdsFile& eds, DriveMode mode) {
  const Object target = mode == DriveMode::cyclic_position   ? canopen::kTargetPosition
                        : mode == DriveMode::cyclic_velocity ? canopen::kTargetVelocity
                                                             : canopen::kTargetTorque;
  for (const Object object :
       {canopen::kControlword, canopen::kMode, target, canopen::kStatusword, canopen::kPositionActual,
        canopen::kTorqueActual, canopen::kVelocityActual, canopen::kDigitalInputs})
    if (eds.find(object) == nullptr)
      table.fail("eds", "has no object " + canopen::to_text(object),
                 "a drive for mode " + in_quotes(table.text("mode")) + ", which needs it in its PDOs");
}

/// An error that another part of the framework reports: "<problem>, expected <what>", or the problem alone.
[[noreturn]] void fail_with(const Table& table, const std::string& key, const std::string& message,
                            const std::string& usual) {
  constexpr std::string_view kExpected = ", expected ";
  const std::size_t at = message.find(kExpected);
  if (at == std::string::npos) table.fail(key, message, usual);
  table.fail(key, message.substr(0, at), message.substr(at + kExpected.size()));
}

DriveSetting read_setting(const Table& table, const std::string& key, const DriveTable& drives) {
  const canopen::EdsFile& eds = drives.eds;
  DriveSetting setting;
  setting.name = key;
  try {
    setting.object = eds.object(key);
  } catch (const std::invalid_argument& error) {
    fail_with(table, key, error.what(), "an object of the drive");
  }
  const canopen::ObjectEntry& entry = *eds.find(setting.object);
  if (!entry.writable()) table.fail(key, "may only be read", "an object that may be written");
  refuse_own(table, key, setting.object, drives.absolute_encoders);
  const std::size_t size = canopen::size_of(entry.type);
  if (size == 0 || entry.type == canopen::DataType::real32)
    table.fail(key, "is not of an integer type", "an object with an integer");
  setting.value = table.integer(key, canopen::least(entry.type), canopen::greatest(entry.type));
  setting.size = static_cast<std::uint8_t>(size);
  return setting;
}

}  // namespace

std::filesystem::path eds_file(const Table& table) {
  const std::string name = table.text("eds");
  std::filesystem::path file = beside(table.file(), name);
  for (const std::filesystem::path& share : share_directories())
    if (!std::filesystem::exists(file)) file = share / "canopen" / "standard" / name;
  if (!std::filesystem::exists(file))
    table.fail("eds", in_quotes(name) + " is not there", "an EDS file beside this one, or 'cia402.eds'");
  return file;
}

canopen::EdsFile read_eds(const Table& table, DriveMode mode) {
  const std::string name = table.text("eds");
  const std::filesystem::path file = eds_file(table);
  if (const std::string problem = reading_problem(file); !problem.empty())
    table.fail("eds", in_quotes(name) + " " + problem, "an EDS file of CiA 306");
  try {
    canopen::EdsFile eds = canopen::EdsFile::load(file);
    check_objects(table, eds, mode);
    return eds;
  } catch (const canopen::EdsError& error) {
    fail_with(table, "eds", error.what(), "an EDS file of CiA 306");
  }
}

void read_settings(const Table& owner, const DriveTable& drives, std::vector<DriveSetting>& settings) {
  const auto table = owner.optional_table("objects");
  if (!table) return;
  std::vector<DriveSetting> own;
  for (const std::string& key : table->keys()) {
    own.push_back(read_setting(*table, key, drives));
    const auto same = [&own](const DriveSetting& setting) { return setting.object == own.back().object; };
    if (const auto earlier = std::find_if(own.begin(), own.end() - 1, same); earlier != own.end() - 1)
      table->fail(key, "is the object of " + in_quotes(earlier->name), "each object once");
  }
  settings.insert(settings.end(), own.begin(), own.end());
  table->finish();
}

}  // namespace mrroc::config
