#pragma once

#include <optional>

#include "language/servoing/twist_follower.hpp"
#include "mrroc/generators/servo_limits.hpp"

namespace mrroc {

/// Common part of the visual servos: the tool smoothly follows a desired twist in tool axes, scaled as a whole to the
/// limits; without a twist (the target is lost) the tool comes to rest.
class VisualServo {
 public:
  /// `name` of the generator, for messages. Throws NonFatalError(invalid_argument).
  VisualServo(Robot& robot, const ServoLimits& limits, const char* name);

  void start();
  /// Writes the command. Throws NonFatalError(sensor_not_ready) after `patience` consecutive steps without a twist.
  void step(const std::optional<Twist>& wanted);

  const Pose& pose() const noexcept { return follower_.pose(); }
  bool at_rest() const noexcept { return follower_.at_rest(); }
  double gain() const noexcept { return limits_.gain; }

 private:
  Robot* robot_;
  ServoLimits limits_;
  const char* name_;
  TwistFollower follower_;
  int lost_ = 0;
};

}  // namespace mrroc
