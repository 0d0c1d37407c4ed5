#include "config/entries/robot_entry.hpp"

#include <algorithm>
#include <array>

#include "config/axis_file.hpp"
#include "config/entries/can_entry.hpp"
#include "config/entries/driver_entry.hpp"
#include "config/entries/named_file.hpp"
#include "config/network/hosts.hpp"
#include "config/resources.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/text/message_text.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::config {

namespace {

DriverEntry read_hardware(const Table& table, const RobotEntry& robot, const Deployment& deployment) {
  table.choice("hardware", robot_drivers());
  DriverEntry driver = read_driver(table, "hardware", robot.name, robot.type, robot.host, deployment);
  if (robot.host == deployment.here) driver.library = require_library(table, "hardware", "drivers", driver.name);
  return driver;
}

/// Whether the drives' absolute positions are known from the start. If not, every axis must have a switch to find its
/// position, or a drive with its own homing.
bool read_synchronised(const Table& table, const RobotEntry& robot) {
  if (table.boolean_or("synchronised", true)) return true;
  if (robot.driver.name == "socketcan") return false;
  const RobotParameters parameters = read_robot_parameters(Table::load(robot.files().parameters));
  for (const AxisParameters& axis : parameters.axes) {
    if (axis.synchro_coarse != 0) continue;
    table.fail(
        "synchronised",
        "false, but axis " + in_quotes(axis.name) + " of " + robot.type + " has no switch to find its position by",
        "true (leave the key out)");
  }
  return false;
}

Pose read_base(const Table& table) {
  const std::vector<double> none(3, 0.0);
  const auto position = table.optional_numbers("position", 3).value_or(none);
  const auto rotation = table.optional_numbers("rotation", 3).value_or(none);
  return pose_from_rpy(Eigen::Vector3d(position.data()), Eigen::Vector3d(rotation.data()));
}

/// `base_position`, `base_rotation`: as measured.
std::optional<Pose> read_measured_base(const Table& table, const RobotEntry& robot) {
  const auto position = table.optional_numbers("base_position", 3);
  const auto rotation = table.optional_numbers("base_rotation", 3);
  if (rotation && !position) table.fail("base_rotation", "alone", "base_position beside it");
  if (position && !rotation) table.fail("base_position", "alone", "base_rotation beside it");
  if (!position) return std::nullopt;
  if (!robot.mount.empty())
    table.fail("base_position", "of a robot that " + in_quotes(robot.mount) + " carries: its base moves",
               "the key of a robot that is fixed in the world");
  return pose_from_rpy(Eigen::Vector3d(position->data()), Eigen::Vector3d(rotation->data()));
}

/// `joint_zeros`; three numbers for each axis: `joint_gears`, `link_positions`, `link_rotations`.
MeasuredArm read_measured_arm(const Table& table, const RobotEntry& robot) {
  constexpr Range kZero{-0.2, 0.2}, kGear{-0.05, 0.05}, kPosition{-0.05, 0.05}, kRotation{-0.1, 0.1};
  constexpr std::array kKeys{"joint_zeros", "joint_gears", "link_positions", "link_rotations"};
  MeasuredArm measured;
  if (std::none_of(kKeys.begin(), kKeys.end(), [&](const char* key) { return table.has(key); })) return measured;
  const std::size_t axes = read_robot_parameters(Table::load(robot.files().parameters)).axes.size();
  if (const auto zeros = table.optional_numbers("joint_zeros", axes, kZero))
    measured.zeros = Eigen::Map<const Eigen::VectorXd>(zeros->data(), std::ssize(*zeros));
  if (const auto gears = table.optional_numbers("joint_gears", 3 * axes, kGear))
    for (std::size_t i = 0; i < axes; ++i) measured.gears.emplace_back(gears->data() + 3 * i);
  const auto positions = table.optional_numbers("link_positions", 3 * axes, kPosition);
  const auto rotations = table.optional_numbers("link_rotations", 3 * axes, kRotation);
  if (rotations && !positions) table.fail("link_rotations", "alone", "link_positions beside it");
  if (positions && !rotations) table.fail("link_positions", "alone", "link_rotations beside it");
  if (!positions) return measured;
  if (axes != 6)
    table.fail("link_positions", "the robot has " + std::to_string(axes) + (axes == 1 ? " axis" : " axes"),
               "a robot with 6");
  for (std::size_t i = 0; i < axes; ++i) {
    Twist& link = measured.links.emplace_back();
    link << Eigen::Vector3d(positions->data() + 3 * i), Eigen::Vector3d(rotations->data() + 3 * i);
  }
  return measured;
}

void read_force(const Table& table, RobotEntry& robot) {
  robot.force_sensor = table.optional_text("force_sensor").value_or("");
  for (const auto& [key, first] : {std::pair{"force_limit", 0}, {"torque_limit", 3}}) {
    if (!table.has(key)) continue;
    if (robot.force_sensor.empty()) table.fail(key, "a robot without a force sensor", "force_sensor beside it");
    const auto limits = *table.optional_numbers(key, 3, {0, 1e6});
    robot.force_limits.segment<3>(first) = Eigen::Map<const Eigen::Vector3d>(limits.data());
  }
}

/// `load = { mass = 2.0, centre = [0, 0, 0.1] }`; the robot must have the numbers that its limits then depend on.
Load read_load(const Table& table, const RobotEntry& robot) {
  const auto entry = table.optional_table("load");
  if (!entry) return {};
  const RobotParameters parameters = read_robot_parameters(Table::load(robot.files().parameters));
  Load load{entry->number("mass", {0, parameters.load_max}), Eigen::Vector3d::Zero()};
  if (const auto centre = entry->optional_numbers("centre", 3, {-10, 10}))
    load.centre = Eigen::Map<const Eigen::Vector3d>(centre->data());
  entry->finish();
  for (const AxisParameters& axis : parameters.axes)
    if (!(axis.inertia_max > 0))
      table.fail("load", "axis " + in_quotes(axis.name) + " of " + robot.type + " has no key 'inertia'",
                 "the inertia of every axis in " + robot.files().parameters.string());
  return load;
}

/// Designed regulators have numbers for one length of the tick.
void check_period(const Table& table, const Table& parameters, const Deployment& deployment) {
  const DriveParameters drives = read_drives(parameters);
  if (drives.regulate_themselves() || !(drives.bandwidth > 0) || deployment.servo_period == kRegulatorPeriod) return;
  table.fail("type",
             "its regulators are designed for another servo_period than " + number_text(deployment.servo_period) + " s",
             number_text(kRegulatorPeriod) + " s");
}

}  // namespace

RobotEntry read_robot(const Table& table, const std::string& name, const Deployment& deployment) {
  allow_driver_tables(table, "robot", robot_drivers());
  table.only({"type",         "parameters",     "program",      "hardware",       "host",
              "mount",        "position",       "rotation",     "base_position",  "base_rotation",
              "synchronised", "emergency_stop", "force_sensor", "force_limit",    "torque_limit",
              "load",         "joint_zeros",    "joint_gears",  "link_positions", "link_rotations"});
  RobotEntry robot;
  robot.name = name;
  robot.type = table.choice("type", robot_types());
  if (table.has("parameters")) robot.parameters = find_parameters(table, robot.type);
  robot.host = read_host(table, deployment);
  robot.driver = read_hardware(table, robot, deployment);
  robot.mount = table.optional_text("mount").value_or("");
  robot.base = read_base(table);
  robot.measured_base = read_measured_base(table, robot);
  robot.synchronised = read_synchronised(table, robot);
  read_can(table, deployment, robot);
  if (table.has("emergency_stop"))
    robot.emergency_stop = static_cast<int>(table.integer("emergency_stop", 0, ControllerIo::kDigital - 1));
  read_force(table, robot);
  robot.load = read_load(table, robot);
  robot.measured_arm = read_measured_arm(table, robot);
  robot.program = table.optional_text("program").value_or(robot.program);
  const Table parameters = Table::load(robot.files().parameters);
  robot.edp_program = parameters.optional_text("edp").value_or(robot.type + "_edp");
  check_period(table, parameters, deployment);
  const bool here = robot.host == deployment.here;
  // the runner asks the programs for their behaviours when the MP runs a state machine
  if (here || (deployment.here.empty() && !deployment.mp.states.empty()))
    robot.program = require_program(table, "program", robot.program);
  if (here) robot.edp_program = require_program(table, "type", robot.edp_program);
  return robot;
}

}  // namespace mrroc::config
