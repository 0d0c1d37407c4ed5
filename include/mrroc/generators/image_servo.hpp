#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/generators/servo_limits.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class VisualServo;

/// Maximum number of point features of an image servo: the channels of one reading hold as many.
inline constexpr int kMaxImagePoints = 8;

/// Points of an image, one per column, in normalised coordinates: x = X / Z, y = Y / Z of the point (X, Y, Z) in camera
/// axes, x to the right, y down, z ahead; from pixels: x = (u - c_u) / f_u, y = (v - c_v) / f_v. Inline storage.
using ImagePoints = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, kMaxImagePoints>;

/// Depths Z of the points, m. Inline storage.
using ImageDepths = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxImagePoints>;

/// Interaction matrix of a point, ds/dt = L v_c with s = (x, y) and v_c the camera's twist in camera axes (Chaumette
/// and Hutchinson, Visual servo control I, IEEE Robotics and Automation Magazine 13(4), 2006, eq. (11)):
///
///   L = [ -1/Z   0    x/Z   x y    -(1 + x^2)   y ]
///       [  0    -1/Z  y/Z  1 + y^2   -x y      -x ]
Eigen::Matrix<double, 2, 6> point_interaction(double x, double y, double depth) noexcept;

/// Image-based visual servo of a camera that the tool carries: moves until the points of a target at rest have their
/// desired positions in the image,
///
///   v_c = -lambda L^+ (s - s*),
///
/// with L of the points as measured now and of the given depths, and L^+ its pseudo-inverse. The camera's twist is
/// transformed to the twist of the tool frame: with R, p the camera's pose in it, w = R w_c, v = R v_c - w x p; it is
/// scaled down as a whole to the limits. Four or more points determine the pose; three have up to four solutions and
/// singular ones. Wrong depths change the path but not the final pose; from far away the path may lead points out of
/// the image.
///
/// Ends on its own when every point is within `tolerance` of its desired position and the motion is at rest.
///
/// When the target is lost (the function returns nothing), the tool comes to rest smoothly; it continues with the next
/// measurement. After `patience` consecutive steps without the target NonFatalError(sensor_not_ready) is thrown.
class ImageServo : public Generator {
 public:
  /// The measured points, in the order of the desired ones; nothing while they are not visible. Called once per step,
  /// must not allocate.
  using Points = std::function<std::optional<ImagePoints>()>;

  /// `wanted`: s*; `depths`: an estimate of Z of each point, ideally at its desired position; `camera`: the camera
  /// frame in the tool frame; `tolerance` in normalised coordinates. Throws NonFatalError(invalid_argument) for invalid
  /// limits, other than 3..8 points, depths that are not above 0 or not as many as points, no function.
  ImageServo(Robot& robot, Points points, const ImagePoints& wanted, const ImageDepths& depths,
             const Pose& camera = Pose::Identity(), const ServoLimits& limits = {}, double tolerance = 2e-3);
  ~ImageServo() override;
  ImageServo(ImageServo&&) noexcept;
  ImageServo& operator=(ImageServo&&) noexcept;

  void start() override;
  bool terminal_condition() override;
  /// Throws NonFatalError(invalid_argument) when the number of points differs from that of the desired ones.
  void next_state() override;
  /// The part that the camera sees may move.
  bool scales_with_speed() const override { return false; }

  /// The largest distance of a point from its desired position in the last step, in normalised coordinates; NaN when
  /// the points are not visible.
  double error() const noexcept;

 private:
  Points points_;
  ImagePoints wanted_;
  ImageDepths depths_;
  Pose camera_;
  double tolerance_;
  std::unique_ptr<VisualServo> servo_;
  std::optional<ImagePoints> seen_;  ///< of this step
};

}  // namespace mrroc
