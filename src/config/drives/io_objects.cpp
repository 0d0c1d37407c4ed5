#include "config/drives/io_objects.hpp"

#include "canopen/object_value.hpp"
#include "canopen/objects.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr int kPdos = 3;  // of each direction: digital, analogue 1 to 4, analogue 5 to 8

bool is_of_io_pdo(canopen::Object object) {
  for (const std::uint16_t parameters : {canopen::kReceivePdoParameters, canopen::kTransmitPdoParameters})
    if (object.index >= parameters && object.index < parameters + kPdos) return object.sub == 1 || object.sub == 2;
  for (const std::uint16_t mapping : {canopen::kReceivePdoMapping, canopen::kTransmitPdoMapping})
    if (object.index >= mapping && object.index < mapping + kPdos) return true;
  return false;
}

void require_objects(const Table& table, const IoEntry& node, std::uint16_t index, int count, const std::string& key) {
  for (int sub = 1; sub <= count; ++sub) {
    const canopen::Object object{index, static_cast<std::uint8_t>(sub)};
    if (node.eds.find(object) == nullptr)
      table.fail("eds", "has no object " + canopen::to_text(object),
                 "a node with as many terminals as " + in_quotes(key));
  }
}

}  // namespace

void check_io_eds(const Table& table, const IoEntry& node) {
  const auto bytes = [](const TerminalRange& terminals) { return (terminals.count + 7) / 8; };
  require_objects(table, node, canopen::kReadInputs, bytes(node.digital_inputs), "digital_inputs");
  require_objects(table, node, canopen::kWriteOutputs, bytes(node.digital_outputs), "digital_outputs");
  require_objects(table, node, canopen::kReadAnalogInputs, node.analog_inputs.count, "analog_inputs");
  require_objects(table, node, canopen::kWriteAnalogOutputs, node.analog_outputs.count, "analog_outputs");
}

void check_io_object(const Table& table, const std::string& key, canopen::Object object) {
  constexpr const char* kOther = "an object that it leaves alone";
  if (is_of_io_pdo(object)) table.fail(key, "is of a PDO that the EDP sets up itself", kOther);
  if (object == canopen::kConsumerHeartbeat || object == canopen::kProducerHeartbeat)
    table.fail(key, "is written by the EDP itself, from the heartbeat of the table of drives", kOther);
  if (object.index == canopen::kWriteOutputs || object.index == canopen::kWriteAnalogOutputs)
    table.fail(key, "is written by the EDP itself, with the robot's outputs", kOther);
}

}  // namespace mrroc::config
