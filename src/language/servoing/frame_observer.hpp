#pragma once

#include "mrroc/moving_frame.hpp"

namespace mrroc {

/// A smooth estimate of a moving frame, whose readings may jump: in each macrostep its acceleration changes linearly to
///   a = w^2 (measured - estimated position) + 2 w (measured - estimated velocity),   w = 10 / s
/// (less for macrosteps longer than 20 ms: 0.2 / duration), the same for rotation vectors. Constant velocity is
/// followed without error, constant acceleration with a / w^2. Task's thread; never allocates or throws.
class FrameObserver {
 public:
  /// The estimate is the measurement.
  void start(const MovingFrame& measured) noexcept;
  /// Chooses the acceleration of the coming macrostep of `duration` s from the measurement at its start.
  void correct(const MovingFrame& measured, double duration) noexcept;
  /// Without a measurement: continues at a constant velocity from the end of the macrostep on.
  void coast(double duration) noexcept { jerk_ = -rate_ / duration; }

  /// The frame `t` s after the macrostep's start.
  MovingFrame at(double t) const noexcept;
  /// Call at the end of the macrostep of `duration` s.
  void advance(double duration) noexcept {
    estimate_ = at(duration);
    rate_ += duration * jerk_;
  }

 private:
  MovingFrame estimate_;        ///< at the macrostep's start
  Twist rate_ = Twist::Zero();  ///< of its twist, there
  Twist jerk_ = Twist::Zero();  ///< of its rate, in the macrostep
};

}  // namespace mrroc
