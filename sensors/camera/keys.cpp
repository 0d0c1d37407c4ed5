#include "sensors/camera/keys.hpp"

#include <cmath>

#include "geometry/rigid_motion.hpp"
#include "sensors/camera/detection/blob_detector.hpp"
#include "sensors/camera/detection/marker_detector.hpp"
#include "sensors/camera/detection/marker_dictionary.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

std::array<double, 2> range(const config::SensorEntry& entry, const std::string& key) {
  const auto numbers = optional_numbers(entry, key, 2).value_or(std::vector<double>{0, 0});
  return {numbers[0], numbers[1]};
}

std::array<double, 2> rising_range(const config::SensorEntry& entry, const std::string& key) {
  const auto [from, to] = range(entry, key);
  if (from > to) refuse(entry, key, std::to_string(from) + " to " + std::to_string(to), "from at most to");
  return {from, to};
}

std::unique_ptr<Detector> make_blob_detector(const config::SensorEntry& entry) {
  const ColourRange colour{range(entry, "hue"), rising_range(entry, "saturation"), rising_range(entry, "value")};
  const Eigen::Vector3d normal = vector3(entry, "plane_normal");
  if (!(normal.norm() > 1e-6)) refuse(entry, "plane_normal", "0", "a direction");
  return std::make_unique<BlobDetector>(colour, number(entry, "min_area"), vector3(entry, "plane"),
                                        normal.normalized());
}

std::unique_ptr<Detector> make_marker_detector(const config::SensorEntry& entry) {
  const std::string& name = text(entry, "dictionary");
  const auto dictionary = marker_dictionary(name);
  if (!dictionary) refuse(entry, "dictionary", "\"" + name + "\"", "one of " + listed(marker_dictionary_names()));
  const int marker = whole(entry, "marker");
  const int count = dictionary->bytesList.rows;
  if (marker >= count) {
    refuse(entry, "marker", std::to_string(marker), "0 to " + std::to_string(count - 1) + ", as dictionary " + name);
  }
  return std::make_unique<MarkerDetector>(dictionary, marker, number(entry, "marker_size"));
}

}  // namespace

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

std::optional<Pose> mount_pose(const config::SensorEntry& entry) {
  const auto position = optional_numbers(entry, "position", 3), rotation = optional_numbers(entry, "rotation", 3);
  if (rotation && !position) refuse(entry, "rotation", "a rotation alone", "the key 'position' beside it");
  if (!position) return std::nullopt;
  const Eigen::Vector3d turns = rotation ? Eigen::Vector3d{rotation->data()} : Eigen::Vector3d::Zero();
  return pose_from_rpy(Eigen::Vector3d{position->data()}, turns);
}

std::unique_ptr<Detector> make_detector(const config::SensorEntry& entry) {
  const std::string& detect = text(entry, "detect");
  if (detect == "blob") return make_blob_detector(entry);
  if (detect == "marker") return make_marker_detector(entry);
  refuse(entry, "detect", "\"" + detect + "\"", "blob or marker");
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace mrroc::vsp
