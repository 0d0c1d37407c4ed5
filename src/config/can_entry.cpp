#include "config/can_entry.hpp"

#include "config/drive_table.hpp"
#include "config/message_text.hpp"
#include "config/named_file.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::config {

namespace {

void check_clock(const Table& table, const Deployment& deployment, const CanEntry& can) {
  if (can.simulated && !deployment.sim) table.fail("simulated", "true needs a simulator", "a table [sim]");
  if (!can.simulated && deployment.clock != ClockMode::real)
    table.fail("", "real drives go on by themselves", "clock = \"real\", or simulated = true");
}

void check_interface_is_free(const Table& table, const Deployment& deployment, const RobotEntry& robot) {
  for (const RobotEntry& other : deployment.robots)
    if (other.can && other.can->interface == robot.can->interface && other.host == robot.host)
      table.fail("interface", in_quotes(robot.can->interface) + " is that of robot " + in_quotes(other.name),
                 "a bus of its own for each robot: one sends the SYNC");
}

/// A robot whose encoders count from where the power came on must be synchronised first; a simulated one may be born
/// synchronised.
void settle_synchronised(const Table& robot_table, const DriveTable& drives, RobotEntry& robot) {
  const bool given = robot_table.has("synchronised");
  if (!robot.can->simulated && given && robot.synchronised && !drives.absolute_encoders)
    robot_table.fail("synchronised", "true, but the drives have no absolute encoders (" + drives.file.string() + ")",
                     "false (leave the key out)");
  if (!given && !drives.absolute_encoders && !robot.can->simulated) robot.synchronised = false;
}

}  // namespace

void read_can(const Table& robot_table, const Deployment& deployment, RobotEntry& robot) {
  if (robot.hardware != "socketcan") {
    if (robot_table.has("can")) robot_table.fail("can", "a robot without a bus", "hardware = \"socketcan\" beside it");
    return;
  }
  const Table table = robot_table.table("can");
  table.only({"interface", "drives", "simulated"});
  CanEntry& can = robot.can.emplace();
  can.interface = table.text("interface");
  if (can.interface.empty()) table.fail("interface", "no name", "a CAN interface, as \"can0\"");
  can.simulated = table.boolean_or("simulated", false);
  check_clock(table, deployment, can);
  check_interface_is_free(table, deployment, robot);
  const bool here = robot.host == deployment.here;
  can.drives = table.has("drives") ? beside(table.file(), table.text("drives"))
                                   : robot_file(robot.type, robot.type + "_drives.toml");
  if (!here) return;
  if (!std::filesystem::exists(can.drives))
    table.fail("drives", in_quotes(can.drives.string()) + " is not there", "a table of the robot's drives");
  const RobotParameters parameters = read_robot_parameters(Table::load(robot_file(robot.type, robot.type + ".toml")));
  settle_synchronised(robot_table, read_drive_table(can.drives, parameters), robot);
  if (can.simulated) can.program = require_program(table, "simulated", robot.type + "_drives");
}

}  // namespace mrroc::config
