#include "config/drives/drive_objects.hpp"

#include <string>

#include "canopen/object_value.hpp"
#include "canopen/objects.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

using canopen::DriveMode;
using canopen::Object;

/// The source of the value that the EDP writes into this object of every drive; null: the EDP does not write it.
const char* source_of(Object object, bool absolute_encoders) {
  if (object == canopen::kConsumerHeartbeat) return "from the keys 'heartbeat' and 'master'";
  if (object == canopen::kSyncIdentifier) return "from the key 'sync'";
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

}  // namespace

canopen::EdsFile read_drive_eds(const Table& table, DriveMode mode) {
  canopen::EdsFile eds = load_eds(table, kGeneralDriveEds);
  check_objects(table, eds, mode);
  return eds;
}

CheckObject check_drive_object(bool absolute_encoders) {
  return [absolute_encoders](const Table& table, const std::string& key, Object object) {
    refuse_own(table, key, object, absolute_encoders);
  };
}

}  // namespace mrroc::config
