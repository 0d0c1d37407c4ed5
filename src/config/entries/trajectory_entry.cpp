#include "config/entries/trajectory_entry.hpp"

#include <span>
#include <vector>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

using Order = JointTrajectory::Order;

constexpr const char* kValues[] = {"positions", "velocities", "accelerations"};
constexpr Range kTolerance{.min = 0};

Order order_of(const Table& point) {
  if (!point.has("velocities")) {
    if (point.has("accelerations"))
      point.fail("accelerations", "is given without velocities", "both, or positions alone");
    return Order::positions;
  }
  return point.has("accelerations") ? Order::accelerations : Order::velocities;
}

void append(std::string& text, const char* key, std::span<const double> numbers) {
  text += key;
  text += " = [";
  for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : ", ") + number_text(numbers[i]);
  text += "]";
}

template <class Number>
std::vector<double> each_axis(std::size_t axes, Number number) {
  std::vector<double> numbers;
  for (std::size_t axis = 0; axis < axes; ++axis) numbers.push_back(number(axis));
  return numbers;
}

}  // namespace

std::shared_ptr<const JointTrajectory> read_trajectory(const Table& table, std::size_t axes) {
  const std::vector<Table> points = table.tables("points");
  if (points.empty() || points.size() > JointTrajectory::kMostPoints)
    table.fail("points", std::to_string(points.size()) + " of them",
               "1 to " + std::to_string(JointTrajectory::kMostPoints));
  const Order order = order_of(points.front());
  auto trajectory = std::make_shared<JointTrajectory>(axes, order, points.size());
  double before = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Table& point = points[i];
    point.only({"time", "positions", "velocities", "accelerations"});
    if (order_of(point) != order) point.fail("positions", "has other keys beside it than point 0", "the same keys");
    const double time = point.number("time", {0, 1e6});
    if (i > 0 && time <= before) point.fail("time", number_text(time), "above " + number_text(before));
    before = time;
    std::vector<double> values;
    for (int key = 0; key < static_cast<int>(order); ++key) {
      const std::vector<double> given = point.numbers(kValues[key], axes);
      values.insert(values.end(), given.begin(), given.end());
    }
    trajectory->set_point(i, time, values);
  }
  const std::vector<double> none(axes, 0.0);
  trajectory->set_tolerances(table.optional_numbers("path_tolerance", axes, kTolerance).value_or(none),
                             table.optional_numbers("goal_tolerance", axes, kTolerance).value_or(none),
                             table.number_or("goal_time_tolerance", 0, kTolerance));
  if (const char* const problem = trajectory->problem(axes))
    table.fail("points", problem, "a trajectory that ends at rest");
  return trajectory;
}

std::shared_ptr<const JointTrajectory> load_trajectory(const std::filesystem::path& file, std::size_t axes) {
  const Table table = Table::load(file);
  table.only({"points", "path_tolerance", "goal_tolerance", "goal_time_tolerance"});
  return read_trajectory(table, axes);
}

std::string text_of(const JointTrajectory& t) {
  std::string text;
  append(text, "path_tolerance", each_axis(t.axes(), [&](std::size_t axis) { return t.path_tolerance(axis); }));
  append(text, "\ngoal_tolerance", each_axis(t.axes(), [&](std::size_t axis) { return t.goal_tolerance(axis); }));
  text += "\ngoal_time_tolerance = " + number_text(t.goal_time()) + "\npoints = [\n";
  for (std::size_t point = 0; point < t.points(); ++point) {
    text += "  {time = " + number_text(t.time(point));
    append(text, ", positions", each_axis(t.axes(), [&](std::size_t axis) { return t.position(point, axis); }));
    if (t.order() != Order::positions)
      append(text, ", velocities", each_axis(t.axes(), [&](std::size_t axis) { return t.velocity(point, axis); }));
    if (t.order() == Order::accelerations)
      append(text, ", accelerations",
             each_axis(t.axes(), [&](std::size_t axis) { return t.acceleration(point, axis); }));
    text += "},\n";
  }
  return text + "]\n";
}

}  // namespace mrroc::config
