#include "sensors/camera/keys.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

const std::string& text(const config::SensorEntry& entry, const std::string& key) {
  const auto found = entry.texts.find(key);
  if (found == entry.texts.end()) refuse(entry, key, "missing", "a text");
  return found->second;
}

int whole(const config::SensorEntry& entry, const std::string& key) {
  const double value = number(entry, key);
  if (value != std::floor(value) || value > 1e9) refuse(entry, key, std::to_string(value), "a whole number");
  return static_cast<int>(value);
}

std::optional<std::vector<double>> optional_numbers(const config::SensorEntry& entry, const std::string& key,
                                                    std::size_t size) {
  const auto found = entry.numbers.find(key);
  if (found == entry.numbers.end() || found->second.empty()) return std::nullopt;
  if (found->second.size() != size) {
    refuse(entry, key, std::to_string(found->second.size()) + " numbers", std::to_string(size));
  }
  return found->second;
}

namespace {

std::optional<Pose> mount_of(const config::SensorEntry& entry, const std::string& position_key,
                             const std::string& rotation_key) {
  const auto position = optional_numbers(entry, position_key, 3), rotation = optional_numbers(entry, rotation_key, 3);
  if (rotation && !position)
    refuse(entry, rotation_key, "a rotation alone", "the key '" + position_key + "' beside it");
  if (!position) return std::nullopt;
  const Eigen::Vector3d turns = rotation ? Eigen::Vector3d{rotation->data()} : Eigen::Vector3d::Zero();
  return pose_from_rpy(Eigen::Vector3d{position->data()}, turns);
}

}  // namespace

std::optional<Pose> mount_pose(const config::SensorEntry& entry) { return mount_of(entry, "position", "rotation"); }

std::optional<Pose> calibrated_mount(const config::SensorEntry& entry) {
  if (optional_numbers(entry, "mount_position", 3) && !optional_numbers(entry, "mount_rotation", 3))
    refuse(entry, "mount_position", "alone", "the key 'mount_rotation' beside it");
  return mount_of(entry, "mount_position", "mount_rotation");
}

std::optional<Intrinsics> given_intrinsics(const config::SensorEntry& entry) {
  const auto given = optional_numbers(entry, "intrinsics", 4);
  if (!given) return std::nullopt;
  if (!((*given)[0] > 0) || !((*given)[1] > 0)) refuse(entry, "intrinsics", "no focal length", "fx and fy above 0");
  Intrinsics camera{
      whole(entry, "width"), whole(entry, "height"), (*given)[0], (*given)[1], (*given)[2], (*given)[3], {}};
  if (const auto distortion = optional_numbers(entry, "distortion", 5))
    std::copy(distortion->begin(), distortion->end(), camera.distortion.begin());
  return camera;
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace mrroc::vsp
