#include "robots/irb6/geometry_file.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace mrroc::irb6 {
namespace {

constexpr config::Range kLength{0.001, 10};

double gear(const config::Table& table, std::string_view key) {
  const double value = table.number(key);
  if (value == 0) table.fail(key, "0 is no gear", "rad of the motor per rad or m, its sign included");
  return value;
}

ScrewGeometry read_screw(const config::Table& table) {
  ScrewGeometry screw;
  screw.gear = gear(table, "gear");
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
  return screw;
}

Pose read_tool(const config::Table& table) {
  const auto translation = table.numbers("tool_translation", 3, {-10, 10});
  const auto rotation = table.numbers("tool_rotation", 3, {-2 * std::numbers::pi, 2 * std::numbers::pi});
  Pose tool = Pose::Identity();
  tool.translation() << translation[0], translation[1], translation[2];
  tool.linear() = (Eigen::AngleAxisd(rotation[2], Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rotation[1], Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rotation[0], Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return tool;
}

}  // namespace

Geometry read_geometry(const config::Table& table) {
  Geometry geometry;
  geometry.lower_arm = table.number("lower_arm", kLength);
  geometry.upper_arm = table.number("upper_arm", kLength);
  geometry.wrist = table.number("wrist", kLength);
  geometry.tool = read_tool(table);
  geometry.column_gear = gear(table, "column_gear");
  geometry.wrist_pitch_gear = gear(table, "wrist_pitch_gear");
  geometry.wrist_roll_gear = gear(table, "wrist_roll_gear");
  geometry.tool_roll_gear = gear(table, "tool_roll_gear");
  geometry.lower_arm_screw = read_screw(table.table("lower_arm_screw"));
  geometry.upper_arm_screw = read_screw(table.table("upper_arm_screw"));
  table.finish();
  return geometry;
}

}  // namespace mrroc::irb6
