#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "mrroc/sensors/camera_configuration.hpp"
#include "sensors/camera/debug_view.hpp"
#include "sensors/camera/detection/detection.hpp"
#include "sensors/camera/pictures/picture_source.hpp"
#include "sensors/camera/reading_frame.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// A camera that finds one object, a blob of a colour on a known plane (`BlobDetector`) or an ArUco marker
/// (`MarkerDetector`). r is one picture; v, in the frame F of `ReadingFrame`, with C the camera's pose in F and (p, R,
/// S) what was found in the camera frame, its covariance S:
///
///     detected                       1, or 0 and all other channels 0
///     x y z                          C p
///     qw qx qy qz                    C R, qw >= 0
///     deviation_x ... _z             square roots of the diagonal of R_C S R_C^T
///     deviation_rotation             rad
///     u v                            of p in the picture, px
///     reprojection_error             px
///     area                           m^2
///
/// An eye-in-hand camera's C is flange * mount, with the flange from e_l at the picture's tick (pose * tool^-1).
/// Errors: the robot's pose is unknown, NonFatalError(sensor_not_ready); the camera has moved to where it cannot see
/// the plane, NonFatalError(sensor_out_of_range). It has no zero to set.
///
/// The picture of a reading of hardware is in `SourceContext::pictures`. Unlike other sensors it allocates while it
/// aggregates, as OpenCV does, and with `debug` writes files.
class CameraSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  std::unique_ptr<Source> open_source(const SourceContext& context) override;
  void effector_state(const RobotState& e) noexcept override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  /// `LookFor`, `LookForColour`, `Region`, `Exposure` (mrroc/sensors/camera_configuration.hpp).
  void reconfigure(const Message& configuration) override;

 private:
  void show(const RawReading& r) noexcept;
  void detect(SensorReading& v);
  void look_for(config::SensorEntry entry);
  void check_view(const Detector& detector, const config::SensorEntry& entry) const;
  void apply(const LookFor& marker);
  void apply(const LookForColour& blob);
  void apply(const Region& region);
  void apply(const Exposure& exposure);

  config::SensorEntry entry_;
  std::unique_ptr<Detector> detector_;
  PictureSource* source_ = nullptr;
  process::PictureMemory* shown_ = nullptr;  ///< of a camera of hardware
  double shown_number_ = -1;                 ///< of the picture in it
  cv::Rect part_;                            ///< of the picture, that is searched
  cv::Mat picture_;
  Intrinsics intrinsics_;
  ReadingFrame frame_;
  std::optional<Pose> flange_;  ///< in the robot's base frame
  std::optional<DebugView> debug_;
};

}  // namespace mrroc::vsp
