#include "config/entries/can_entry.hpp"

#include <net/if.h>

#include <algorithm>
#include <cmath>

#include "config/drives/drive_table.hpp"
#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::config {

namespace {

constexpr std::string_view kHub = "unix:";
constexpr std::size_t kInterfaceLength = IFNAMSIZ - 1;
constexpr std::size_t kHubLength = 107;  // of a socket's path

/// A kernel name is unchanged; a hub's path is relative to the folder of the deployment file.
std::string read_interface(const Table& table) {
  std::string name = table.text("interface");
  if (name.starts_with(kHub)) {
    const std::string path = beside(table.file(), name.substr(kHub.size())).string();
    if (name.size() == kHub.size()) table.fail("interface", in_quotes(name) + " has no path", "\"unix:PATH\"");
    if (path.size() > kHubLength)
      table.fail("interface", in_quotes(path) + " has " + std::to_string(path.size()) + " characters",
                 "at most " + std::to_string(kHubLength));
    return std::string(kHub) + path;
  }
  const auto odd = [](char c) { return c == '/' || c <= ' ' || c == 0x7f; };
  if (name.empty() || name.size() > kInterfaceLength || std::any_of(name.begin(), name.end(), odd))
    table.fail("interface", in_quotes(name) + " is not the name of an interface", "as \"can0\", or \"unix:PATH\"");
  return name;
}

/// The drives receive the period as a whole number of 8 bits and a power of ten (60C2h).
void check_period(const Table& table, double period) {
  for (const double unit : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const double number = period / unit;
    if (std::abs(number - std::round(number)) < 1e-6 && number < 255.5) return;
  }
  table.fail("", "drives on a bus do not support a servo period of " + number_text(period) + " s",
             "a whole number up to 255 of 1 ms, 0.1 ms, 10 us or 1 us");
}

void check_interface_is_free(const Table& table, const Deployment& deployment, const RobotEntry& robot) {
  for (const RobotEntry& other : deployment.robots)
    if (other.can && other.can->interface == robot.can->interface && other.host == robot.host)
      table.fail("interface", in_quotes(robot.can->interface) + " is that of robot " + in_quotes(other.name),
                 "a separate bus for each robot: one robot sends the SYNC");
}

void check_process_name(const Table& table, const RobotEntry& robot) {
  const std::size_t most = kNameLength - (robot.drives_process().size() - robot.name.size());
  if (robot.name.size() > most)
    table.fail("simulated", "true, but the name of process " + in_quotes(robot.drives_process()) + " is too long",
               "a robot's name of at most " + std::to_string(most) + " characters");
}

/// A robot whose encoders count from their position at power-on must be synchronised first; a simulated one may start
/// synchronised.
void settle_synchronised(const Table& robot_table, const DriveTable& drives, RobotEntry& robot) {
  const bool counting = !robot.driver.simulated && !drives.absolute_encoders;
  const std::string why = "the drives have no absolute encoders (" + drives.file.string() + ")";
  if (counting && robot_table.has("synchronised") && robot.synchronised)
    robot_table.fail("synchronised", "true, but " + why, "false (leave the key out)");
  if (robot.synchronised && !counting) return;
  robot.synchronised = false;
  for (const DriveEntry& drive : drives.drives)
    if (drive.homing.method == 0)
      robot_table.fail(counting ? "can" : "synchronised",
                       (counting ? why : "false") + ", but axis " + in_quotes(drive.axis) +
                           " has no switch, and its drive no homing method, to find its position by",
                       "a homing_method, or absolute_encoders = true, in the table of drives");
}

}  // namespace

void read_can(const Table& robot_table, const Deployment& deployment, RobotEntry& robot) {
  if (robot.driver.name != "socketcan") return;
  if (robot_table.has("emergency_stop"))
    robot_table.fail("emergency_stop", "a robot on a CAN bus has no inputs", "no such key");
  const Table table = robot_table.table("can");
  CanEntry& can = robot.can.emplace();
  can.interface = read_interface(table);
  check_period(table, deployment.servo_period);
  check_interface_is_free(table, deployment, robot);
  if (robot.driver.simulated) check_process_name(table, robot);
  can.drives = table.has("drives") ? beside(table.file(), table.text("drives")) : robot.files().drives;
  if (robot.host != deployment.here) return;
  if (const std::string problem = reading_problem(can.drives); !problem.empty())
    table.fail("drives", in_quotes(can.drives.string()) + " " + problem,
               "a table of the robot's drives (docs/how-to/can.md)");
  const RobotParameters parameters = read_robot_parameters(Table::load(robot.files().parameters));
  settle_synchronised(robot_table, read_drive_table(can.drives, parameters), robot);
}

}  // namespace mrroc::config
