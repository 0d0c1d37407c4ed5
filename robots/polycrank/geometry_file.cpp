#include "robots/polycrank/geometry_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace mrroc::polycrank {
namespace {

constexpr config::Range kLength{-10, 10};
constexpr double kShortestCrank = 0.001;  // m

template <std::size_t size>
std::array<double, size> read(const config::Table& table, std::string_view key, config::Range range = {}) {
  std::array<double, size> values{};
  std::ranges::copy(table.numbers(key, size, range), values.begin());
  return values;
}

std::array<double, 2> read_cranks(const config::Table& table, std::string_view key) {
  const auto cranks = read<2>(table, key, kLength);
  if (std::abs(cranks[0]) < kShortestCrank || std::abs(cranks[1]) < kShortestCrank) {
    table.fail(key, "a crank without length cannot reach anything", "two lengths of at least 0.001 m, of either sign");
  }
  return cranks;
}

Pose read_tool(const config::Table& table) {
  const auto translation = read<3>(table, "tool_translation", kLength);
  const auto rotation = read<3>(table, "tool_rotation", {-2 * std::numbers::pi, 2 * std::numbers::pi});
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
  geometry.offsets = read<kAxes>(table, "offsets", kLength);
  geometry.shoulder_cranks = read_cranks(table, "shoulder_cranks");
  geometry.elbow_cranks = read_cranks(table, "elbow_cranks");
  geometry.gears = read<kAxes>(table, "gears");
  if (std::ranges::find(geometry.gears, 0.0) != geometry.gears.end()) {
    table.fail("gears", "0 is no gear", "rad of the motor per rad of the joint, its sign included");
  }
  geometry.tool = read_tool(table);
  table.finish();
  return geometry;
}

}  // namespace mrroc::polycrank
