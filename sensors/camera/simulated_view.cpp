#include "sensors/camera/simulated_view.hpp"

#include <utility>

#include "sensors/camera/keys.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

void refuse_keys_of_hardware(const config::SensorEntry& entry) {
  const char* expected = "source = 'hardware' beside it";
  if (!text(entry, "device").empty()) refuse(entry, "device", "\"" + text(entry, "device") + "\"", expected);
  for (const auto& [key, size] : {std::pair{"intrinsics", 4}, {"distortion", 5}}) {
    if (optional_numbers(entry, key, static_cast<std::size_t>(size)))
      refuse(entry, key, "of a simulated camera", expected);
  }
}

double field_of_view(const config::SensorEntry& entry, const CameraMount& camera) {
  const double given = number(entry, "field_of_view");
  if (given > 0) return given;
  if (camera.field_of_view > 0) return camera.field_of_view;
  refuse(entry, "field_of_view", "0", "that of the picture's height, rad: the MJCF has no camera that gives it");
}

}  // namespace

void SimulatedView::draw(sim::Renderer& renderer, sim::Picture& picture) const {
  sim::Viewpoint view{renderer.body_pose(camera.body) * camera.in_body, field_of_view};
  view.pose.linear() *= Eigen::Vector3d(1, -1, -1).asDiagonal();
  renderer.draw(view, width, height, picture);
}

SimulatedView view_of(const mjModel& model, const config::SensorEntry& entry) {
  SimulatedView view;
  view.camera = find_camera(model, entry);
  view.width = whole(entry, "width");
  view.height = whole(entry, "height");
  view.field_of_view = field_of_view(entry, view.camera);
  refuse_keys_of_hardware(entry);
  return view;
}

}  // namespace mrroc::vsp
