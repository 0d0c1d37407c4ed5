#include "robots/irb6/geometry_file.hpp"

#include <cmath>
#include <numbers>

#include "config/robot_parameters_file.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::irb6 {
namespace {

constexpr config::Range kLength{0.001, 10};
constexpr config::Range kAngle{-2 * std::numbers::pi, 2 * std::numbers::pi};

double gear(const config::Table& table, std::string_view key) {
  const double value = table.number(key);
  if (value == 0) table.fail(key, "0 is not a gear ratio", "rad of the motor per rad or m, its sign included");
  return value;
}

void read_linkage(const config::Table& table, ScrewGeometry& screw) {
  screw.squares = table.number("squares", {1e-6, 100});
  screw.cosine = table.number("cosine");
  screw.sine = table.number("sine");
  screw.synchro_length = table.number("synchro_length", kLength);
  const double swing = std::hypot(screw.cosine, screw.sine);
  if (!(swing > 0 && swing < screw.squares)) {
    table.fail("squares", "the screw's length is not positive at every angle",
               "a number above hypot(cosine, sine) = " + std::to_string(swing) + " that is above 0");
  }
  table.finish();
}

ScrewGeometry read_screw(const config::Table& table) {
  ScrewGeometry screw;
  screw.gear = gear(table, "gear");
  read_linkage(table, screw);
  return screw;
}

/// The arm turns back where the screw is longest and shortest: no motor position may bring it there.
void check_reach(const config::Table& table, const ScrewGeometry& screw, double zero, const AxisParameters& axis) {
  const double swing = std::hypot(screw.cosine, screw.sine);
  const double shortest = std::sqrt(screw.squares - swing), longest = std::sqrt(screw.squares + swing);
  for (const double motor : {axis.motor_min, axis.motor_max}) {
    const double length = (motor - zero) / screw.gear + screw.synchro_length;
    if (length > shortest && length < longest) continue;
    table.fail("synchro_length",
               "the screw is " + config::number_text(length) + " m long with the motor of axis " +
                   config::in_quotes(axis.name) + " at its limit, " + config::number_text(motor) + " rad",
               "a length between the dead centres of the linkage, " + config::number_text(shortest) + " and " +
                   config::number_text(longest) + " m");
  }
}

void read_lengths(const config::Table& table, Geometry& geometry) {
  geometry.lower_arm = table.number("lower_arm", kLength);
  geometry.upper_arm = table.number("upper_arm", kLength);
  geometry.wrist = table.number("wrist", kLength);
}

Geometry read_nominal(const config::Table& table, const JointVector& synchro) {
  Geometry geometry;
  read_lengths(table, geometry);
  geometry.tool = config::read_tool(table);
  geometry.column_gear = gear(table, "column_gear");
  geometry.wrist_pitch_gear = gear(table, "wrist_pitch_gear");
  geometry.wrist_roll_gear = gear(table, "wrist_roll_gear");
  if (synchro.size() == 6) geometry.tool_roll_gear = gear(table, "tool_roll_gear");
  geometry.lower_arm_screw = read_screw(table.table("lower_arm_screw"));
  geometry.upper_arm_screw = read_screw(table.table("upper_arm_screw"));
  geometry.zero = synchro;
  table.finish();
  return geometry;
}

Geometry read_variant(const config::Table& table, const Geometry& nominal) {
  Geometry geometry = nominal;
  read_lengths(table, geometry);
  read_linkage(table.table("lower_arm_screw"), geometry.lower_arm_screw);
  read_linkage(table.table("upper_arm_screw"), geometry.upper_arm_screw);
  const auto synchro = table.numbers("synchro", static_cast<std::size_t>(nominal.zero.size()));
  geometry.zero = Eigen::Map<const Eigen::VectorXd>(synchro.data(), nominal.zero.size());
  // an axis that is not at angle 0 there has its zero that much further back
  geometry.zero[0] -= geometry.column_gear * table.number("column_offset", kAngle);
  geometry.zero[4] -= geometry.wrist_roll_gear * table.number("wrist_roll_offset", kAngle);
  if (geometry.zero.size() == 6) {
    geometry.zero[5] -= geometry.tool_roll_gear * table.number("tool_roll_offset", kAngle);
  }
  table.finish();
  return geometry;
}

}  // namespace

RobotParameters read_parameters(const config::Table& file, int count) {
  auto parameters = config::read_robot_parameters(file);
  if (parameters.axes.size() != static_cast<std::size_t>(count)) {
    file.fail("axes", std::to_string(parameters.axes.size()) + " axes", std::to_string(count) + " axes");
  }
  return parameters;
}

std::vector<NamedGeometry> read_models(const config::Table& file, const RobotParameters& parameters, int column) {
  const auto axes = static_cast<Eigen::Index>(parameters.axes.size());
  JointVector synchro(axes - column);
  for (Eigen::Index i = column; i < axes; ++i) {
    synchro[i - column] = parameters.axes[static_cast<std::size_t>(i)].motor_synchro;
  }
  const auto check_screws = [&](const config::Table& table, const Geometry& geometry) {
    const auto arm = parameters.axes.begin() + column;
    check_reach(table.table("lower_arm_screw"), geometry.lower_arm_screw, geometry.zero[1], arm[1]);
    check_reach(table.table("upper_arm_screw"), geometry.upper_arm_screw, geometry.zero[2], arm[2]);
  };
  const Geometry nominal = read_nominal(file.table("geometry"), synchro);
  check_screws(file.table("geometry"), nominal);
  std::vector<NamedGeometry> models{{"nominal", nominal}};
  if (const auto variants = file.optional_table("models")) {
    for (const std::string& name : variants->table_names()) {
      if (name == "nominal" || name.size() > kNameLength) {
        variants->fail(name, "\"" + name + "\" is not a valid name for another model",
                       "at most " + std::to_string(kNameLength) + " characters, not \"nominal\"");
      }
      models.push_back({name, read_variant(variants->table(name), nominal)});
      check_screws(variants->table(name), models.back().geometry);
    }
  }
  file.optional_table("description");  // the URDF and the MJCF are written from it, by describe.py
  return models;
}

}  // namespace mrroc::irb6
