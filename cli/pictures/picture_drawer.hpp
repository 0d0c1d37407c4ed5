#pragma once

#include <optional>
#include <string>

#include "cli/pictures/camera_views.hpp"
#include "mrroc/types.hpp"
#include "sim/rendering/camera.hpp"
#include "sim/rendering/picture.hpp"

namespace mrroc::cli {

/// What a camera sees in one state of the world.
struct DrawnPicture {
  Tick tick = 0;                   ///< of that state
  Pose camera = Pose::Identity();  ///< in the world: z along the view, x right, y down
  sim::Picture pixels;             ///< empty: `reason`
  std::string reason;              ///< why there is no picture
};

/// Draws the pictures of a deployment's simulated cameras from the run's events "world": the same picture as the
/// camera's own process draws, without its noise. One renderer for all cameras, as large as the largest picture.
/// Construct, use and destroy in one thread, whose priority and that of OpenGL's threads is low: the run comes first.
class PictureDrawer {
 public:
  /// `views` outlives it and has at least one view.
  explicit PictureDrawer(const CameraViews& views);

  /// Never throws: what goes wrong is the reason.
  DrawnPicture draw(const vsp::SimulatedView& view, const std::string& event) noexcept;

 private:
  std::optional<sim::Renderer> renderer_;
  std::string problem_;
};

}  // namespace mrroc::cli
