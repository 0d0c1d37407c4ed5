#include "config/entries/shared_bus.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "config/robot_parameters_file.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

using canopen::NodeId;

/// A participant with a node number: "drive of 'column'", "I/O node", "master".
struct Participant {
  NodeId node;
  std::string what;
};

std::vector<Participant> participants(const BusNodes& nodes) {
  std::vector<Participant> all{{nodes.drives.master, "master"}};
  for (const DriveEntry& drive : nodes.drives.drives) {
    all.push_back({drive.node, "drive of " + in_quotes(drive.axis)});
    if (drive.pdo_node() != drive.node)
      all.push_back({drive.pdo_node(), "pdo_node of the drive of " + in_quotes(drive.axis)});
  }
  for (const IoEntry& entry : nodes.io.nodes) all.push_back({entry.node, "I/O node"});
  return all;
}

/// The table of a file whose key `node` is this number.
Table table_with(const Table& file, const std::string& list, NodeId node) {
  const std::vector<Table> tables = file.tables(list);
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [node](const Table& table) { return table.integer("node", 0, 127) == node; });
  return found == tables.end() ? file : *found;
}

[[noreturn]] void refuse(const BusNodes& nodes, NodeId node, const std::string& what, const RobotEntry& other) {
  const std::string problem =
      std::to_string(node) + " is the " + what + " of robot " + in_quotes(other.name) + " on the same bus";
  const std::string expected = "a unique number on the bus, in a table for robot " + in_quotes(nodes.robot.name);
  const Table drives = Table::load(nodes.drives.file);
  if (node == nodes.drives.master) drives.fail("master", problem, expected);
  const bool of_io = std::any_of(nodes.io.nodes.begin(), nodes.io.nodes.end(),
                                 [node](const IoEntry& entry) { return entry.node == node; });
  if (of_io) table_with(Table::load(nodes.io.file), "nodes", node).fail("node", problem, expected);
  table_with(drives, "drives", node).fail("node", problem, expected);
}

void check_sync(const BusNodes& nodes, const BusNodes& other) {
  const std::uint32_t sync = nodes.drives.sync;
  const std::string expected = "a unique identifier on the bus, as 128 plus the key 'master'";
  const Table file = Table::load(nodes.drives.file);
  if (sync == other.drives.sync)
    file.fail("sync",
              std::to_string(sync) + " is the SYNC of robot " + in_quotes(other.robot.name) + " on the same bus",
              expected);
  for (const auto& [one, two] : {std::pair{&nodes, &other}, std::pair{&other, &nodes}})
    for (const Participant& each : participants(*one))
      if (two->drives.sync != canopen::kSync && each.node == two->drives.sync - canopen::kEmergency &&
          each.what != "master")
        file.fail("sync",
                  std::to_string(two->drives.sync) + " of robot " + in_quotes(two->robot.name) +
                      " is the identifier of the EMCY of node " + std::to_string(each.node) + " on the same bus",
                  expected);
}

void check_pair(const BusNodes& nodes, const BusNodes& other) {
  const std::vector<Participant> others = participants(other);
  for (const Participant& mine : participants(nodes))
    for (const Participant& theirs : others)
      if (mine.node == theirs.node) refuse(nodes, mine.node, theirs.what, other.robot);
  check_sync(nodes, other);
}

}  // namespace

std::vector<BusNodes> others_on_bus(const Deployment& deployment, const RobotEntry& robot) {
  std::vector<BusNodes> others;
  for (const RobotEntry& other : deployment.robots) {
    if (!other.can || other.can->interface != robot.can->interface || other.host != robot.host) continue;
    const RobotParameters parameters = read_robot_parameters(Table::load(other.files().parameters));
    DriveTable drives = read_drive_table(other.can->drives, parameters);
    IoTable io = other.can->io.empty() ? IoTable{} : read_io_table(other.can->io, drives);
    others.push_back({other, std::move(drives), std::move(io)});
  }
  return others;
}

void check_shared_bus(const Table& can, const std::vector<BusNodes>& all) {
  const BusNodes& nodes = all.back();
  for (const BusNodes& other : all) {
    if (&other == &nodes) return;
    if (other.robot.driver.simulated != nodes.robot.driver.simulated)
      can.fail("simulated", "other than that of robot " + in_quotes(other.robot.name) + " on the same bus",
               "either simulated or real nodes on a bus");
    check_pair(nodes, other);
  }
}

}  // namespace mrroc::config
