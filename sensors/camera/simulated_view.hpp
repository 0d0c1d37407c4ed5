#pragma once

#include "config/deployment.hpp"
#include "sensors/camera/camera_mount.hpp"
#include "sim/rendering/camera.hpp"

namespace mrroc::vsp {

/// The view of a simulated camera: its place in the world's model, and the size of its pictures.
struct SimulatedView {
  /// The options of its pictures: a picture takes half of the time without shadows.
  static constexpr sim::PictureQuality kQuality{.samples = 4, .shadows = false};

  CameraMount camera;
  int width = 0, height = 0;  ///< px
  double field_of_view = 0;   ///< of the picture's height, rad

  /// Draws the state that `renderer` has placed, without the camera's noise. `renderer` draws the model that `view_of`
  /// has received; its size is at least this view's. The same state gives the same picture, bit for bit, on one
  /// machine.
  void draw(sim::Renderer& renderer, sim::Picture& picture) const;
};

/// Throws SystemError(configuration) as `find_camera`, for keys of a camera of hardware, and without a field of view.
SimulatedView view_of(const mjModel& model, const config::SensorEntry& entry);

}  // namespace mrroc::vsp
