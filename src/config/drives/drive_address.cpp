#include "config/drives/drive_address.hpp"

#include <cstdlib>
#include <string>
#include <utility>

#include "canopen/object_value.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// The EMCY of a node has an identifier in the range of the SYNCs.
void check_emergency(const Table& table, canopen::NodeId node, std::uint32_t sync) {
  if (sync != canopen::kSync && node == sync - canopen::kEmergency)
    table.fail("node", std::to_string(node) + ", whose EMCY has the identifier of the table's 'sync'", "another one");
}

/// Two axes of one drive.
void check_channels(const Table& table, const DriveEntry& drive, const DriveEntry& other) {
  const std::string taken = "the drive of " + in_quotes(other.axis);
  if (drive.channel == other.channel && table.has("channel"))
    table.fail("channel", std::to_string(drive.channel) + " of node " + std::to_string(drive.node) + " is " + taken,
               "another axis of the drive");
  if (drive.channel == other.channel)
    table.fail("node", std::to_string(drive.node) + " is the node of " + taken,
               "a unique node, or a 'channel' for each axis of a drive");
  if (std::abs(drive.first_pdo - other.first_pdo) <= 1)
    table.fail("first_pdo",
               std::to_string(drive.first_pdo) + ", but two PDOs from " + std::to_string(other.first_pdo) +
                   " on are those of the axis " + in_quotes(other.axis),
               "two PDOs for each axis");
}

/// The object dictionary has the objects of this axis.
void check_channel_objects(const Table& table, const DriveEntry& drive, const DriveTable& drives) {
  const auto parameters = static_cast<std::uint16_t>(canopen::kReceivePdoParameters + drive.first_pdo - 1);
  const canopen::Object controlword = of_channel(canopen::kControlword, drive.channel);
  for (const auto& [key, object] : {std::pair{"channel", controlword}, {"first_pdo", canopen::Object{parameters, 1}}})
    if (drive.channel != 1 && drives.eds.find(object) == nullptr)
      table.fail(key, "needs object " + canopen::to_text(object) + ", which the EDS file does not have",
                 "an axis of these drives");
}

}  // namespace

void read_address(const Table& table, DriveEntry& drive) {
  drive.node = static_cast<canopen::NodeId>(table.integer("node", 1, canopen::kMaxNode));
  drive.channel = static_cast<int>(table.integer_or("channel", 1, 1, canopen::kMaxChannels));
  drive.first_pdo = static_cast<int>(
      table.integer_or("first_pdo", canopen::first_pdo_of_channel(drive.channel), 1, canopen::kMaxPdos - 1));
  const int usual = drive.node + drive.channel - 1;
  if (usual > canopen::kMaxNode && !table.has("pdo_node"))
    table.fail("pdo_node", "missing, and " + std::to_string(usual) + ", node + channel - 1, is no node's number",
               "a number that no node has");
  drive.pdos_of = static_cast<canopen::NodeId>(table.integer_or("pdo_node", usual, 1, canopen::kMaxNode));
}

void check_address(const Table& table, const DriveEntry& drive, const DriveTable& drives) {
  for (const canopen::NodeId node : {drive.node, drive.pdo_node()})
    if (node == drives.master)
      table.fail(node == drive.node ? "node" : "pdo_node", std::to_string(node) + " is the master's",
                 "another one, or another 'master' of the table");
  check_emergency(table, drive.node, drives.sync);
  for (const DriveEntry& other : drives.drives) {
    if (drive.node == other.node) check_channels(table, drive, other);
    const bool taken =
        drive.pdo_node() == other.pdo_node() || (drive.node != other.node && drive.pdo_node() == other.node);
    if (taken || (drive.node != other.node && drive.node == other.pdo_node()))
      table.fail(taken && drive.pdo_node() != drive.node ? "pdo_node" : "node",
                 std::to_string(taken ? drive.pdo_node() : drive.node) + " is the node of the drive of " +
                     in_quotes(other.axis),
                 "a unique node");
  }
  check_channel_objects(table, drive, drives);
}

}  // namespace mrroc::config
