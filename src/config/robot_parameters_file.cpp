#include "config/robot_parameters_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/axis_file.hpp"
#include "config/resources.hpp"
#include "config/text/message_text.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::config {

namespace {

/// Refuses a second axis with the name of the last one.
void check_name_is_new(const std::vector<AxisParameters>& axes, const Table& table) {
  const auto& name = axes.back().name;
  const auto same_name = [&name](const AxisParameters& axis) { return axis.name == name; };
  if (std::any_of(axes.begin(), axes.end() - 1, same_name)) {
    table.fail("name", in_quotes(name) + " is the name of an earlier axis", "a unique name");
  }
}

/// Every axis once, by name; empty without the key.
std::vector<int> read_synchro_order(const Table& file, const std::vector<AxisParameters>& axes) {
  std::vector<int> order;
  if (!file.has("synchro_order")) return order;
  const std::string expected = "the names of all " + std::to_string(axes.size()) + " axes, each once";
  for (const std::string& name : file.texts("synchro_order")) {
    const auto axis = std::find_if(axes.begin(), axes.end(), [&name](const auto& a) { return a.name == name; });
    const auto index = static_cast<int>(axis - axes.begin());
    if (axis == axes.end() || std::find(order.begin(), order.end(), index) != order.end()) {
      file.fail("synchro_order", in_quotes(name) + (axis == axes.end() ? " is not an axis" : " is listed twice"),
                expected);
    }
    order.push_back(index);
  }
  if (order.size() != axes.size()) file.fail("synchro_order", std::to_string(order.size()) + " axes", expected);
  return order;
}

/// The axes with the regulator numbers of table `[regulators.NAME]`, whose sub-tables are axes.
RegulatorSet read_regulators(const Table& table, const std::string& name, const std::vector<AxisParameters>& axes) {
  RegulatorSet set{name, axes};
  for (const std::string& axis_name : table.table_names()) {
    const Table gains = table.table(axis_name);
    const auto axis =
        std::find_if(set.axes.begin(), set.axes.end(), [&](const auto& a) { return a.name == axis_name; });
    if (axis == set.axes.end()) gains.fail("", in_quotes(axis_name) + " is not an axis", "the name of one");
    if (axis->regulator_bandwidth > 0)  // the set's numbers cannot complete those that are not known yet
      for (const char* const key : {"a", "b0", "b1", "eps", "current_gain"}) gains.number(key);
    axis->regulator_bandwidth = 0;
    axis->regulator_a = gains.number_or("a", axis->regulator_a);
    axis->regulator_b0 = gains.number_or("b0", axis->regulator_b0);
    axis->regulator_b1 = gains.number_or("b1", axis->regulator_b1);
    axis->regulator_eps = gains.number_or("eps", axis->regulator_eps);
    axis->regulator_output_max = positive_or(gains, "output_max", axis->regulator_output_max);
    axis->regulator_current_gain = positive_or(gains, "current_gain", axis->regulator_current_gain);
    gains.finish();
  }
  return set;
}

std::vector<RegulatorSet> read_regulator_sets(const Table& file, const std::vector<AxisParameters>& axes) {
  std::vector<RegulatorSet> sets{{"standard", axes}};
  const auto table = file.optional_table("regulators");
  if (!table) return sets;
  for (const std::string& name : table->table_names()) {
    if (name == "standard") table->table(name).fail("", "the name of the axes' own numbers", "another name");
    sets.push_back(read_regulators(table->table(name), name, axes));
  }
  return sets;
}

constexpr Range kPlace{-10, 10};                                     // m, of a tool
constexpr Range kTurn{-2 * std::numbers::pi, 2 * std::numbers::pi};  // rad

/// Position and roll, pitch, yaw about the fixed axes x, y, z of each.
std::map<std::string, Pose> read_tools(const Table& file) {
  std::map<std::string, Pose> tools{{"flange", Pose::Identity()}};
  const auto table = file.optional_table("tools");
  if (!table) return tools;
  for (const std::string& name : table->keys()) {
    if (name == "flange") table->fail(name, "is the name of the flange frame itself", "another name");
    const std::vector<double> values = table->numbers(name, 6);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Range& range = i < 3 ? kPlace : kTurn;
      if (values[i] < range.min || values[i] > range.max)
        table->fail(name, number_text(values[i]) + " is out of range",
                    expected_number(range) + (i < 3 ? " (m)" : " (rad)"));
    }
    tools[name] = pose_from_rpy(Eigen::Vector3d(values.data()), Eigen::Vector3d(values.data() + 3));
  }
  return tools;
}

/// Joint positions within the limits of the axes.
JointVector read_posture(const Table& table, const std::string& key, const std::vector<AxisParameters>& axes) {
  const auto values = table.numbers(key, axes.size());
  JointVector posture(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < axes[i].position_min || values[i] > axes[i].position_max)
      table.fail(key, number_text(values[i]) + " is outside the limits of axis " + in_quotes(axes[i].name),
                 expected_number({axes[i].position_min, axes[i].position_max}));
    posture[static_cast<Eigen::Index>(i)] = values[i];
  }
  return posture;
}

}  // namespace

RobotParameters read_robot_parameters(const Table& file) {
  RobotParameters parameters;
  parameters.type = file.text("type");
  parameters.edp = file.optional_text("edp").value_or("");
  parameters.drives = read_drives(file);
  const auto tables = file.tables("axes");
  if (tables.empty() || tables.size() > kMaxJoints) {
    file.fail("axes", std::to_string(tables.size()) + " axes", "1 to " + std::to_string(kMaxJoints) + " axes");
  }
  for (const auto& table : tables) {
    parameters.axes.push_back(read_axis(table, parameters.drives));
    check_name_is_new(parameters.axes, table);
  }
  parameters.regulators = read_regulator_sets(file, parameters.axes);
  parameters.synchro_order = read_synchro_order(file, parameters.axes);
  parameters.home = read_posture(file, "home", parameters.axes);
  parameters.postures["home"] = parameters.home;
  if (const auto postures = file.optional_table("postures"))
    for (const std::string& name : postures->keys()) {
      if (name == "home") postures->fail(name, "is the name of the key 'home'", "another name");
      parameters.postures[name] = read_posture(*postures, name, parameters.axes);
    }
  parameters.tools = read_tools(file);
  parameters.load_max = positive_or(file, "load_max", parameters.load_max);
  return parameters;
}

Pose read_tool(const Table& geometry) {
  const auto translation = geometry.numbers("tool_translation", 3, kPlace);
  const auto rotation = geometry.numbers("tool_rotation", 3, kTurn);
  return pose_from_rpy(Eigen::Vector3d(translation.data()), Eigen::Vector3d(rotation.data()));
}

std::filesystem::path robot_file(const std::string& type, const std::string& name) {
  return type_file("robots", type, name);
}

}  // namespace mrroc::config
