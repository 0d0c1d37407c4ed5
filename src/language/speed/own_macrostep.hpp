#pragma once

#include "language/limit_check.hpp"
#include "language/macrostep/macrostep_goal.hpp"
#include "language/speed/speed_ramp.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// One macrostep of one robot in its generator's own time: the path on which the EDP would execute the command that the
/// generator has written, and the commands that follow it piece by piece in the time of the clock. Times t are own
/// seconds since its start. Task's thread; allocates nothing but in its constructor, never throws.
class OwnMacrostep {
 public:
  /// Of which kind a command is, as far as the operator's speed is concerned.
  enum class Kind : std::uint8_t {
    none,       ///< nothing has been taken
    path,       ///< leads to a state
    velocity,   ///< keeps a velocity
    real_time,  ///< a hold, or a force law: executed as commanded
    refused     ///< the EDP will refuse it, or the robot is not synchronised
  };

  explicit OwnMacrostep(Robot& robot);

  /// The robot's state shows the desired values at the end of this macrostep in own time, until `hide`; `scale` is that
  /// of the robot's motion.
  void show(TimeScale scale) noexcept;
  void hide() noexcept;
  /// The robot's motion is no longer that of this macrostep.
  void forget() noexcept { kind_ = Kind::none; }

  /// Takes the robot's command, which continues from the state that was shown last.
  void take(TimeScale scale) noexcept;
  Kind kind() const noexcept { return kind_; }
  Robot& robot() const noexcept { return *robot_; }
  std::uint16_t steps() const noexcept { return command_.motion_steps; }
  /// Leaves the scale of the robot's motion with the robot, for its next Move.
  void remember(TimeScale scale) noexcept;
  bool ends_at_rest() const noexcept { return kind_ == Kind::path && end_.at_rest(); }
  /// The path between the pieces' ends is that of the tool or of the motors, which joints follow in short pieces only.
  bool needs_short_pieces() const noexcept {
    return kind_ == Kind::path && path_.space() != MacrostepPath::Space::joints;
  }

  /// Commands the piece that ends at t = `time`, in `ticks`; `first`: it is the macrostep's first one.
  void command(double time, TimeScale scale, std::uint16_t ticks, bool first) noexcept;
  /// Bounds under which the change of the speed alone takes most of the acceleration and jerk limits.
  RampBounds halt_bounds(TimeScale scale) const noexcept;
  /// The largest part of an acceleration or jerk limit that this piece would take; above 1 also where its EDP would
  /// refuse the piece for another reason.
  double load(double time, TimeScale scale, std::uint16_t ticks) noexcept;

 private:
  /// The desired state at the end of this macrostep.
  DesiredState own_state(TimeScale scale) const noexcept;
  DesiredState unscaled(TimeScale scale) const noexcept;
  DesiredState piece_end(double time, TimeScale scale) const noexcept;
  double period() const noexcept;

  Robot* robot_;
  LimitCheck limits_;
  Kind kind_ = Kind::none;
  RobotCommand command_;
  MacrostepGoal goal_;
  MacrostepPath path_;
  DesiredState from_, end_;  ///< own time
  DesiredState hidden_;
  Pose hidden_pose_ = Pose::Identity();
};

}  // namespace mrroc
