#include "config/entries/can_entry.hpp"

#include <net/if.h>

#include <algorithm>
#include <cmath>

#include "config/drives/drive_table.hpp"
#include "config/drives/io_table.hpp"
#include "config/entries/bus_capacity.hpp"
#include "config/entries/named_file.hpp"
#include "config/entries/shared_bus.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"
#include "mrroc/signals.hpp"
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

/// A named table that this host reads: beside the deployment file.
std::filesystem::path named_table(const Table& table, const std::string& key) {
  return table.has(key) && !table.text(key).empty() ? beside(table.file(), table.text(key)) : std::filesystem::path();
}

void require_readable(const Table& table, const std::string& key, const std::filesystem::path& file,
                      const std::string& what) {
  if (const std::string problem = reading_problem(file); !problem.empty())
    table.fail(key, in_quotes(file.string()) + " " + problem,
               "a table of the robot's " + what + " (docs/how-to/can.md)");
}

void require_io(const Table& robot_table, const CanEntry& can) {
  if (robot_table.has("emergency_stop") && can.io.empty())
    robot_table.fail("emergency_stop", "a robot on a CAN bus has no inputs without I/O nodes",
                     "a table of them, 'io' in [robots.NAME.can], or no such key");
}

/// An emergency stop on an input that is not there would be pressed permanently.
void check_emergency_stop(const Table& robot_table, const IoTable& io) {
  if (!robot_table.has("emergency_stop")) return;
  const std::int64_t input = robot_table.integer("emergency_stop", 0, ControllerIo::kDigital - 1);
  if (input < io.digital_inputs()) return;
  std::string expected = "an input of them";
  if (io.digital_inputs() > 0) expected += ", 0 to " + std::to_string(io.digital_inputs() - 1);
  robot_table.fail("emergency_stop",
                   std::to_string(input) + " is not an input of the I/O nodes of " + in_quotes(io.file.string()),
                   expected);
}

}  // namespace

void read_can(const Table& robot_table, const Deployment& deployment, RobotEntry& robot) {
  if (robot.driver.name != "socketcan") return;
  const Table table = robot_table.table("can");
  CanEntry& can = robot.can.emplace();
  can.interface = read_interface(table);
  check_period(table, deployment.servo_period);
  if (robot.driver.simulated) check_process_name(table, robot);
  can.drives = named_table(table, "drives");
  if (can.drives.empty()) can.drives = robot.files().drives;
  can.io = named_table(table, "io");
  require_io(robot_table, can);
  if (robot.host != deployment.here) return;
  require_readable(table, "drives", can.drives, "drives");
  const RobotParameters parameters = read_robot_parameters(Table::load(robot.files().parameters));
  const DriveTable drives = read_drive_table(can.drives, parameters);
  settle_synchronised(robot_table, drives, robot);
  IoTable io;
  if (!can.io.empty()) {
    require_readable(table, "io", can.io, "I/O nodes");
    io = read_io_table(can.io, drives);
    check_emergency_stop(robot_table, io);
  }
  std::vector<BusNodes> all = others_on_bus(deployment, robot);
  all.push_back({robot, drives, std::move(io)});
  check_shared_bus(table, all);
  check_bus_capacity(table, deployment.servo_period, all);
}

}  // namespace mrroc::config
