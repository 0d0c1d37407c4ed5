#include "robots/polycrank/geometry_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/robot_parameters_file.hpp"

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

}  // namespace

Geometry read_geometry(const config::Table& table) {
  Geometry geometry;
  geometry.offsets = read<kAxes>(table, "offsets", kLength);
  geometry.shoulder_cranks = read_cranks(table, "shoulder_cranks");
  geometry.elbow_cranks = read_cranks(table, "elbow_cranks");
  geometry.gears = read<kAxes>(table, "gears");
  if (std::ranges::find(geometry.gears, 0.0) != geometry.gears.end()) {
    table.fail("gears", "0 is not a gear ratio", "rad of the motor per rad of the joint, its sign included");
  }
  geometry.tool = config::read_tool(table);
  table.finish();
  return geometry;
}

}  // namespace mrroc::polycrank
