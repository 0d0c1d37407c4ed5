#include "cli/ros2/event_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrroc::cli {

std::vector<double> numbers_of(const nlohmann::ordered_json& event, std::string_view name) {
  std::vector<double> values;
  const auto found = event.find(name);
  if (found == event.end() || !found->is_array()) return values;
  for (const auto& value : *found)
    values.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
  return values;
}

Pose pose_of(const nlohmann::ordered_json& event, std::string_view name) {
  const std::vector<double> values = numbers_of(event, name);
  Pose pose = Pose::Identity();
  if (values.size() != 7 || !std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    return pose;
  const Eigen::Quaterniond rotation(values[6], values[3], values[4], values[5]);
  if (!(rotation.norm() > 0.5)) return pose;
  pose.translation() = Eigen::Vector3d(values[0], values[1], values[2]);
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

}  // namespace mrroc::cli
