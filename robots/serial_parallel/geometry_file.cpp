#include "robots/serial_parallel/geometry_file.hpp"

#include <numbers>
#include <string>

#include "config/robot_parameters_file.hpp"

namespace mrroc::serial_parallel {
namespace {

using std::numbers::pi;

constexpr config::Range kLength{0.001, 10};
constexpr config::Range kPlace{-10, 10};
constexpr config::Range kLean{0, pi / 2};
constexpr config::Range kPitch{-pi / 2, 0};

LegPoints read_points(const config::Table& table) {
  const LegPoints points{
      .a = table.number("a", kPlace), .b = table.number("b", kLength), .c = table.number("c", kPlace)};
  if (!(points.c > points.a)) table.fail("c", "leg C is not beside leg A", "a number above a");
  table.finish();
  return points;
}

PassiveLimits read_limits(const config::Table& table) {
  PassiveLimits limits;
  limits.ac_lean_max = table.number("ac_lean_max", kLean);
  limits.b_lean_max = table.number("b_lean_max", kLean);
  limits.b_lean_inner = table.number("b_lean_inner", {0, limits.b_lean_max});
  limits.b_pitch_min = table.number("b_pitch_min", kPitch);
  limits.b_pitch_min_when_lean = table.number("b_pitch_min_when_lean", {limits.b_pitch_min, 0});
  table.finish();
  return limits;
}

JointVector read_joints(const config::Table& table, std::string_view key) {
  const auto numbers = table.numbers(key, 6);
  return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(numbers.data());
}

}  // namespace

Geometry read_geometry(const config::Table& table) {
  Geometry geometry;
  geometry.base = read_points(table.table("base"));
  geometry.platform = read_points(table.table("platform"));
  geometry.platform_to_wrist = table.number("platform_to_wrist", kPlace);
  geometry.wrist_to_flange = table.number("wrist_to_flange", kPlace);
  geometry.limits = read_limits(table.table("passive_limits"));
  geometry.gears = read_joints(table, "gears");
  if ((geometry.gears.array() == 0).any()) {
    table.fail("gears", "0 is not a gear ratio", "rad of the motor per m or rad, its sign included");
  }
  geometry.synchro = read_joints(table, "synchro");
  geometry.tool = config::read_tool(table);
  table.finish();
  return geometry;
}

}  // namespace mrroc::serial_parallel
