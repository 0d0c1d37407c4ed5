#pragma once

#include <opencv2/core/mat.hpp>

#include "mrroc/types.hpp"
#include "sensors/camera/intrinsics.hpp"
#include "vsp/configuration.hpp"
#include "vsp/source.hpp"

namespace mrroc::vsp {

/// A source of pictures. `read` stores the picture of `raw.tick` in the matrix given at construction, 8-bit
/// RGB; r itself is the count of pictures. Unlike other sources it takes milliseconds and allocates.
class PictureSource : public Source {
 public:
  virtual const Intrinsics& intrinsics() const noexcept = 0;
  /// Of the camera (z along the view, x right, y down) in the flange frame of the robot that carries it, or in the
  /// world.
  virtual const Pose& mount() const noexcept = 0;
  /// Exposes every picture for `seconds` from now on; the next `read` returns none from before. Throws
  /// NonFatalError(invalid_argument) unless the source is a camera of hardware, HardwareError when that refuses.
  virtual void expose(double seconds) {
    refuse_configuration("Exposure", "seconds", seconds, "none: only a camera of hardware is exposed");
  }
};

}  // namespace mrroc::vsp
