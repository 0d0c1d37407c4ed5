#include "sensors/camera/configuration.hpp"

#include "vsp/configuration.hpp"

namespace mrroc::vsp {

namespace {

constexpr int kLeastRegion = 16;         // px, as of a picture
constexpr double kMostMarkers = 100000;  // in a dictionary; which there are, the detector checks
constexpr double kMostDistance = 100;    // m

std::vector<double> list(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void check_pair(const char* what, const Eigen::Vector2d& range, double most, const char* unit) {
  for (const double bound : range) check_configured("LookForColour", what, bound, 0, most, unit);
}

}  // namespace

config::SensorEntry with(config::SensorEntry entry, const LookFor& marker) {
  check_configured("LookFor", "marker", marker.marker, 0, kMostMarkers, "(a marker of the dictionary)");
  check_configured("LookFor", "size", marker.size, 0.001, 10, "m");
  entry.texts["detect"] = "marker";
  if (!marker.dictionary.view().empty()) entry.texts["dictionary"] = marker.dictionary.view();
  entry.numbers["marker"] = {static_cast<double>(marker.marker)};
  entry.numbers["marker_size"] = {marker.size};
  return entry;
}

config::SensorEntry with(config::SensorEntry entry, const LookForColour& blob) {
  check_pair("hue", blob.hue, 360, "degrees");
  check_pair("saturation", blob.saturation, 1, "");
  check_pair("value", blob.value, 1, "");
  check_configured("LookForColour", "min_area", blob.min_area, 1, 1e9, "px");
  for (const double x : blob.plane) check_configured("LookForColour", "plane", x, -kMostDistance, kMostDistance, "m");
  for (const double x : blob.plane_normal) check_configured("LookForColour", "plane_normal", x, -1, 1, "");
  entry.texts["detect"] = "blob";
  entry.numbers["hue"] = {blob.hue.x(), blob.hue.y()};
  entry.numbers["saturation"] = {blob.saturation.x(), blob.saturation.y()};
  entry.numbers["value"] = {blob.value.x(), blob.value.y()};
  entry.numbers["min_area"] = {blob.min_area};
  entry.numbers["plane"] = list(blob.plane);
  entry.numbers["plane_normal"] = list(blob.plane_normal);
  return entry;
}

cv::Rect part_of(const Intrinsics& picture, const Region& region) {
  if (region.width == 0 && region.height == 0) return {0, 0, picture.width, picture.height};
  check_configured("Region", "u", region.u, 0, picture.width - kLeastRegion, "px");
  check_configured("Region", "v", region.v, 0, picture.height - kLeastRegion, "px");
  check_configured("Region", "width", region.width, kLeastRegion, picture.width - region.u, "px");
  check_configured("Region", "height", region.height, kLeastRegion, picture.height - region.v, "px");
  return {region.u, region.v, region.width, region.height};
}

Intrinsics cropped(Intrinsics picture, const cv::Rect& part) noexcept {
  picture.width = part.width;
  picture.height = part.height;
  picture.cx -= part.x;
  picture.cy -= part.y;
  return picture;
}

}  // namespace mrroc::vsp
