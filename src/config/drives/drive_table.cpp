#include "config/drives/drive_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "config/drives/drive_address.hpp"
#include "config/drives/drive_objects.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "mrroc/search_speed.hpp"

namespace mrroc::config {

namespace {

using canopen::DriveMode;

constexpr double kLongestServoPeriod = 0.02;      // s: of a deployment
constexpr double kGreatestCurrentRatio = 32;      // of current_max to rated_current: a torque is 16 bits of per mille
constexpr double kLeastCurrentRatio = 0.01;       // below: mA instead of A
constexpr double kGreatestPosition = 2147483647;  // a position is 32 bits with a sign

DriveMode read_mode(const Table& table) {
  const std::string mode = table.choice("mode", {"position", "velocity", "torque"});
  if (mode == "position") return DriveMode::cyclic_position;
  return mode == "velocity" ? DriveMode::cyclic_velocity : DriveMode::cyclic_torque;
}

/// Heartbeats are sent with the servo's ticks and cannot be more frequent. They are required: nothing else stops the
/// drives when the EDP dies.
double read_heartbeat(const Table& table, double usual) {
  const double heartbeat = table.number_or("heartbeat", usual, {0, 10});
  const std::string range = number_text(kLongestServoPeriod) + " to 10 s";
  if (heartbeat == 0) table.fail("heartbeat", "0, but without it drives continue when the EDP dies", range);
  if (heartbeat < kLongestServoPeriod)
    table.fail("heartbeat", number_text(heartbeat) + " s is below a servo period", range);
  return heartbeat;
}

/// Onto the switch and off it, like the robot's own synchronisation: methods 3 and 5 use the first zero pulse off a
/// switch that is closed up to the positive, or the negative, end of the drive's counts. An axis without a switch has
/// no default method: homing at the present position must be requested explicitly.
DriveHoming read_homing(const Table& table, const AxisParameters& axis, bool reversed) {
  DriveHoming homing;
  if (axis.synchro_coarse == 0 && !table.has("homing_method")) return homing;
  const auto method = table.integer_or("homing_method", (axis.synchro_coarse > 0) != reversed ? 3 : 5, -128, 127);
  // CiA 402-2: the others are reserved
  if (method == 0 || method == 15 || method == 16 || method == 31 || method == 32 || method == 36 || method > 37)
    table.fail("homing_method", std::to_string(method) + " is not a homing method of CiA 402",
               "1 to 14, 17 to 30, 33 to 35, 37, or one of the maker's own below 0");
  homing.method = static_cast<std::int8_t>(method);
  homing.speed_switch = table.number_or("homing_speed_switch", std::abs(axis.synchro_coarse), {0, search_speed(axis)});
  homing.speed_zero = table.number_or("homing_speed_zero", std::abs(axis.synchro_fine), {0, search_speed(axis)});
  const bool to_a_switch = method > 0 && method <= 30;
  for (const auto& [key, speed, needed] : {std::tuple{"homing_speed_switch", homing.speed_switch, to_a_switch},
                                           {"homing_speed_zero", homing.speed_zero, method > 0 && method <= 34}})
    if (needed && speed == 0)
      table.fail(key, "0, but homing method " + std::to_string(method) + " moves the axis", "a speed, rad/s");
  return homing;
}

double read_units(const Table& table, const AxisParameters& axis) {
  const double units = table.number_or("units_per_turn", axis.encoder_increments, {1, 1e9});
  const double turns = std::max(std::abs(axis.motor_min), std::abs(axis.motor_max)) / (2 * std::numbers::pi);
  if (std::isfinite(turns) && turns * units > kGreatestPosition)
    table.fail("units_per_turn", number_text(units) + " make the shaft's range longer than 32 bits",
               "at most " + std::to_string(std::lround(std::floor(kGreatestPosition / turns))) +
                   " for its motor_min and motor_max");
  return units;
}

/// With a speed that becomes 0 the drive would never reach its switch.
void check_homing_speed(const Table& table, const std::string& key, double speed, double units_per_turn) {
  if (speed == 0 || speed * units_per_turn / (2 * std::numbers::pi) >= 0.5) return;
  table.fail(
      table.has(key) ? key : "velocity_units_per_turn",
      (table.has(key) ? "" : key + " ") + number_text(speed) + " rad/s is less than half a velocity unit of the drive",
      "at least " + number_text(std::ceil(1e3 * std::numbers::pi / units_per_turn) / 1e3) + " rad/s, or finer units");
}

double read_velocity_units(const Table& table, const DriveEntry& drive) {
  const double units = table.number_or("velocity_units_per_turn", std::abs(drive.units_per_turn), {1, 1e9});
  check_homing_speed(table, "homing_speed_switch", drive.homing.speed_switch, units);
  check_homing_speed(table, "homing_speed_zero", drive.homing.speed_zero, units);
  return std::copysign(units, drive.units_per_turn);
}

double read_rated_current(const Table& table, const AxisParameters& axis) {
  const double rated = table.number("rated_current", {1e-3, 1e4});
  const double least = axis.current_max / kGreatestCurrentRatio, greatest = axis.current_max / kLeastCurrentRatio;
  if (rated < least || rated > greatest)
    table.fail("rated_current",
               number_text(rated) + " A does not fit current_max " + number_text(axis.current_max) + " A of the axis",
               expected_number({least, greatest}) + " (A, not mA)");
  return rated;
}

DriveEntry read_drive(const Table& table, const AxisParameters& axis, DriveMode mode) {
  DriveEntry drive;
  drive.axis = axis.name;
  read_address(table, drive);
  drive.units_per_turn = read_units(table, axis);
  if (table.boolean_or("reversed", false)) drive.units_per_turn = -drive.units_per_turn;
  drive.rated_current = read_rated_current(table, axis);
  if (mode == DriveMode::cyclic_velocity)
    drive.position_gain = table.number("position_gain", {0, 1e4});
  else if (table.has("position_gain"))
    table.fail("position_gain", "a drive that gets no velocity", "mode = \"velocity\", or no such key");
  drive.homing = read_homing(table, axis, drive.units_per_turn < 0);
  drive.velocity_units_per_turn = read_velocity_units(table, drive);
  return drive;
}

/// The drive of each axis. A misspelt name is reported before its consequences.
std::vector<const Table*> by_axis(const Table& file, const std::vector<Table>& tables, const RobotParameters& robot) {
  std::vector<std::string> names;
  for (const AxisParameters& axis : robot.axes) names.push_back(axis.name);
  std::vector<const Table*> sorted(names.size(), nullptr);
  for (const Table& table : tables) {
    table.only({"axis", "node", "channel", "first_pdo", "pdo_node", "units_per_turn", "velocity_units_per_turn",
                "reversed", "rated_current", "position_gain", "homing_method", "homing_speed_switch",
                "homing_speed_zero", "objects"});
    const std::string name = table.choice("axis", names);
    const Table*& place = sorted[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    if (place != nullptr) table.fail("axis", in_quotes(name) + " has an earlier drive", "one drive for each axis");
    place = &table;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (sorted[i] == nullptr) file.fail("drives", "no drive of axis " + in_quotes(names[i]), "one for each axis");
  return sorted;
}

/// Identifiers beside the predefined one are those of the EMCY of nodes that the bus does not have.
std::uint32_t read_sync(const Table& table, const DriveTable& drives) {
  const auto sync =
      static_cast<std::uint32_t>(table.integer_or("sync", drives.sync, canopen::kSync, canopen::kLastSync));
  const canopen::ObjectEntry* const entry = drives.eds.find(canopen::kSyncIdentifier);
  if (sync != canopen::kSync && (entry == nullptr || !entry->writable()))
    table.fail("sync",
               std::to_string(sync) + ", but the drives have no identifier of the SYNC that can be written (1005h)",
               "128, or drives that have it");
  return sync;
}

/// The framework's EDS file describes one axis, and stands for each axis of a drive.
void extend_general_eds(const Table& file, const std::vector<const Table*>& tables, DriveTable& drives) {
  if (file.text("eds") != kGeneralDriveEds) return;
  for (const Table* table : tables) {
    DriveEntry drive;
    read_address(*table, drive);
    if (drive.channel != 1) drives.eds.repeat_axis(drive.channel, drive.first_pdo);
  }
}

/// The settings of the PDOs that the EDP sets up for the axes of a node; those of the first axis are checked before.
void check_pdos(const Table& table, const DriveEntry& drive, const std::vector<NodeSetting>& own) {
  for (const NodeSetting& setting : own)
    for (const int first : {int{canopen::kReceivePdoParameters}, int{canopen::kReceivePdoMapping},
                            int{canopen::kTransmitPdoParameters}, int{canopen::kTransmitPdoMapping}})
      if (const int offset = setting.object.index - first - drive.first_pdo + 1; offset == 0 || offset == 1)
        table.table("objects").fail(setting.name, "is of a PDO that the EDP sets up itself",
                                    "an object that it leaves alone");
}

/// Of all drives: to those of a node that has several axes, the objects common to them are written once.
std::vector<NodeSetting> settings_of(const DriveEntry& drive, bool first, const std::vector<NodeSetting>& common,
                                     const std::vector<NodeSetting>& own) {
  std::vector<NodeSetting> all;
  for (const NodeSetting& setting : common)
    if (first || canopen::is_of_profile(setting.object)) all.push_back(setting);
  all.insert(all.end(), own.begin(), own.end());
  for (NodeSetting& setting : all) setting.object = of_channel(setting.object, drive.channel);
  return all;
}

void read_drives(const Table& file, const RobotParameters& robot, DriveTable& drives) {
  const std::vector<Table> tables = file.tables("drives");
  const CheckObject check = check_drive_object(drives.absolute_encoders);
  std::vector<NodeSetting> common;
  read_settings(file, drives.eds, check, common);
  const std::vector<const Table*> sorted = by_axis(file, tables, robot);
  extend_general_eds(file, sorted, drives);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    DriveEntry drive = read_drive(*sorted[i], robot.axes[i], drives.mode);
    check_address(*sorted[i], drive, drives);
    std::vector<NodeSetting> own;
    read_settings(*sorted[i], drives.eds, check, own);
    if (drive.channel != 1) check_pdos(*sorted[i], drive, own);
    drives.drives.push_back(std::move(drive));
    DriveEntry& added = drives.drives.back();
    added.settings = settings_of(added, drives.is_first_of_node(added), common, own);
  }
}

}  // namespace

bool DriveTable::is_first_of_node(const DriveEntry& drive) const noexcept {
  const auto first = std::find_if(drives.begin(), drives.end(),
                                  [&drive](const DriveEntry& other) { return other.node == drive.node; });
  return first != drives.end() && first->channel == drive.channel;
}

std::size_t DriveTable::nodes() const noexcept {
  return static_cast<std::size_t>(
      std::count_if(drives.begin(), drives.end(), [this](const DriveEntry& drive) { return is_first_of_node(drive); }));
}

DriveTable read_drive_table(const std::filesystem::path& file, const RobotParameters& robot) {
  const Table table = Table::load(file);
  table.only({"eds", "mode", "absolute_encoders", "master", "sync", "heartbeat", "answer_time", "missed_max",
              "switch_on_time", "set_points", "status_every", "objects", "drives"});
  DriveTable drives;
  drives.file = file;
  drives.mode = read_mode(table);
  drives.absolute_encoders = table.boolean_or("absolute_encoders", false);
  drives.master = static_cast<canopen::NodeId>(table.integer_or("master", drives.master, 1, canopen::kMaxNode));
  drives.heartbeat = read_heartbeat(table, drives.heartbeat);
  drives.answer_time = table.number_or("answer_time", drives.answer_time, {0.05, 0.9});
  drives.missed_max = static_cast<int>(table.integer_or("missed_max", drives.missed_max, 0, 100));
  drives.switch_on_time = table.number_or("switch_on_time", drives.switch_on_time, {0.1, 60});
  // otherwise a loop that is closed here would have one more tick of delay
  const std::string usual = drives.mode == DriveMode::cyclic_torque ? "at once" : "at sync";
  drives.target_at_sync =
      (table.has("set_points") ? table.choice("set_points", {"at sync", "at once"}) : usual) == "at sync";
  drives.status_every = static_cast<int>(table.integer_or("status_every", drives.status_every, 1, 240));
  drives.eds = read_drive_eds(table, drives.mode);
  drives.sync = read_sync(table, drives);
  read_drives(table, robot, drives);
  return drives;
}

}  // namespace mrroc::config
