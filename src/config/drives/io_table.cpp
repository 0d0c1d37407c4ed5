#include "config/drives/io_table.hpp"

#include <algorithm>

#include "config/drives/io_objects.hpp"
#include "config/text/message_text.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::config {

namespace {

/// Numbers of terminals that are taken so far.
struct Taken {
  int digital_inputs = 0, digital_outputs = 0, analog_inputs = 0, analog_outputs = 0;
};

/// The next `key` terminals after the `taken` ones.
TerminalRange read_terminals(const Table& table, const std::string& key, int most, int& taken) {
  TerminalRange terminals{taken, static_cast<int>(table.integer_or(key, 0, 0, most))};
  taken += terminals.count;
  if (taken > most)
    table.fail(key, std::to_string(terminals.count) + ", " + std::to_string(taken) + " with those of the nodes before",
               "at most " + std::to_string(most) + " of a robot");
  return terminals;
}

AnalogTerminals read_analog(const Table& table, const std::string& kind, int& taken) {
  AnalogTerminals terminals{read_terminals(table, kind + "s", ControllerIo::kAnalog, taken)};
  const std::string key = kind + "_range";
  if (terminals.count == 0 && table.has(key)) table.fail(key, "the node has no " + kind + "s", "no such key");
  terminals.range = table.number_or(key, terminals.range, {1e-6, 1e6});
  return terminals;
}

/// A node without 1005h takes the predefined SYNC only.
void check_sync(const Table& table, const IoEntry& node, const DriveTable& drives) {
  if (drives.sync == canopen::kSync) return;
  if (node.node == drives.sync - canopen::kEmergency)
    table.fail("node", std::to_string(node.node) + ", whose EMCY has the identifier of the SYNC of the drives' table",
               "another one");
  const canopen::ObjectEntry* const entry = node.eds.find(canopen::kSyncIdentifier);
  if (entry == nullptr || !entry->writable())
    table.fail("eds",
               "has no identifier of the SYNC that can be written (1005h), and the drives' table has its own 'sync'",
               "a node that has it");
}

void check_node(const Table& table, canopen::NodeId node, const DriveTable& drives, const IoTable& io) {
  const std::string number = std::to_string(node);
  if (node == drives.master) table.fail("node", number + " is the master's", "another one");
  for (const DriveEntry& drive : drives.drives)
    if (drive.node == node || drive.pdo_node() == node)
      table.fail("node", number + " is the node of the drive of " + in_quotes(drive.axis), "a unique node");
  for (const IoEntry& other : io.nodes)
    if (other.node == node) table.fail("node", number + " is that of an earlier I/O node", "a unique node");
}

IoEntry read_node(const Table& table, Taken& taken) {
  IoEntry node;
  node.node = static_cast<canopen::NodeId>(table.integer("node", 1, canopen::kMaxNode));
  node.digital_inputs = read_terminals(table, "digital_inputs", ControllerIo::kDigital, taken.digital_inputs);
  node.digital_outputs = read_terminals(table, "digital_outputs", ControllerIo::kDigital, taken.digital_outputs);
  node.analog_inputs = read_analog(table, "analog_input", taken.analog_inputs);
  node.analog_outputs = read_analog(table, "analog_output", taken.analog_outputs);
  if (node.digital_inputs.count + node.digital_outputs.count + node.analog_inputs.count + node.analog_outputs.count ==
      0)
    table.fail("", "node " + std::to_string(node.node) + " has no terminals",
               "'digital_inputs', 'digital_outputs', 'analog_inputs' or 'analog_outputs'");
  node.eds = load_eds(table, kGeneralIoEds);
  check_io_eds(table, node);
  read_settings(table, node.eds, &check_io_object, node.settings);
  return node;
}

}  // namespace

int IoTable::digital_inputs() const noexcept {
  return nodes.empty() ? 0 : nodes.back().digital_inputs.first + nodes.back().digital_inputs.count;
}

IoTable read_io_table(const std::filesystem::path& file, const DriveTable& drives) {
  const Table table = Table::load(file);
  table.only({"nodes"});
  const std::vector<Table> nodes = table.tables("nodes");
  if (nodes.empty()) table.fail("nodes", "no I/O node", "[[nodes]], one or more");
  IoTable io;
  io.file = file;
  Taken taken;
  for (const Table& node : nodes) {
    node.only({"node", "eds", "digital_inputs", "digital_outputs", "analog_inputs", "analog_input_range",
               "analog_outputs", "analog_output_range", "objects"});
    IoEntry entry = read_node(node, taken);
    check_node(node, entry.node, drives, io);
    check_sync(node, entry, drives);
    io.nodes.push_back(std::move(entry));
  }
  return io;
}

std::vector<std::filesystem::path> io_eds_files(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  for (const Table& node : Table::load(file).tables("nodes")) files.push_back(eds_file(node, kGeneralIoEds));
  return files;
}

}  // namespace mrroc::config
