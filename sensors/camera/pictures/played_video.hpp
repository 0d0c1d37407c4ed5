#pragma once

#include <memory>
#include <opencv2/videoio.hpp>

#include "sensors/camera/pictures/hardware_camera.hpp"

namespace mrroc::vsp {

/// A video file played in the deployment's time, the same under every clock and on every run: at tick k, of servo
/// period T, picture number floor(k T fps), as of the first tick that shows it. Silent after the last picture.
class PlayedVideo final : public PictureSource {
 public:
  PlayedVideo(std::unique_ptr<cv::VideoCapture> video, HardwareCamera camera, double servo_period, cv::Mat& picture);

  SourceState read(Tick wanted, RawReading& raw) noexcept override;
  const Intrinsics& intrinsics() const noexcept override { return camera_.intrinsics; }
  const Pose& mount() const noexcept override { return camera_.mount; }

 private:
  bool show(std::int64_t number);

  std::unique_ptr<cv::VideoCapture> video_;
  HardwareCamera camera_;
  double pictures_per_tick_;
  cv::Mat decoded_;
  cv::Mat* picture_;
  std::int64_t shown_ = -1;
  bool ended_ = false;
};

}  // namespace mrroc::vsp
