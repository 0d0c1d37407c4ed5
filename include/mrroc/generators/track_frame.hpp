#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/moving_frame.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// A pose of the tool in a moving frame, and its dwell time there.
struct FramePoint {
  Pose pose = Pose::Identity();  ///< of the tool frame in the moving frame
  double dwell = 0;              ///< s; infinity: until a condition of `.until(...)` holds
};

/// Limits of the motion relative to the frame, per axis of the frame; the jerk limits are 10 / s times the
/// accelerations. Each axis is planned separately: in a frame with an axis along the belt the tool catches up without
/// lateral motion.
struct FrameLimits {
  double speed = 0.2;                 ///< m/s
  double acceleration = 0.3;          ///< m/s^2
  double angular_speed = 0.5;         ///< rad/s
  double angular_acceleration = 1.0;  ///< rad/s^2
  double tolerance = 1e-3;            ///< m; a point is reached when the measured tool is this close to it
};

/// The tool catches up with a moving frame, for example a part on a conveyor, and moves along a path that is given in
/// that frame: its pose is F(t) X(t), commanded with twist and twist rate.
///
/// F is the frame as a sensor measures it, extrapolated from the reading's tick to the end of the macrostep and
/// smoothed (w = 10 / s: src/language/servoing/frame_observer.hpp): at constant velocity it is exact, at an
/// acceleration a it lags a / w^2. X starts at the tool's pose and velocity relative to the frame (for a tool at rest,
/// minus the frame's velocity), and leads to the first point and from point to point, at rest in each, time-optimal
/// under the limits (Ruckig).
///
/// Drives lag behind their set-points by some mm at conveyor speeds. To compensate, X is shifted by a correction c in
/// frame axes,
///   dc/dt = 4 / s (F X - measured tool position),  |c| <= 20 mm,
///
/// dc/dt itself through a low-pass of 60 ms. The dwell at a point begins when X has reached it and the measured tool is
/// within the tolerance. The motion ends on its own after the last dwell, *moving with the frame*: the next Move
/// continues from there; otherwise the EDP brakes.
///
/// While the reading is lost (the function returns nothing), the frame is extrapolated at constant velocity; after
/// `patience` consecutive steps NonFatalError(sensor_not_ready) is thrown. The EDP checks the joint limits: it refuses
/// a motion that is too fast, and the Move throws.
class TrackFrame : public Generator {
 public:
  /// The frame in the robot's base frame; nothing while it is unknown. Called once per step, must not allocate.
  using Frame = std::function<std::optional<MovingFrame>()>;

  /// Throws NonFatalError: invalid_argument (no points, no function, a pose that is not rigid, an invalid limit, dwell
  /// time or timeout).
  TrackFrame(Robot& robot, Frame frame, std::vector<FramePoint> path, const FrameLimits& limits = {},
             int patience = 10);
  /// To one point, without dwell.
  TrackFrame(Robot& robot, Frame frame, const Pose& point, const FrameLimits& limits = {}, int patience = 10);
  ~TrackFrame() override;
  TrackFrame(TrackFrame&&) noexcept;
  TrackFrame& operator=(TrackFrame&&) noexcept;

  /// Continues with the interrupted point. Throws NonFatalError(sensor_not_ready) without a reading.
  void resume() override;
  void start() override;
  bool terminal_condition() override;
  void next_state() override;
  /// The frame moves in its own time.
  bool scales_with_speed() const override { return false; }

  /// Index of the current point; the number of points at the end.
  std::size_t point() const noexcept;
  /// Error of the last step: from the measured tool to its desired position, F X, in frame axes, m.
  const Eigen::Vector3d& error() const noexcept;

 private:
  struct Plan;
  Robot* robot_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace mrroc
