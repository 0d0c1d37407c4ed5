#pragma once

#include <string>
#include <vector>

#include "mrroc/types.hpp"
#include "sim/rendering/offscreen.hpp"
#include "sim/rendering/picture.hpp"
#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The quality of a picture: a frame of 640 x 480 takes some 30 ms of two cores with all options, half of that without
/// shadows.
struct PictureQuality {
  int samples = 4;  ///< per pixel
  bool shadows = true;
};

/// A pinhole camera without distortion, its principal point in the middle of the picture.
struct Viewpoint {
  Pose pose = Pose::Identity();  ///< in the world; it looks along -z, the picture's upper side is towards +y
  double field_of_view = 0;      ///< of the picture's height, rad
};

/// Names of the cameras of `model`.
std::vector<std::string> camera_names(const mjModel& model);

/// Pictures of a world's states. For a separate process, never for the one that steps the world. Construct, use and
/// destroy in one thread.
class Renderer {
 public:
  /// The caller owns `model`, which must outlive this object; its off-screen size and quality are set. Throws
  /// SystemError (resources) without OpenGL.
  Renderer(mjModel& model, int width, int height, PictureQuality quality = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The world with generalized positions `positions` seen by camera `camera`; empty: MuJoCo's free camera, which sees
  /// it whole. Throws config::ConfigurationError: no such camera (it lists those that exist), or `positions` belong to
  /// another world.
  Picture render(const std::vector<double>& positions, const std::string& camera);

  /// Sets the state for `body_pose` and `draw`; returns false and does nothing when it is another world's.
  bool place(const world::WorldSnapshot& snapshot);
  /// Of body `body` in the world.
  Pose body_pose(int body) const;
  /// Whether lights cast shadows from now on; at first as `quality` has it.
  void use_shadows(bool shadows) noexcept { scene_.flags[mjRND_SHADOW] = shadows ? 1 : 0; }
  /// The placed state seen from `view`, into `picture`, which it allocates the first time; of `width` x `height`
  /// pixels, at most the size given at construction.
  void draw(const Viewpoint& view, int width, int height, Picture& picture);

 private:
  void update_poses();
  void update_scene(mjvCamera camera);
  void draw_scene(int width, int height, Picture& picture);

  mjModel& model_;
  Data data_;
  OffscreenContext opengl_;
  mjvScene scene_{};
  mjrContext context_{};
  int width_, height_;
};

}  // namespace mrroc::sim
