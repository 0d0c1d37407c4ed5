#include "config/drive_table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "config/message_text.hpp"
#include "config/named_file.hpp"
#include "config/resources.hpp"
#include "config/table.hpp"

namespace mrroc::config {

namespace {

using canopen::DriveMode;

/// A file beside the table, or one of the framework's.
canopen::EdsFile read_eds(const Table& table) {
  const std::string name = table.text("eds");
  std::filesystem::path file = beside(table.file(), name);
  if (!std::filesystem::exists(file)) file = type_file("canopen", "standard", name);
  if (!std::filesystem::exists(file))
    table.fail("eds", in_quotes(name) + " is not there", "an EDS file beside this one, or 'cia402.eds'");
  try {
    return canopen::EdsFile::load(file);
  } catch (const canopen::EdsError& error) {
    table.fail("eds", error.what(), "an EDS file of CiA 306");
  }
}

/// `[objects]`: the object dictionary's names, or addresses, and the values to write.
void read_settings(const Table& owner, const canopen::EdsFile& eds, std::vector<DriveSetting>& settings) {
  const auto table = owner.optional_table("objects");
  if (!table) return;
  for (const std::string& key : table->keys()) {
    DriveSetting setting;
    setting.name = key;
    try {
      setting.object = eds.object(key);
    } catch (const std::invalid_argument& error) {
      table->fail(key, error.what(), "an object of the drive");
    }
    const canopen::ObjectEntry& entry = *eds.find(setting.object);
    if (!entry.writable()) table->fail(key, "may only be read", "an object that may be written");
    const std::size_t size = canopen::size_of(entry.type);
    if (size == 0 || entry.type == canopen::DataType::real32)
      table->fail(key, "is of a type that is no whole number", "an object with a whole number");
    setting.value = table->integer(key, canopen::least(entry.type), canopen::greatest(entry.type));
    setting.size = static_cast<std::uint8_t>(size);
    settings.push_back(setting);
  }
  table->finish();
}

DriveMode read_mode(const Table& table) {
  const std::string mode = table.choice("mode", {"position", "velocity", "torque"});
  if (mode == "position") return DriveMode::cyclic_position;
  return mode == "velocity" ? DriveMode::cyclic_velocity : DriveMode::cyclic_torque;
}

/// Onto the switch and off it as the robot's own synchronisation would: methods 3 and 5 take the first zero pulse off a
/// switch that is closed up to the positive, or the negative, end.
DriveHoming read_homing(const Table& table, const AxisParameters& axis) {
  DriveHoming homing;
  const int usual = axis.synchro_coarse > 0 ? 3 : axis.synchro_coarse < 0 ? 5 : 37;
  homing.method = static_cast<std::int8_t>(table.integer_or("homing_method", usual, -128, 127));
  homing.speed_switch = table.number_or("homing_speed_switch", std::abs(axis.synchro_coarse), {0, 1e4});
  homing.speed_zero = table.number_or("homing_speed_zero", std::abs(axis.synchro_fine), {0, 1e4});
  return homing;
}

DriveEntry read_drive(const Table& table, const AxisParameters& axis, DriveMode mode) {
  DriveEntry drive;
  drive.axis = axis.name;
  drive.node = static_cast<canopen::NodeId>(table.integer("node", 1, canopen::kMaxNode));
  drive.units_per_turn = table.number_or("units_per_turn", axis.encoder_increments, {1, 1e9});
  if (table.boolean_or("reversed", false)) drive.units_per_turn = -drive.units_per_turn;
  drive.rated_current = table.number("rated_current", {1e-3, 1e4});
  if (mode == DriveMode::cyclic_velocity) drive.position_gain = table.number("position_gain", {0, 1e4});
  drive.homing = read_homing(table, axis);
  return drive;
}

std::vector<DriveEntry> read_drives(const Table& file, const RobotParameters& robot, DriveMode mode,
                                    const canopen::EdsFile& eds) {
  const std::vector<Table> tables = file.tables("drives");
  std::vector<DriveSetting> common;
  read_settings(file, eds, common);
  std::vector<DriveEntry> drives;
  for (const AxisParameters& axis : robot.axes) {
    const auto is_of_axis = [&axis](const Table& table) { return table.text("axis") == axis.name; };
    const auto count = std::count_if(tables.begin(), tables.end(), is_of_axis);
    if (count != 1)
      file.fail("drives", std::to_string(count) + " drives of axis " + in_quotes(axis.name), "one for each axis");
    const Table& table = *std::find_if(tables.begin(), tables.end(), is_of_axis);
    drives.push_back(read_drive(table, axis, mode));
    drives.back().settings = common;
    read_settings(table, eds, drives.back().settings);
    table.finish();
    const canopen::NodeId node = drives.back().node;
    const auto same = [node](const DriveEntry& drive) { return drive.node == node; };
    if (std::any_of(drives.begin(), drives.end() - 1, same))
      table.fail("node", std::to_string(node) + " is the node of an earlier drive", "a node of its own");
  }
  if (tables.size() == robot.axes.size()) return drives;
  for (const Table& table : tables) {
    const std::string name = table.text("axis");
    const auto same = [&name](const AxisParameters& axis) { return axis.name == name; };
    if (std::none_of(robot.axes.begin(), robot.axes.end(), same))
      table.fail("axis", in_quotes(name) + " is no axis of " + robot.type, "the name of one");
  }
  return drives;
}

}  // namespace

DriveTable read_drive_table(const std::filesystem::path& file, const RobotParameters& robot) {
  const Table table = Table::load(file);
  table.only({"eds", "mode", "absolute_encoders", "master", "heartbeat", "answer_time", "missed_max", "set_points",
              "status_every", "objects", "drives"});
  DriveTable drives;
  drives.file = file;
  drives.mode = read_mode(table);
  drives.absolute_encoders = table.boolean_or("absolute_encoders", false);
  drives.master = static_cast<canopen::NodeId>(table.integer_or("master", drives.master, 1, canopen::kMaxNode));
  drives.heartbeat = table.number_or("heartbeat", drives.heartbeat, {0, 10});
  drives.answer_time = table.number_or("answer_time", drives.answer_time, {0.05, 0.9});
  drives.missed_max = static_cast<int>(table.integer_or("missed_max", drives.missed_max, 0, 100));
  // a loop that is closed here would have a tick of delay more in it
  const std::string usual = drives.mode == DriveMode::cyclic_torque ? "at once" : "at sync";
  drives.target_at_sync =
      (table.has("set_points") ? table.choice("set_points", {"at sync", "at once"}) : usual) == "at sync";
  drives.status_every = static_cast<int>(table.integer_or("status_every", drives.status_every, 1, 240));
  drives.eds = read_eds(table);
  drives.drives = read_drives(table, robot, drives.mode, drives.eds);
  for (const DriveEntry& drive : drives.drives)
    if (drive.node == drives.master)
      table.fail("master", std::to_string(drives.master) + " is the node of drive " + in_quotes(drive.axis),
                 "a number that no node has");
  return drives;
}

}  // namespace mrroc::config
