#include "sensors/camera/pictures/played_video.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace mrroc::vsp {

namespace {

/// Tolerance, so that rounding does not miss the tick at which a picture begins.
constexpr double kRounding = 1e-9;

}  // namespace

PlayedVideo::PlayedVideo(std::unique_ptr<cv::VideoCapture> video, HardwareCamera camera, double servo_period,
                         cv::Mat& picture)
    : video_(std::move(video)),
      camera_(std::move(camera)),
      pictures_per_tick_(servo_period * video_->get(cv::CAP_PROP_FPS)),
      picture_(&picture) {}

SourceState PlayedVideo::read(Tick wanted, RawReading& raw) noexcept {
  const double number = std::floor(static_cast<double>(wanted) * pictures_per_tick_ + kRounding);
  try {
    ended_ = ended_ || !show(static_cast<std::int64_t>(number));
  } catch (const std::exception&) {  // broken video
    ended_ = true;
  }
  if (ended_) return SourceState::silent;
  raw.tick = static_cast<Tick>(std::ceil(number / pictures_per_tick_ - kRounding));
  raw.count = 1;
  raw.values[0] = number;
  return SourceState::ready;
}

bool PlayedVideo::show(std::int64_t number) {
  if (shown_ >= number) return true;
  for (; shown_ < number; ++shown_)
    if (!video_->grab()) return false;
  if (!video_->retrieve(decoded_) || decoded_.empty()) return false;
  cv::cvtColor(decoded_, *picture_, cv::COLOR_BGR2RGB);
  return true;
}

}  // namespace mrroc::vsp
