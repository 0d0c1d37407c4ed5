#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/generators/servo_limits.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class VisualServo;

/// Position-based visual servo: moves the tool until a measured target has a desired pose in the tool frame. With M the
/// measured and M* the desired pose of the target in the tool frame, the goal of the tool is
///
///   T* = T_measured M M*^-1,
///
/// and the twist in tool axes is xi = lambda (t, theta u), t and theta u the translation and rotation vector of
/// T_desired^-1 T*, scaled down as a whole to the limits: the tool moves straight and rotates about one axis (Chaumette
/// and Hutchinson, Visual servo control I, IEEE Robotics and Automation Magazine 13(4), 2006, section on PBVS).
/// T_desired is the pose at the end of the commanded motion, so that a reading's delay and a drive's lag cause no
/// overshoot if the target rests and the reading belongs to the tick of the robot's state.
///
/// Ends on its own when t and theta are within the tolerances and the motion is at rest.
///
/// When the target is lost (the function returns nothing), the tool comes to rest smoothly; it continues with the next
/// measurement. After `patience` consecutive steps without the target NonFatalError(sensor_not_ready) is thrown.
class PositionServo : public Generator {
 public:
  /// The target's pose; nothing while it is not visible. Called once per step, must not allocate.
  using Target = std::function<std::optional<Pose>()>;
  /// The frame in which the target's pose is measured.
  enum class In {
    camera,  ///< a camera that the tool carries
    base     ///< the robot's base frame, as by a camera fixed in the world
  };

  /// `wanted`: M*, the target in the tool frame. `camera`: the camera frame in the tool frame, for In::camera. Throws
  /// NonFatalError(invalid_argument) for invalid limits, poses that are not rigid, no function.
  PositionServo(Robot& robot, Target target, In in, const Pose& wanted, const Pose& camera = Pose::Identity(),
                const ServoLimits& limits = {}, double tolerance = 1e-3, double angular_tolerance = 5e-3);
  ~PositionServo() override;
  PositionServo(PositionServo&&) noexcept;
  PositionServo& operator=(PositionServo&&) noexcept;

  void start() override;
  bool terminal_condition() override;
  void next_state() override;
  /// The part that the sensor sees may move.
  bool scales_with_speed() const override { return false; }

 private:
  bool reached() const noexcept;

  Target target_;
  In in_;
  Pose camera_, unwanted_;  ///< M*^-1
  double tolerance_, angular_tolerance_;
  Robot* robot_;
  std::unique_ptr<VisualServo> servo_;
  std::optional<Twist> error_;  ///< (t, theta u) of this step
};

}  // namespace mrroc
