#pragma once

#include <memory>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Yields a robot to other programs: while it runs, the robot follows the joint trajectories that the operator, or a
/// node of ROS 2 through mrroc_ros2, sends, and holds between them.
///
///     Move({arm}, {}, External{arm});                                // until the operator ends the motion
///     Move({arm}, {button}, External{arm}.until(pressed(button)));  // or a condition of the task
///
/// Between its points a trajectory is a polynomial of each axis: of degree five where accelerations are given, of
/// degree three where velocities are, and a monotone one of degree three through positions alone (Fritsch and Carlson,
/// SIAM J. Numer. Anal. 17, 1980). It begins at the robot's desired state, from which the first piece leads to the
/// first point. Where it keeps the robot's limits it is commanded exactly. Where it does not (a jump of velocity or of
/// acceleration) the robot stays behind or beside it as little as the limits allow, as `Tracker` does; the path
/// tolerance judges that.
///
/// A trajectory is refused, and the one before continues, when a point is outside the limits, when the mean velocity
/// between two points exceeds them, when its end moves, or when it begins at time 0 and farther than kStart from the
/// robot. Another trajectory replaces the one before in motion. `cancel`, a pause, and a measured position beyond the
/// path tolerance bring the robot to rest on the trajectory, in its own time; after a pause it continues there. The
/// operator's speed scales the whole. The generator ends by `until` or by the operator alone; what is under way then is
/// reported as taken back, and the robot comes to rest as after any Move.
///
/// Task's thread. The constructor allocates room for two trajectories; a step allocates nothing.
class External : public Generator {
 public:
  static constexpr double kStart = 0.01;  ///< rad or m

  explicit External(Robot& robot);
  ~External() override;
  External(External&&) noexcept;
  External& operator=(External&&) noexcept;

  void start() override;
  void resume() override;
  bool brake() override;
  void next_state() override;
  void finish() noexcept override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mrroc
