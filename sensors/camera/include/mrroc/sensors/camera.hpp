#pragma once

#include <limits>
#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/sensors/camera_configuration.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// A camera of the deployment, type `camera`, that finds one object: a blob of a colour on a known plane, or an
/// ArUco marker. Task's thread.
///
/// Poses are in one frame, the deployment's key `frame`: the base frame of the robot that carries the camera
/// (eye-in-hand) or the world's (fixed) when it is left out; else "world", "camera" or the base frame of a robot that
/// it names. The camera frame has its origin in the centre of projection, z along the view, x to the right and y down
/// in the picture.
///
///   blob    position: centroid of the blob's outline on the plane; z of the pose is the plane's normal (the side that
///           the camera sees), x the direction of the blob's greatest extent, of its two the one nearer to the frame's
///           x axis: rotations by 180 degrees are indistinguishable.
///   marker  position: its middle; x to the marker's right, y to its top, z out of it.
///
/// What it finds, and where in the picture, a running task may change: `camera.configure(LookFor{7, 0.04})`
/// (camera_configuration.hpp). Finding nothing is not an error: detected() is false, and the other values are NaN.
class Camera : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  Camera(Task& task, const std::string& name);

  /// Whether the object is detected; false before the first reading.
  bool detected() const noexcept { return value(0) > 0.5; }
  Pose pose() const noexcept;
  Eigen::Vector3d position() const noexcept;  ///< m
  /// Standard deviations of the position along the frame's axes, m, from the picture's resolution. Errors of the
  /// camera's own pose and of the plane are not included.
  Eigen::Vector3d position_deviation() const noexcept;
  /// Of the orientation, rad: about the plane's normal (blob, pi/2 when it is round), about the worst axis (marker).
  double rotation_deviation() const noexcept { return seen(11); }
  /// Where the position is in the picture, px; the middle of the upper left pixel is (0, 0).
  Eigen::Vector2d pixel() const noexcept { return {seen(12), seen(13)}; }
  /// Root mean square distance of the marker's corners in the picture from those of the pose, px; 0 for a blob.
  double reprojection_error() const noexcept { return seen(14); }
  double area() const noexcept { return seen(15); }  ///< of the blob on the plane, of the marker; m^2

 private:
  double seen(std::size_t channel) const noexcept {
    return detected() ? value(channel) : std::numeric_limits<double>::quiet_NaN();
  }
};

/// The camera sees its object.
class Seen : public Condition {
 public:
  explicit Seen(const Camera& camera);
  /// And its position is accurate: no standard deviation of the position is above `metres`. Throws
  /// NonFatalError(invalid_argument) unless `metres` is above 0.
  Seen(const Camera& camera, double metres);

 protected:
  bool holds() override;

 private:
  const Camera* camera_;
  double metres_ = std::numeric_limits<double>::infinity();
};

}  // namespace mrroc
