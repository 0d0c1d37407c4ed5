#include "sensors/camera/detection/make_detector.hpp"

#include <array>
#include <string>

#include "sensors/camera/detection/blob_detector.hpp"
#include "sensors/camera/detection/marker_detector.hpp"
#include "sensors/camera/detection/marker_dictionary.hpp"
#include "sensors/camera/keys.hpp"
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

std::unique_ptr<Detector> make_detector(const config::SensorEntry& entry) {
  const std::string& detect = text(entry, "detect");
  if (detect == "blob") return make_blob_detector(entry);
  if (detect == "marker") return make_marker_detector(entry);
  refuse(entry, "detect", "\"" + detect + "\"", "blob or marker");
}

}  // namespace mrroc::vsp
