#pragma once

namespace mrroc::sim {

/// An OpenGL context without display or window (EGL, surfaceless), current in the thread that made it, for MuJoCo's
/// renderer. Software rendering (llvmpipe) is enough; it uses every core it finds, so keep it out of the
/// process that steps the world. Construct, use and destroy it in one thread.
class OffscreenContext {
 public:
  /// Throws SystemError (resources) naming the EGL call that failed.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace mrroc::sim
