#pragma once

#include <string>
#include <vector>

#include "sim/model.hpp"
#include "sim/offscreen.hpp"
#include "sim/picture.hpp"

namespace mrroc::sim {

/// Pictures of a world's states through its named cameras, with 4 samples per pixel and shadows. A frame of 640 x 480
/// takes some 30 ms of two cores: for a process of its own, never for the one that steps the world. Construct, use and
/// destroy in one thread.
class Renderer {
 public:
  /// `model` stays the caller's and must outlive this object; its off-screen size and quality are set. Throws
  /// SystemError (resources) without OpenGL.
  Renderer(mjModel& model, int width, int height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The world with generalized positions `positions` seen by camera `camera`; empty: MuJoCo's free camera, which sees
  /// it whole. Throws config::ConfigurationError: no such camera (it lists those that exist), or `positions` belong to
  /// another world.
  Picture render(const std::vector<double>& positions, const std::string& camera);

 private:
  mjModel& model_;
  Data data_;
  OffscreenContext opengl_;
  mjvScene scene_{};
  mjrContext context_{};
  int width_, height_;
};

}  // namespace mrroc::sim
